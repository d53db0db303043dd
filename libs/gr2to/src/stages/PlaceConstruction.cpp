#include "gr2to/stages/PlaceConstruction.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "gr2to/grid/CriticalPoints.h"
#include "gr2to/grid/CurveCells.h"
#include "gr2to/grid/Jambs.h"

namespace gr2to
{
namespace
{
bool rasterLess(Cell a, Cell b)
{
    return a.y != b.y ? a.y < b.y : a.x < b.x;
}

/** Index of the narrowest critical point close to each candidate's cells; -1 where there is none. */
std::vector<int> supportOf(const std::vector<DoorCandidate>& candidates,
                           const std::vector<CriticalPoint>& points, double radius)
{
    const int side = std::max(1, static_cast<int>(std::ceil(radius)));
    const auto key = [](int x, int y) { return std::int64_t{y} * (std::int64_t{1} << 32) + x; };
    std::unordered_map<std::int64_t, std::vector<int>> buckets;
    for (std::size_t p = 0; p < points.size(); ++p)
        buckets[key(points[p].cell.x / side, points[p].cell.y / side)].push_back(static_cast<int>(p));
    std::vector<int> support(candidates.size(), -1);
    const auto consider = [&](int p, Cell likely, int& best) {
        const CriticalPoint& point = points[static_cast<std::size_t>(p)];
        if (distance_cells(point.cell, likely) > radius || p == best) return;
        if (best >= 0) {
            const double narrowest = points[static_cast<std::size_t>(best)].clearance_cells;
            if (point.clearance_cells > narrowest || (point.clearance_cells == narrowest && p > best)) return;
        }
        best = p;
    };
    for (std::size_t c = 0; c < candidates.size(); ++c)
        for (const Cell likely : candidates[c].cells)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    if (const auto at = buckets.find(key(likely.x / side + dx, likely.y / side + dy));
                        at != buckets.end())
                        for (const int p : at->second) consider(p, likely, support[c]);
    return support;
}

/** Eq. (9): walks from big circles to small and drops those that are close to a kept one with nothing
 * narrower between. */
std::vector<Circle> dropClose(const std::vector<Circle>& circles, const DistanceMap& distances)
{
    const double closeFactor = std::sqrt(2.0);
    CircleIndex kept(distances.width, distances.height);
    for (const Circle& circle : circles) {
        const auto nothingNarrower = [&](const Circle& bigger) {
            const Cell middle{(circle.center.x + bigger.center.x) / 2,
                              (circle.center.y + bigger.center.y) / 2};
            return distances.clearance_cells(middle) >= circle.radius_cells;
        };
        if (!kept.anyWithin(circle, closeFactor, nothingNarrower)) kept.add(circle);
    }
    return kept.circles();
}

/** Parts the diagram at its doors among circles, until every door parts two places. */
class DiagramDivider
{
 public:
    DiagramDivider(std::vector<ValidatedDoor> doors, const VoronoiGraph& voronoi, const ClassifiedGrid& grid,
                   Obstacles obstacles, const DistanceMap& distances, double minRadius)
        : m_curves(voronoi),
          m_grid(grid),
          m_obstacles(obstacles),
          m_distances(distances),
          m_minRadius(minRadius),
          m_blocked(m_curves.size())
    {
        m_graph.doors = std::move(doors);
    }

    PlaceGraph divide()
    {
        const std::vector<Circle> found = findCircles();
        do {
            m_graph.circles = found;
            blockDoors();
            addMissingCircles();
            m_graph.circleOfCell = m_curves.growCircles(m_graph.circles, m_blocked);
        } while (dropUselessDoors());
        linkAtOpenings();
        linkAtDoors();
        sortLinks();
        return std::move(m_graph);
    }

 private:
    /** Circles of all cells of the diagram, those of doors left out, thinned out by overlap and eq. (9). */
    std::vector<Circle> findCircles() const
    {
        std::vector<Circle> all;
        for (std::size_t i = 0; i < m_curves.size(); ++i)
            if (const double r = m_distances.clearance_cells(m_curves.cell(i)); r >= m_minRadius)
                all.push_back({m_curves.cell(i), r});
        std::stable_sort(all.begin(), all.end(),
                         [](const Circle& a, const Circle& b) { return a.radius_cells > b.radius_cells; });
        CircleIndex doorways(m_distances.width, m_distances.height);
        for (const ValidatedDoor& door : m_graph.doors)
            doorways.add({door.critical.cell, door.critical.clearance_cells});
        std::vector<Circle> circles = dropOverlapping(all, m_distances.width, m_distances.height);
        const auto liesInDoorway = [&](const Circle& circle) {
            return doorways.anyWithin(circle, 1.0, [&](const Circle& doorway) {
                return distance_cells(circle.center, doorway.center) < doorway.radius_cells;
            });
        };
        circles.erase(std::remove_if(circles.begin(), circles.end(), liesInDoorway), circles.end());
        return dropClose(circles, m_distances);
    }

    void blockDoors()
    {
        m_blocked.assign(m_curves.size(), false);
        for (const ValidatedDoor& door : m_graph.doors)
            for (const Cell c : door.line)
                if (const int i = m_curves.find(c); i >= 0) m_blocked[static_cast<std::size_t>(i)] = true;
    }

    /** A part without a circle gets the one of its widest cell when that is wide enough for a place. */
    void addMissingCircles()
    {
        int parts = 0;
        const std::vector<int> partOf = m_curves.parts(m_blocked, &parts);
        std::vector<bool> hasCircle(static_cast<std::size_t>(parts), false);
        std::vector<Circle> widest(hasCircle.size());
        for (const Circle& circle : m_graph.circles)
            if (const int i = m_curves.find(circle.center);
                i >= 0 && partOf[static_cast<std::size_t>(i)] >= 0)
                hasCircle[static_cast<std::size_t>(partOf[static_cast<std::size_t>(i)])] = true;
        for (std::size_t i = 0; i < m_curves.size(); ++i) {
            if (partOf[i] < 0) continue;
            Circle& best = widest[static_cast<std::size_t>(partOf[i])];
            const double r = m_distances.clearance_cells(m_curves.cell(i));
            if (r > best.radius_cells) best = {m_curves.cell(i), r};
        }
        for (std::size_t p = 0; p < widest.size(); ++p)
            if (!hasCircle[p] && widest[p].radius_cells >= m_minRadius) m_graph.circles.push_back(widest[p]);
        std::sort(m_graph.circles.begin(), m_graph.circles.end(),
                  [](const Circle& a, const Circle& b) { return rasterLess(a.center, b.center); });
    }

    /** Circles on the sides of a door, in order; -1 among them when a side leads to a pocket without a place.
     */
    std::set<int> sidesOf(const ValidatedDoor& door) const
    {
        std::set<int> sides;
        for (const Cell c : door.line) {
            const int i = m_curves.find(c);
            if (i < 0) continue;
            for (const int n : m_curves.neighbours(static_cast<std::size_t>(i)))
                if (n >= 0 && !m_blocked[static_cast<std::size_t>(n)])
                    sides.insert(m_graph.circleOfCell[static_cast<std::size_t>(n)]);
        }
        return sides;
    }

    bool dropUselessDoors()
    {
        const auto isUseless = [&](const ValidatedDoor& door) {
            const std::set<int> sides = sidesOf(door);
            return sides.size() < 2 || *sides.begin() < 0;
        };
        const auto last = std::remove_if(m_graph.doors.begin(), m_graph.doors.end(), isUseless);
        const bool dropped = last != m_graph.doors.end();
        m_graph.doors.erase(last, m_graph.doors.end());
        return dropped;
    }

    void linkAtOpenings()
    {
        for (std::size_t i = 0; i < m_curves.size(); ++i)
            for (std::size_t k = 0; k < 2; ++k)  // right and upper neighbour: each pair once
            {
                const int n = m_curves.neighbours(i)[k];
                if (n < 0) continue;
                const int a = m_graph.circleOfCell[i], b = m_graph.circleOfCell[static_cast<std::size_t>(n)];
                if (a < 0 || b < 0 || a == b) continue;
                addOpening(a, b, m_curves.cell(i));
                addBorder(a, b, m_curves.cell(i));
            }
    }

    /** Openings between the same places whose circles overlap are one opening: the wider counts. */
    void addOpening(int a, int b, Cell at)
    {
        PlaceLink link{static_cast<std::size_t>(std::min(a, b)), static_cast<std::size_t>(std::max(a, b)), at,
                       m_distances.clearance_cells(at), -1};
        for (std::size_t k : m_linksOf[{link.from, link.to}]) {
            PlaceLink& other = m_graph.links[k];
            if (distance_cells(other.at, at) >= other.clearance_cells + link.clearance_cells) continue;
            if (link.clearance_cells > other.clearance_cells) other = link;
            return;
        }
        m_linksOf[{link.from, link.to}].push_back(m_graph.links.size());
        m_graph.links.push_back(link);
    }

    void addBorder(int a, int b, Cell at)
    {
        const auto jambs = findJambs(m_grid, m_obstacles, at, m_distances.clearance_cells(at));
        if (!jambs) return;  // the partition then meets half-way
        m_graph.borders.push_back({static_cast<std::size_t>(std::min(a, b)),
                                   static_cast<std::size_t>(std::max(a, b)),
                                   criticalLine(m_grid, at, *jambs)});
    }

    void linkAtDoors()
    {
        for (std::size_t d = 0; d < m_graph.doors.size(); ++d) {
            const ValidatedDoor& door = m_graph.doors[d];
            const std::set<int> sides = sidesOf(door);
            m_graph.links.push_back({static_cast<std::size_t>(*sides.begin()),
                                     static_cast<std::size_t>(*std::next(sides.begin())), door.critical.cell,
                                     door.critical.clearance_cells, static_cast<int>(d)});
        }
    }

    void sortLinks()
    {
        std::sort(m_graph.links.begin(), m_graph.links.end(), [](const PlaceLink& a, const PlaceLink& b) {
            if (a.from != b.from) return a.from < b.from;
            if (a.to != b.to) return a.to < b.to;
            return rasterLess(a.at, b.at);
        });
    }

    CurveCells m_curves;
    const ClassifiedGrid& m_grid;
    Obstacles m_obstacles;
    const DistanceMap& m_distances;
    double m_minRadius;
    std::vector<bool> m_blocked;
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> m_linksOf;
    PlaceGraph m_graph;
};
}  // namespace

std::vector<OptionField> TPlaceOptions::fields()
{
    return {{"critical_rise", &critical_rise, "m",
             "A critical point's clearance rises by at least this to both sides (and by a cell, whatever its "
             "size).",
             0, 5},
            {"door_support", &door_support, "m",
             "A critical point supports a door candidate within this distance.", 0, 5},
            {"min_radius", &min_radius, "m", "Smallest circle that makes a place: half the narrowest door.",
             0.05, 10}};
}

PlaceBuilder::PlaceBuilder(TPlaceOptions options) : m_options(std::move(options))
{
    m_options.check();
}

std::vector<CriticalPoint> PlaceBuilder::criticalPoints(const VoronoiGraph& voronoi,
                                                        const DistanceMap& distances,
                                                        double resolution_m) const
{
    return findCriticalPoints(voronoi, distances, std::max(1.0, m_options.critical_rise / resolution_m));
}

std::vector<ValidatedDoor> PlaceBuilder::validate(const std::vector<DoorCandidate>& candidates,
                                                  const std::vector<CriticalPoint>& points,
                                                  const ClassifiedGrid& grid, Obstacles obstacles) const
{
    std::set<int> supporting;
    for (const int p : supportOf(candidates, points, m_options.door_support / grid.resolution_m()))
        if (p >= 0) supporting.insert(p);
    std::vector<ValidatedDoor> doors;
    for (const int p : supporting) {
        const CriticalPoint& point = points[static_cast<std::size_t>(p)];
        const auto jambs = findJambs(grid, obstacles, point.cell, point.clearance_cells);
        if (!jambs) continue;
        ValidatedDoor door{point, jambs->nearest, jambs->facing, criticalLine(grid, point.cell, *jambs)};
        doors.push_back(std::move(door));
    }
    return doors;
}

PlaceGraph PlaceBuilder::build(std::vector<ValidatedDoor> doors, const VoronoiGraph& voronoi,
                               const ClassifiedGrid& grid, Obstacles obstacles,
                               const DistanceMap& distances) const
{
    return DiagramDivider(std::move(doors), voronoi, grid, obstacles, distances,
                          m_options.min_radius / grid.resolution_m())
        .divide();
}
}  // namespace gr2to
