#include "support/building/Rasteriser.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gr2to::test
{
namespace
{
/** Samples lie this far from the centres of cells, so that a face at exactly a centre falls to the same side
 * always. */
constexpr double kNudge_m = 1.3e-7;

/** Fills turned rectangles row by row; cost follows their area, not that of the box around them. */
class Painter
{
 public:
    Painter(RasterisedPlan& raster, const BuildingPose& pose) : m_raster(raster), m_pose(pose) {}

    void fill(const Rect& r, CellState state, PlaceId label)
    {
        const auto& grid = m_raster.grid;
        const double res = grid.resolution_m();
        double low = std::numeric_limits<double>::max(), high = -low;
        for (const double x : {r.x0, r.x1})
            for (const double y : {r.y0, r.y1}) {
                const double mapY = m_pose.toMap({x, y}).y();
                low = std::min(low, mapY), high = std::max(high, mapY);
            }
        const int first = std::max(0, static_cast<int>(std::floor(low / res)) - 1);
        const int last = std::min(grid.height() - 1, static_cast<int>(std::floor(high / res)) + 1);
        for (int row = first; row <= last; ++row) fillRow(r, row, state, label);
    }

 private:
    void fillRow(const Rect& r, int row, CellState state, PlaceId label)
    {
        auto& grid = m_raster.grid;
        const double res = grid.resolution_m(), c = m_pose.cos(), s = m_pose.sin();
        const double dy = (row + 0.5) * res + kNudge_m - m_pose.shift().y();
        // building coordinates along the row are c * dx + s * dy and c * dy - s * dx
        double from = -std::numeric_limits<double>::max(), to = -from;
        clip(c, s * dy, r.x0, r.x1, from, to);
        clip(-s, c * dy, r.y0, r.y1, from, to);
        const double offset = m_pose.shift().x() - kNudge_m;
        const double begin = std::max(0.0, std::ceil((from + offset) / res - 0.5));
        const double end = std::min<double>(grid.width(), std::ceil((to + offset) / res - 0.5));
        if (begin >= end) return;
        const auto i = static_cast<int>(begin), j = static_cast<int>(end);
        std::fill(grid.row(row) + i, grid.row(row) + j, state);
        const auto at = m_raster.labels.ids.begin() + static_cast<std::ptrdiff_t>(grid.index({i, row}));
        std::fill(at, at + (j - i), label);
    }

    /** Narrows [from, to) to where low <= slope * x + constant < high. */
    static void clip(double slope, double constant, double low, double high, double& from, double& to)
    {
        if (slope == 0.0) {
            if (constant < low || constant >= high) to = from;
            return;
        }
        const double a = (low - constant) / slope, b = (high - constant) / slope;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }

    RasterisedPlan& m_raster;
    const BuildingPose& m_pose;
};

PlaceId idOf(std::size_t room)
{
    return static_cast<PlaceId>(room + 1);
}

/** A doorway in two halves, each belonging to its room. */
void openDoor(Painter& painter, const PlanDoor& door, double thickness)
{
    const double line = door.wall.line, half = thickness / 2;
    const double a = door.along - door.width / 2, b = door.along + door.width / 2;
    const Rect low = door.wall.vertical ? Rect{line - half, a, line, b} : Rect{a, line - half, b, line};
    const Rect high = door.wall.vertical ? Rect{line, a, line + half, b} : Rect{a, line, b, line + half};
    painter.fill(low, CellState::Free, idOf(door.wall.low));
    painter.fill(high, CellState::Free, idOf(door.wall.high));
}

/** Largest group of free cells that only sampling can have cut off. */
constexpr std::size_t kPocket_cells = 12;

/** The free cells connected to `start` by their sides; stops once they are more than a pocket. */
std::vector<Cell> groupOf(const ClassifiedGrid& grid, Cell start)
{
    std::vector<Cell> group{start};
    for (std::size_t i = 0; i < group.size() && group.size() <= kPocket_cells; ++i) {
        const Cell c = group[i];
        for (const Cell n : {Cell{c.x + 1, c.y}, Cell{c.x - 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x, c.y - 1}})
            if (grid.isFree(n) && std::find(group.begin(), group.end(), n) == group.end()) group.push_back(n);
    }
    return group;
}

/** Sampling turned corners leaves free cells that touch the floor by their corners only: they become wall. */
void sealPockets(RasterisedPlan& raster)
{
    auto& grid = raster.grid;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        if (grid[i] != CellState::Free) continue;
        const Cell c = grid.cell(i);
        const int ways = (grid.isFree({c.x + 1, c.y}) ? 1 : 0) + (grid.isFree({c.x - 1, c.y}) ? 1 : 0) +
                         (grid.isFree({c.x, c.y + 1}) ? 1 : 0) + (grid.isFree({c.x, c.y - 1}) ? 1 : 0);
        if (ways > 2) continue;  // a pocket has an end or a corner
        const auto group = groupOf(grid, c);
        if (group.size() > kPocket_cells) continue;
        for (const Cell pocket : group) {
            grid.set(pocket, CellState::Occupied);
            raster.labels.ids[grid.index(pocket)] = 0;
        }
    }
}
}  // namespace

BuildingPose::BuildingPose(const FloorPlan& plan, const TBuildingOptions& options)
{
    const double quarters = options.rotation / 90.0;
    if (quarters == std::floor(quarters)) {
        const int turn = (static_cast<int>(quarters) % 4 + 4) % 4;
        m_cos = turn == 0 ? 1 : turn == 2 ? -1 : 0;
        m_sin = turn == 1 ? 1 : turn == 3 ? -1 : 0;
    } else {
        const double angle = options.rotation * (std::acos(-1.0) / 180.0);
        m_cos = std::cos(angle);
        m_sin = std::sin(angle);
    }
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::max()), high = -low;
    for (const auto& room : plan.rooms)
        for (const auto& floor : room.floor) {
            const Rect r = floor.grown(options.outer_wall_thickness);
            for (const double x : {r.x0, r.x1})
                for (const double y : {r.y0, r.y1}) {
                    const auto p = turned({x, y});
                    low = low.cwiseMin(p), high = high.cwiseMax(p);
                }
        }
    m_shift = Eigen::Vector2d::Constant(options.margin) - low;
    m_extent = high - low + Eigen::Vector2d::Constant(2 * options.margin);
}

RasterisedPlan rasterise(const FloorPlan& plan, const BuildingPose& pose, const TBuildingOptions& options)
{
    const double res = options.resolution;
    const int width = static_cast<int>(std::ceil(pose.extent().x() / res));
    const int height = static_cast<int>(std::ceil(pose.extent().y() / res));
    RasterisedPlan raster{ClassifiedGrid(width, height, GridFrame{res, 0, 0, 0}), PlaceImage(width, height)};
    Painter painter(raster, pose);
    for (const auto& room : plan.rooms)
        for (const auto& floor : room.floor)
            painter.fill(floor.grown(options.outer_wall_thickness), CellState::Occupied, 0);
    for (std::size_t i = 0; i < plan.rooms.size(); ++i)
        for (const auto& floor : plan.rooms[i].floor) painter.fill(floor, CellState::Free, idOf(i));
    for (const auto& door : plan.doors)
        if (!door.closed) openDoor(painter, door, options.wall_thickness);
    for (const auto& solid : plan.furniture) painter.fill(solid, CellState::Occupied, 0);
    sealPockets(raster);
    return raster;
}
}  // namespace gr2to::test
