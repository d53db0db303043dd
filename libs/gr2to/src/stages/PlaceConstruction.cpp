#include "gr2to/stages/PlaceConstruction.h"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "gr2to/grid/CriticalPoints.h"
#include "gr2to/grid/Jambs.h"
#include "gr2to/topology/DiagramDivider.h"
#include "gr2to/topology/ShallowMerging.h"

namespace gr2to
{
namespace
{
/** Finds the critical points that support door candidates, through square buckets of points. */
class SupportFinder
{
 public:
    SupportFinder(const std::vector<CriticalPoint>& points, double radius)
        : m_points(points), m_radius(radius), m_side(std::max(1, static_cast<int>(std::ceil(radius))))
    {
        for (std::size_t p = 0; p < points.size(); ++p)
            m_buckets[key(points[p].cell.x / m_side, points[p].cell.y / m_side)].push_back(p);
    }

    /** Index of the narrowest point within the radius of one of the candidate's cells, of equals the first;
     * or -1. */
    int supportOf(const DoorCandidate& candidate) const
    {
        int left = candidate.center.x, right = left, bottom = candidate.center.y, top = bottom;
        for (const Cell c : candidate.cells) {
            left = std::min(left, c.x);
            right = std::max(right, c.x);
            bottom = std::min(bottom, c.y);
            top = std::max(top, c.y);
        }
        int best = -1;
        for (int y = bottom / m_side - 1; y <= top / m_side + 1; ++y)
            for (int x = left / m_side - 1; x <= right / m_side + 1; ++x)
                if (const auto at = m_buckets.find(key(x, y)); at != m_buckets.end())
                    for (const std::size_t p : at->second)
                        if (isBetter(p, best) && isClose(m_points[p].cell, candidate))
                            best = static_cast<int>(p);
        return best;
    }

 private:
    static std::int64_t key(int x, int y) { return std::int64_t{y} * (std::int64_t{1} << 32) + x; }

    bool isBetter(std::size_t p, int best) const
    {
        if (best < 0) return true;
        const double here = m_points[p].clearance_cells,
                     there = m_points[static_cast<std::size_t>(best)].clearance_cells;
        return here != there ? here < there : static_cast<int>(p) < best;
    }

    bool isClose(Cell point, const DoorCandidate& candidate) const
    {
        return std::any_of(candidate.cells.begin(), candidate.cells.end(),
                           [&](Cell c) { return distance_cells(point, c) <= m_radius; });
    }

    const std::vector<CriticalPoint>& m_points;
    double m_radius;
    int m_side;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> m_buckets;
};

ValidatedDoor makeDoor(const ClassifiedGrid& grid, const CriticalPoint& point, const Jambs& jambs)
{
    return {point, jambs.nearest, jambs.facing, criticalLine(grid, point.cell, jambs)};
}

/** Makes doors of links at openings between jambs whose clear width is that of a door. */
void makeNarrowOpeningsDoors(const ClassifiedGrid& grid, Obstacles obstacles, double minWidth,
                             double maxWidth, PlaceGraph& graph)
{
    for (PlaceLink& link : graph.links) {
        if (link.door >= 0) continue;
        const auto jambs = findJambs(grid, obstacles, link.at, link.clearance_cells);
        if (!jambs) continue;
        const double clearWidth = distance_cells(jambs->nearest, jambs->facing) - 1;
        if (clearWidth < minWidth || clearWidth > maxWidth) continue;
        link.door = static_cast<int>(graph.doors.size());
        graph.doors.push_back(makeDoor(grid, {link.at, link.clearance_cells}, *jambs));
    }
}
}  // namespace

std::vector<OptionField> TPlaceOptions::fields()
{
    return {
        {"critical_rise", &critical_rise, "m",
         "A critical point's clearance rises by at least this to both sides (and by a cell, whatever its "
         "size).",
         0, 5},
        {"door_support", &door_support, "m",
         "A critical point supports a door candidate within this distance.", 0, 5},
        {"min_radius", &min_radius, "m", "Smallest circle that makes a place: half the narrowest door.", 0.05,
         10},
        {"meet_at_narrowest", &meet_at_narrowest, "",
         "Whether places without a door between them meet where it is narrowest, not half-way between their "
         "rims."},
        {"min_depth", &min_depth, "ratio",
         "Places merge across a narrowing wider than this part of the smaller one; 1 merges none.", 0, 1},
        {"narrow_opening", &narrow_opening, "m",
         "An opening between two jambs no wider than this is a door, whether eq. (8) saw it or not; 0 trusts "
         "eq. (8).",
         0, 20}};
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
    const SupportFinder finder(points, m_options.door_support / grid.resolution_m());
    for (const DoorCandidate& candidate : candidates)
        if (const int p = finder.supportOf(candidate); p >= 0) supporting.insert(p);
    std::vector<ValidatedDoor> doors;
    for (const int p : supporting) {
        const CriticalPoint& point = points[static_cast<std::size_t>(p)];
        const auto jambs = findJambs(grid, obstacles, point.cell, point.clearance_cells);
        if (!jambs) continue;
        doors.push_back(makeDoor(grid, point, *jambs));
    }
    return doors;
}

PlaceGraph PlaceBuilder::build(std::vector<ValidatedDoor> doors, const VoronoiGraph& voronoi,
                               const ClassifiedGrid& grid, Obstacles obstacles,
                               const DistanceMap& distances) const
{
    const MeetingRule meeting = m_options.meet_at_narrowest ? MeetingRule::Narrowest : MeetingRule::HalfWay;
    PlaceGraph graph = DiagramDivider(std::move(doors), voronoi, grid, obstacles, distances,
                                      m_options.min_radius / grid.resolution_m(), meeting)
                           .divide();
    if (m_options.min_depth < 1) graph = mergeShallow(graph, m_options.min_depth);
    const double narrow = m_options.narrow_opening / grid.resolution_m();
    if (narrow > 0)
        makeNarrowOpeningsDoors(grid, obstacles, 2 * m_options.min_radius / grid.resolution_m(), narrow,
                                graph);
    return graph;
}
}  // namespace gr2to
