#include "gr2to/topology/RegionGraph.h"

#include <algorithm>
#include <array>

#include "gr2to/base/errors.h"
#include "gr2to/grid/Jambs.h"

namespace gr2to
{
namespace
{
/** What makes a region a place. */
struct Measures
{
    std::size_t cells = 0;
    std::int32_t squaredRadius = -1;
    std::size_t center = 0;  // first cell of the largest clearance
    bool hasBorder = false;
};

std::vector<Measures> measure(const Regions& regions, const DistanceMap& distances)
{
    std::vector<Measures> measures(static_cast<std::size_t>(regions.count) + 1);
    for (std::size_t i = 0; i < regions.ofCell.size(); ++i) {
        Measures& m = measures[static_cast<std::size_t>(regions.ofCell[i])];
        ++m.cells;
        if (distances.squared[i] <= m.squaredRadius) continue;
        m.squaredRadius = distances.squared[i];
        m.center = i;
    }
    for (const RegionBorder& border : regions.borders)
        measures[static_cast<std::size_t>(border.from)].hasBorder =
            measures[static_cast<std::size_t>(border.to)].hasBorder = true;
    return measures;
}

/** Numbers the regions that are places, in raster order of their centres; -1 for others. */
std::vector<int> choosePlaces(const std::vector<Measures>& measures, const RegionGraphRules& rules,
                              std::vector<std::size_t>& order)
{
    const auto isLarge = [&](const Measures& m) {
        return static_cast<double>(m.cells) >= rules.minArea_cells &&
               m.squaredRadius >= rules.minRadius_cells * rules.minRadius_cells;
    };
    std::size_t widest = 0;
    for (std::size_t r = 1; r < measures.size(); ++r) {
        if (widest == 0 || measures[r].squaredRadius > measures[widest].squaredRadius) widest = r;
        if (measures[r].hasBorder || isLarge(measures[r])) order.push_back(r);
    }
    // In a map of one small room that room is a place, if a robot fits in.
    if (order.empty() && widest > 0 &&
        measures[widest].squaredRadius >= 0.25 * rules.minDoor_cells * rules.minDoor_cells)
        order.push_back(widest);
    if (order.size() >= 0xFFFF)
        throw OutputError("the map has " + std::to_string(order.size()) +
                          " places; at most 65534 can be numbered: raise cut.min_area or cut the map");
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return measures[a].center < measures[b].center; });
    std::vector<int> number(measures.size(), -1);
    for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = static_cast<int>(k);
    return number;
}

/** Lengthens a border to the far ends of another one beside it: one opening that two cuts share. */
void lengthen(RegionBorder& border, const RegionBorder& other)
{
    const std::array<Cell, 4> ends{border.jambA, border.jambB, other.jambA, other.jambB};
    for (const Cell a : ends)
        for (const Cell b : ends)
            if (const double length = distance_cells(a, b) - 1; length > border.length_cells) {
                border.length_cells = length;
                border.jambA = a;
                border.jambB = b;
            }
}

/** Borders between the same places that lie side by side are one: the longest, lengthened when too short for
 * a door. */
std::vector<RegionBorder> separateBorders(std::vector<RegionBorder> borders, double minDoor_cells)
{
    std::stable_sort(borders.begin(), borders.end(), [](const RegionBorder& a, const RegionBorder& b) {
        if (a.from != b.from) return a.from < b.from;
        if (a.to != b.to) return a.to < b.to;
        return a.length_cells > b.length_cells;
    });
    std::vector<RegionBorder> kept;
    std::size_t first = 0;  // of the same pair
    for (const RegionBorder& border : borders) {
        if (!kept.empty() && (kept[first].from != border.from || kept[first].to != border.to))
            first = kept.size();
        const double slack_cells = 0.5 * minDoor_cells;  // about as thick as walls are
        const auto beside = std::find_if(
            kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end(), [&](const RegionBorder& other) {
                return distance_cells(other.middle, border.middle) <=
                       0.5 * (other.length_cells + border.length_cells) + slack_cells;
            });
        if (beside == kept.end())
            kept.push_back(border);
        else if (beside->length_cells < minDoor_cells)
            lengthen(*beside, border);
    }
    return kept;
}

/** The border's cell that is farthest from obstacles: half-way through a doorway that it crosses. */
Cell widestCell(const RegionBorder& border, const DistanceMap& distances)
{
    return *std::max_element(border.cells.begin(), border.cells.end(), [&](Cell a, Cell b) {
        return distances.clearance_cells(a) < distances.clearance_cells(b);
    });
}

/** Whether two lines are parallel within 45 degrees. */
bool runAlike(Cell a, Cell b, Cell c, Cell d)
{
    const double dot =
        static_cast<double>(b.x - a.x) * (d.x - c.x) + static_cast<double>(b.y - a.y) * (d.y - c.y);
    return dot * dot >= 0.5 * std::pow(distance_cells(a, b) * distance_cells(c, d), 2);
}

/** A border that crosses a doorway askew is longer than the doorway is wide: the jambs are the obstacles
 * nearest to its middle, unless those stand in front of it. */
void straighten(RegionBorder& border, const ClassifiedGrid& grid, Obstacles obstacles,
                const DistanceMap& distances)
{
    if (border.cells.empty()) return;
    const Cell middle = widestCell(border, distances);
    const auto jambs = findJambs(grid, obstacles, middle, distances.clearance_cells(middle));
    if (!jambs) return;
    const double width_cells = distance_cells(jambs->nearest, jambs->facing) - 1;
    if (width_cells >= border.length_cells ||
        !runAlike(jambs->nearest, jambs->facing, border.jambA, border.jambB))
        return;
    border.jambA = jambs->nearest;
    border.jambB = jambs->facing;
    border.length_cells = width_cells;
}

void addLink(const RegionBorder& border, const std::vector<int>& number, const DistanceMap& distances,
             const RegionGraphRules& rules, PlaceGraph& graph)
{
    constexpr double cell = 1;  // a narrow passage may be a cell narrower in the grid than it is
    if (border.length_cells < rules.minDoor_cells - cell) return;
    PlaceLink link;
    const auto [from, to] = std::minmax(number[static_cast<std::size_t>(border.from)],
                                        number[static_cast<std::size_t>(border.to)]);
    link.from = static_cast<std::size_t>(from);
    link.to = static_cast<std::size_t>(to);
    link.at = border.middle;
    link.clearance_cells = 0.5 * (border.length_cells + 1);
    if (border.length_cells <= rules.maxDoor_cells) {
        link.door = static_cast<int>(graph.doors.size());
        graph.doors.push_back({{border.middle, distances.clearance_cells(border.middle)},
                               border.jambA,
                               border.jambB,
                               border.cells});
    }
    graph.links.push_back(link);
}
}  // namespace

PlaceGraph graphOfRegions(const Regions& regions, const VoronoiGraph& voronoi, const ClassifiedGrid& grid,
                          Obstacles obstacles, const DistanceMap& distances, const RegionGraphRules& rules)
{
    const std::vector<Measures> measures = measure(regions, distances);
    std::vector<std::size_t> order;
    const std::vector<int> number = choosePlaces(measures, rules, order);
    PlaceGraph graph;
    const auto width = static_cast<std::size_t>(distances.width);
    for (const std::size_t r : order) {
        const Cell center{static_cast<int>(measures[r].center % width),
                          static_cast<int>(measures[r].center / width)};
        graph.circles.push_back({center, std::sqrt(static_cast<double>(measures[r].squaredRadius))});
    }
    for (RegionBorder& border : separateBorders(regions.borders, rules.minDoor_cells)) {
        straighten(border, grid, obstacles, distances);
        addLink(border, number, distances, rules, graph);
    }
    std::sort(graph.links.begin(), graph.links.end(), [](const PlaceLink& a, const PlaceLink& b) {
        if (a.from != b.from) return a.from < b.from;
        if (a.to != b.to) return a.to < b.to;
        return rasterLess(a.at, b.at);
    });
    graph.regions = PlaceImage(distances.width, distances.height);
    for (std::size_t i = 0; i < regions.ofCell.size(); ++i)
        if (regions.ofCell[i] > 0)
            graph.regions.ids[i] =
                static_cast<PlaceId>(number[static_cast<std::size_t>(regions.ofCell[i])] + 1);
    for (const std::uint32_t i : voronoi.cells)
        graph.circleOfCell.push_back(
            regions.ofCell[i] > 0 ? number[static_cast<std::size_t>(regions.ofCell[i])] : -1);
    return graph;
}
}  // namespace gr2to
