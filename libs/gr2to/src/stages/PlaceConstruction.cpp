#include "gr2to/stages/PlaceConstruction.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "gr2to/grid/CriticalPoints.h"
#include "gr2to/grid/Jambs.h"
#include "gr2to/topology/DiagramDivider.h"
#include "gr2to/topology/MeasuredHeight.h"
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

    /** Indices of the points within the radius of one of the candidate's cells, the narrowest first. */
    std::vector<int> supportOf(const DoorCandidate& candidate) const
    {
        int left = candidate.center.x, right = left, bottom = candidate.center.y, top = bottom;
        for (const Cell c : candidate.cells) {
            left = std::min(left, c.x);
            right = std::max(right, c.x);
            bottom = std::min(bottom, c.y);
            top = std::max(top, c.y);
        }
        std::vector<int> support;
        for (int y = bottom / m_side - 1; y <= top / m_side + 1; ++y)
            for (int x = left / m_side - 1; x <= right / m_side + 1; ++x)
                if (const auto at = m_buckets.find(key(x, y)); at != m_buckets.end())
                    for (const std::size_t p : at->second)
                        if (isClose(m_points[p].cell, candidate)) support.push_back(static_cast<int>(p));
        std::sort(support.begin(), support.end(), [&](int a, int b) {
            const double here = point(a).clearance_cells, there = point(b).clearance_cells;
            return here != there ? here < there : a < b;
        });
        return support;
    }

 private:
    static std::int64_t key(int x, int y) { return std::int64_t{y} * (std::int64_t{1} << 32) + x; }

    const CriticalPoint& point(int p) const { return m_points[static_cast<std::size_t>(p)]; }

    /** Looks into the rows of the candidate's cells, which are in raster order. */
    bool isClose(Cell point, const DoorCandidate& candidate) const
    {
        const int reach = static_cast<int>(std::floor(m_radius));
        for (int dy = -reach; dy <= reach; ++dy) {
            const int half = static_cast<int>(std::floor(std::sqrt(m_radius * m_radius - dy * dy)));
            const auto at = std::lower_bound(candidate.cells.begin(), candidate.cells.end(),
                                             Cell{point.x - half, point.y + dy}, rasterLess);
            if (at != candidate.cells.end() && at->y == point.y + dy && at->x <= point.x + half) return true;
        }
        return false;
    }

    const std::vector<CriticalPoint>& m_points;
    double m_radius;
    int m_side;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> m_buckets;
};

ValidatedDoor makeDoor(const ClassifiedGrid& grid, const CriticalPoint& point, const Jambs& jambs)
{
    return {point, jambs.nearest, jambs.facing, criticalLine(grid, point.cell, jambs), false};
}

double clearWidth_cells(const ValidatedDoor& door)
{
    return distance_cells(door.jambA, door.jambB) - 1;
}

/** Notes whether a 3D map shows a lintel over a door that is not too wide for one. */
void lookForLintel(const ClassifiedGrid& grid, const HeightMap& heights, double maxWidth, ValidatedDoor& door)
{
    door.lintel =
        clearWidth_cells(door) <= maxWidth && hasLintel({grid, door.line, {door.jambA, door.jambB}}, heights);
}

/** Clear widths between jambs at which an opening is a door [cells]. */
struct OpeningRule
{
    double minWidth;
    double maxWidth;        //!< with nothing but its width to show
    double maxLintelWidth;  //!< under a lintel
};

/** Makes doors of links at openings between jambs whose clear width is that of a door. */
void makeNarrowOpeningsDoors(const ClassifiedGrid& grid, Obstacles obstacles, const HeightMap& heights,
                             const OpeningRule& rule, PlaceGraph& graph)
{
    for (PlaceLink& link : graph.links) {
        if (link.door >= 0) continue;
        const auto jambs = findJambs(grid, obstacles, link.at, link.clearance_cells);
        if (!jambs) continue;
        ValidatedDoor door = makeDoor(grid, {link.at, link.clearance_cells}, *jambs);
        lookForLintel(grid, heights, rule.maxLintelWidth, door);
        const double clearWidth = clearWidth_cells(door);
        if (clearWidth < rule.minWidth || (clearWidth > rule.maxWidth && !door.lintel)) continue;
        link.door = static_cast<int>(graph.doors.size());
        graph.doors.push_back(std::move(door));
    }
}

/** Takes the supporting points that are as narrow as a door and whose circles hold no narrower one's centre.
 */
void addSeparateDoors(const std::vector<CriticalPoint>& points, const std::vector<int>& narrowestFirst,
                      double maxClearance, std::set<int>& supporting)
{
    constexpr double cell = 1;  // a point in the middle of the widest door is not itself a likely cell
    std::vector<CriticalPoint> taken;
    for (const int p : narrowestFirst) {
        const CriticalPoint& point = points[static_cast<std::size_t>(p)];
        const auto holds = [&](const CriticalPoint& narrower) {
            return distance_cells(point.cell, narrower.cell) < point.clearance_cells;
        };
        if (point.clearance_cells >= maxClearance + cell || std::any_of(taken.begin(), taken.end(), holds))
            continue;
        taken.push_back(point);
        supporting.insert(p);
    }
}
/** Indices of the critical points that lie in no doorway yet, nor a doorway in them. */
std::vector<int> separateFrom(const std::vector<CriticalPoint>& points,
                              const std::map<int, ValidatedDoor>& doors, double maxClearance)
{
    const auto near = [](const CriticalPoint& a, const CriticalPoint& b) {
        return distance_cells(a.cell, b.cell) < std::max(a.clearance_cells, b.clearance_cells);
    };
    std::vector<int> separate;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (points[p].clearance_cells > maxClearance + 1) continue;
        const bool taken = std::any_of(doors.begin(), doors.end(), [&](const auto& door) {
            return near(points[p], door.second.critical);
        });
        const bool inSeparate = std::any_of(separate.begin(), separate.end(), [&](int other) {
            return near(points[p], points[static_cast<std::size_t>(other)]);
        });
        if (!taken && !inSeparate) separate.push_back(static_cast<int>(p));
    }
    return separate;
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
        {"one_door_per_candidate", &one_door_per_candidate, "",
         "Whether likely cells that chain together are one door, or as many as critical points support."},
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
         0, 20},
        {"lintel_width", &lintel_width, "m",
         "A critical point under a lintel of a 3D map no wider than this is a door, whether eq. (8) saw it "
         "or not; 0 "
         "trusts eq. (8).",
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
                                                  const ClassifiedGrid& grid, Obstacles obstacles,
                                                  const HeightMap& heights) const
{
    const double maxLintel = m_options.lintel_width / grid.resolution_m();
    std::set<int> supporting;
    const SupportFinder finder(points, m_options.door_support / grid.resolution_m());
    for (const DoorCandidate& candidate : candidates) {
        const std::vector<int> support = finder.supportOf(candidate);
        if (m_options.one_door_per_candidate)
            supporting.insert(support.begin(), support.begin() + (support.empty() ? 0 : 1));
        else
            addSeparateDoors(points, support, candidate.maxClearance_cells, supporting);
    }
    std::map<int, ValidatedDoor> doors;  // by their points, which are in raster order
    const auto make = [&](int p, bool onlyWithLintel) {
        const CriticalPoint& point = points[static_cast<std::size_t>(p)];
        const auto jambs = findJambs(grid, obstacles, point.cell, point.clearance_cells);
        if (!jambs) return;
        ValidatedDoor door = makeDoor(grid, point, *jambs);
        lookForLintel(grid, heights, maxLintel, door);
        if (!onlyWithLintel || door.lintel) doors.emplace(p, std::move(door));
    };
    for (const int p : supporting) make(p, false);
    if (!heights.empty())
        for (const int p : separateFrom(points, doors, maxLintel / 2)) make(p, true);
    std::vector<ValidatedDoor> result;
    result.reserve(doors.size());
    for (auto& [p, door] : doors) result.push_back(std::move(door));
    return result;
}

PlaceGraph PlaceBuilder::build(std::vector<ValidatedDoor> doors, const VoronoiGraph& voronoi,
                               const ClassifiedGrid& grid, Obstacles obstacles, const DistanceMap& distances,
                               const HeightMap& heights) const
{
    const MeetingRule meeting = m_options.meet_at_narrowest ? MeetingRule::Narrowest : MeetingRule::HalfWay;
    PlaceGraph graph = DiagramDivider(std::move(doors), voronoi, grid, obstacles, distances,
                                      m_options.min_radius / grid.resolution_m(), meeting)
                           .divide();
    if (m_options.min_depth < 1) graph = mergeShallow(graph, m_options.min_depth);
    const OpeningRule rule{2 * m_options.min_radius / grid.resolution_m(),
                           m_options.narrow_opening / grid.resolution_m(),
                           m_options.lintel_width / grid.resolution_m()};
    if (rule.maxWidth > 0) makeNarrowOpeningsDoors(grid, obstacles, heights, rule, graph);
    return graph;
}
}  // namespace gr2to
