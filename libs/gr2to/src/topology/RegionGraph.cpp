#include "gr2to/topology/RegionGraph.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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
    std::int32_t squaredRadius = -1;  // of the largest circle
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    std::size_t center = 0;
    bool hasBorder = false;
};

Eigen::Vector2d positionOf(std::size_t index, std::size_t width)
{
    const std::size_t row = index / width;
    return {static_cast<double>(index - row * width), static_cast<double>(row)};
}

/** The cell of a region nearest to its mean of those whose circle is the largest to a cell: half-way along a
 * corridor. */
void findCenters(const Regions& regions, const DistanceMap& distances, std::vector<Measures>& measures)
{
    const auto width = static_cast<std::size_t>(distances.width);
    std::vector<double> nearest(measures.size(), std::numeric_limits<double>::infinity());
    std::vector<std::int32_t> least(measures.size());  // squared distance of those
    for (std::size_t r = 0; r < measures.size(); ++r) {
        const double radius = std::sqrt(std::max(0, measures[r].squaredRadius));
        least[r] = static_cast<std::int32_t>(std::ceil(std::pow(std::max(0.0, radius - 1), 2)));
    }
    for (std::size_t i = 0; i < regions.ofCell.size(); ++i) {
        const auto r = static_cast<std::size_t>(regions.ofCell[i]);
        if (r == 0 || distances.squared[i] < least[r]) continue;
        const Eigen::Vector2d at = positionOf(i, width);
        if (const double distance = (at - measures[r].mean).squaredNorm(); distance < nearest[r]) {
            nearest[r] = distance;
            measures[r].center = i;
        }
    }
}

std::vector<Measures> measure(const Regions& regions, const DistanceMap& distances)
{
    const auto width = static_cast<std::size_t>(distances.width);
    std::vector<Measures> measures(static_cast<std::size_t>(regions.count) + 1);
    const std::vector<int>& ofCell = regions.ofCell;
    for (std::size_t begin = 0, end = 0; begin < ofCell.size(); begin = end) {  // runs within rows
        const std::size_t row = begin / width;
        while (end < (row + 1) * width && ofCell[end] == ofCell[begin]) ++end;
        if (ofCell[begin] == 0) continue;
        Measures& m = measures[static_cast<std::size_t>(ofCell[begin])];
        m.cells += end - begin;
        for (std::size_t i = begin; i < end; ++i)
            m.squaredRadius = std::max(m.squaredRadius, distances.squared[i]);
        m.mean +=
            static_cast<double>(end - begin) * (positionOf(begin, width) + positionOf(end - 1, width)) / 2;
    }
    for (Measures& m : measures)
        if (m.cells > 0) m.mean /= static_cast<double>(m.cells);
    findCenters(regions, distances, measures);
    return measures;
}

/** Numbers the regions that are places, in raster order of their centres; -1 for others. */
std::vector<int> choosePlaces(const std::vector<Measures>& measures, const RegionGraphRules& rules,
                              std::vector<std::size_t>& order)
{
    const auto fitsARobot = [&](const Measures& m) {
        return m.squaredRadius >= 0.25 * rules.minDoor_cells * rules.minDoor_cells;
    };
    std::size_t widest = 0;
    for (std::size_t r = 1; r < measures.size(); ++r) {
        if (widest == 0 || measures[r].squaredRadius > measures[widest].squaredRadius) widest = r;
        const bool isLarge = static_cast<double>(measures[r].cells) >= rules.minLoneArea_cells;
        if (measures[r].hasBorder || (isLarge && fitsARobot(measures[r]))) order.push_back(r);
    }
    // In a map of one small room that room is a place.
    if (order.empty() && widest > 0 && fitsARobot(measures[widest])) order.push_back(widest);
    if (order.size() >= 0xFFFF)
        throw OutputError("the map has " + std::to_string(order.size()) +
                          " places; at most 65534 can be numbered: raise cut.min_area or cut the map");
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return measures[a].center < measures[b].center; });
    std::vector<int> number(measures.size(), -1);
    for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = static_cast<int>(k);
    return number;
}

/** Whether all cells of a line but its ends are free. */
bool isFreeBetween(const ClassifiedGrid& grid, Cell a, Cell b)
{
    const std::vector<Cell> line = lineCells(a, b);
    return line.size() <= 2 ||
           std::all_of(line.begin() + 1, line.end() - 1, [&](Cell c) { return grid.isFree(c); });
}

/** Lengthens a border to the far ends of another one beside it, when nothing stands between them: one opening
 * that two cuts share. */
void lengthen(const ClassifiedGrid& grid, RegionBorder& border, const RegionBorder& other)
{
    const std::array<Cell, 4> ends{border.jambA, border.jambB, other.jambA, other.jambB};
    for (const Cell a : ends)
        for (const Cell b : ends)
            if (const double length = distance_cells(a, b) - 1;
                length > border.length_cells && isFreeBetween(grid, a, b)) {
                border.length_cells = length;
                border.jambA = a;
                border.jambB = b;
            }
}

/** Borders between the same places that lie side by side with nothing between them are one: the one under
 * a lintel or the longest, lengthened when too short for a door. */
std::vector<RegionBorder> separateBorders(const ClassifiedGrid& grid, std::vector<RegionBorder> borders,
                                          double minDoor_cells)
{
    std::stable_sort(borders.begin(), borders.end(), [](const RegionBorder& a, const RegionBorder& b) {
        if (a.from != b.from) return a.from < b.from;
        if (a.to != b.to) return a.to < b.to;
        if (a.lintel != b.lintel) return a.lintel;
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
                           0.5 * (other.length_cells + border.length_cells) + slack_cells &&
                       isFreeBetween(grid, other.middle, border.middle);
            });
        if (beside == kept.end())
            kept.push_back(border);
        else if (beside->length_cells < minDoor_cells && !beside->lintel)
            lengthen(grid, *beside, border);
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

/** A border that crosses a doorway askew is longer than the doorway is wide: the jambs are the obstacles
 * nearest to its middle, if they stand about where the border ends. */
void straighten(RegionBorder& border, const ClassifiedGrid& grid, Obstacles obstacles,
                const DistanceMap& distances, double reach_cells)
{
    if (border.cells.empty()) return;
    const Cell middle = widestCell(border, distances);
    const auto jambs = findJambs(grid, obstacles, middle, distances.clearance_cells(middle));
    if (!jambs) return;
    const double width_cells = distance_cells(jambs->nearest, jambs->facing) - 1;
    const auto isNear = [&](Cell a, Cell b) { return distance_cells(a, b) <= reach_cells; };
    const bool sameWay = isNear(jambs->nearest, border.jambA) && isNear(jambs->facing, border.jambB);
    const bool otherWay = isNear(jambs->nearest, border.jambB) && isNear(jambs->facing, border.jambA);
    if (width_cells >= border.length_cells || !(sameWay || otherWay)) return;
    border.jambA = jambs->nearest;
    border.jambB = jambs->facing;
    border.length_cells = width_cells;
}

void addLink(const RegionBorder& border, const std::vector<int>& number, const DistanceMap& distances,
             const RegionGraphRules& rules, PlaceGraph& graph)
{
    PlaceLink link;
    const auto [from, to] = std::minmax(number[static_cast<std::size_t>(border.from)],
                                        number[static_cast<std::size_t>(border.to)]);
    link.from = static_cast<std::size_t>(from);
    link.to = static_cast<std::size_t>(to);
    link.at = border.middle;
    link.clearance_cells = 0.5 * (border.length_cells + 1);
    if (border.lintel || border.length_cells <= rules.maxDoor_cells) {
        link.door = static_cast<int>(graph.doors.size());
        graph.doors.push_back({{border.middle, distances.clearance_cells(border.middle)},
                               border.jambA,
                               border.jambB,
                               border.cells});
    }
    graph.links.push_back(link);
}

/** The borders that are wide enough to go through, or under a lintel, which is built over doors alone. */
std::vector<RegionBorder> passagesOf(const Regions& regions, const ClassifiedGrid& grid, Obstacles obstacles,
                                     const DistanceMap& distances, const RegionGraphRules& rules)
{
    constexpr double cell = 1;  // a narrow passage may be a cell narrower in the grid than it is
    std::vector<RegionBorder> passages = separateBorders(grid, regions.borders, rules.minDoor_cells);
    for (RegionBorder& border : passages) straighten(border, grid, obstacles, distances, rules.minDoor_cells);
    passages.erase(std::remove_if(passages.begin(), passages.end(),
                                  [&](const RegionBorder& border) {
                                      return !border.lintel &&
                                             border.length_cells < rules.minDoor_cells - cell;
                                  }),
                   passages.end());
    return passages;
}
}  // namespace

PlaceGraph graphOfRegions(const Regions& regions, const VoronoiGraph& voronoi, const ClassifiedGrid& grid,
                          Obstacles obstacles, const DistanceMap& distances, const RegionGraphRules& rules)
{
    const std::vector<RegionBorder> passages = passagesOf(regions, grid, obstacles, distances, rules);
    std::vector<Measures> measures = measure(regions, distances);
    for (const RegionBorder& border : passages)
        measures[static_cast<std::size_t>(border.from)].hasBorder =
            measures[static_cast<std::size_t>(border.to)].hasBorder = true;
    std::vector<std::size_t> order;
    const std::vector<int> number = choosePlaces(measures, rules, order);
    PlaceGraph graph;
    const auto width = static_cast<std::size_t>(distances.width);
    for (const std::size_t r : order) {
        const Cell center{static_cast<int>(measures[r].center % width),
                          static_cast<int>(measures[r].center / width)};
        graph.circles.push_back({center, distances.clearance_cells(center)});
    }
    for (const RegionBorder& border : passages) addLink(border, number, distances, rules, graph);
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
