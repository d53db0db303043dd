#include "gr2to/grid/CriticalPoints.h"

#include <algorithm>
#include <limits>

namespace gr2to
{
namespace
{
/** Finds valleys of the clearance, edge by edge, looking beyond an edge's ends where its own rise does not
 * decide. */
class ValleyFinder
{
 public:
    ValleyFinder(const VoronoiGraph& voronoi, const DistanceMap& distances, double minRise)
        : m_voronoi(voronoi), m_distances(distances), m_minRise(minRise), m_edgesAt(voronoi.nodes.size())
    {
        for (std::size_t e = 0; e < voronoi.edges.size(); ++e) {
            m_edgesAt[voronoi.edges[e].from].push_back(e);
            if (voronoi.edges[e].to != voronoi.edges[e].from) m_edgesAt[voronoi.edges[e].to].push_back(e);
        }
    }

    void findOn(std::size_t edgeIndex)
    {
        const VoronoiEdge& edge = m_voronoi.edges[edgeIndex];
        Valley valley;
        double highest = -std::numeric_limits<double>::infinity();  // since the last valley
        bool descending = true, first = true;
        for (std::size_t k = 0; k < edge.cells.size(); ++k) {
            const double v = m_distances.clearance_cells(edge.cells[k]);
            highest = std::max(highest, v);
            if (descending) {
                const double before = k == 0 ? v : highest;
                valley.extend(k, v, before);
                if (v < valley.clearance + m_minRise) continue;
                if (!first || valley.before >= valley.clearance + m_minRise ||
                    climbs(edgeIndex, true, valley.clearance))
                    add(edge, valley);
                first = false;
                descending = false;
                highest = v;
            } else if (v <= highest - m_minRise) {
                valley = Valley();
                valley.extend(k, v, highest);
                descending = true;
            }
        }
        const bool leftRises = !first || valley.before >= valley.clearance + m_minRise ||
                               climbs(edgeIndex, true, valley.clearance);
        if (descending && leftRises && climbs(edgeIndex, false, valley.clearance)) add(edge, valley);
    }

    std::vector<CriticalPoint> take()
    {
        const auto raster = [](const CriticalPoint& a, const CriticalPoint& b) {
            return a.cell.y != b.cell.y ? a.cell.y < b.cell.y : a.cell.x < b.cell.x;
        };
        std::sort(m_points.begin(), m_points.end(), raster);
        const auto same = [](const CriticalPoint& a, const CriticalPoint& b) { return a.cell == b.cell; };
        m_points.erase(std::unique(m_points.begin(), m_points.end(), same), m_points.end());
        return std::move(m_points);
    }

 private:
    struct Valley
    {
        double clearance = std::numeric_limits<double>::infinity();
        double before = 0;  //!< highest clearance on the way down to it
        std::size_t firstCell = 0;
        std::size_t lastCell = 0;

        void extend(std::size_t k, double v, double highestSoFar)
        {
            if (v < clearance) {
                clearance = v;
                before = highestSoFar;
                firstCell = lastCell = k;
            } else if (v == clearance && k == lastCell + 1)
                lastCell = k;
        }
    };

    void add(const VoronoiEdge& edge, const Valley& valley)
    {
        m_points.push_back({edge.cells[(valley.firstCell + valley.lastCell) / 2], valley.clearance});
    }

    /** Whether the clearance rises enough beyond an end of an edge, without first falling below `level`.
     *
     * The way leads over other edges; beyond the end of a loop it also leads back into its other end.
     */
    bool climbs(std::size_t throughEdge, bool atFront, double level) const
    {
        const VoronoiEdge& through = m_voronoi.edges[throughEdge];
        const std::size_t node = atFront ? through.from : through.to;
        if (through.from == through.to && walk(through, !atFront, level) == Outcome::Rises) return true;
        std::vector<std::size_t> toVisit{node};
        std::vector<std::size_t> seen{throughEdge};
        while (!toVisit.empty()) {
            const std::size_t current = toVisit.back();
            toVisit.pop_back();
            for (const std::size_t e : m_edgesAt[current]) {
                if (std::find(seen.begin(), seen.end(), e) != seen.end()) continue;
                seen.push_back(e);
                const VoronoiEdge& edge = m_voronoi.edges[e];
                const bool forward = edge.from == current;
                const Outcome outcome = walk(edge, forward, level);
                if (outcome == Outcome::Rises) return true;
                if (outcome == Outcome::Level) toVisit.push_back(forward ? edge.to : edge.from);
            }
        }
        return false;
    }

    enum class Outcome
    {
        Rises,
        Falls,
        Level
    };

    Outcome walk(const VoronoiEdge& edge, bool forward, double level) const
    {
        for (std::size_t k = 0; k < edge.cells.size(); ++k) {
            const Cell c = edge.cells[forward ? k : edge.cells.size() - 1 - k];
            const double v = m_distances.clearance_cells(c);
            if (v < level) return Outcome::Falls;
            if (v >= level + m_minRise) return Outcome::Rises;
        }
        return Outcome::Level;
    }

    const VoronoiGraph& m_voronoi;
    const DistanceMap& m_distances;
    double m_minRise;
    std::vector<std::vector<std::size_t>> m_edgesAt;
    std::vector<CriticalPoint> m_points;
};
}  // namespace

std::vector<CriticalPoint> findCriticalPoints(const VoronoiGraph& voronoi, const DistanceMap& distances,
                                              double minRise_cells)
{
    ValleyFinder finder(voronoi, distances, minRise_cells);
    for (std::size_t e = 0; e < voronoi.edges.size(); ++e) finder.findOn(e);
    return finder.take();
}
}  // namespace gr2to
