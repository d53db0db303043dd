#include "gr2to/grid/ClassifiedGrid.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "gr2to/base/errors.h"

namespace gr2to
{
Eigen::Vector2d GridFrame::toMap(double column, double row) const
{
    const Eigen::Vector2d inGrid((column + 0.5) * resolution_m, (row + 0.5) * resolution_m);
    return Eigen::Vector2d(origin_x_m, origin_y_m) + directionToMap(inGrid);
}

Eigen::Vector2d GridFrame::toGrid(double x_m, double y_m) const
{
    const double dx = x_m - origin_x_m, dy = y_m - origin_y_m;
    const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
    return {(c * dx + s * dy) / resolution_m - 0.5, (-s * dx + c * dy) / resolution_m - 0.5};
}

Eigen::Vector2d GridFrame::directionToMap(const Eigen::Vector2d& direction) const
{
    if (yaw_rad == 0.0) return direction;
    const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
    return {c * direction.x() - s * direction.y(), s * direction.x() + c * direction.y()};
}

ClassifiedGrid::ClassifiedGrid(int width, int height, GridFrame frame, CellState fill)
    : m_width(width), m_height(height), m_frame(frame)
{
    if (width <= 0 || height <= 0)
        throw InputError("the grid has " + std::to_string(width) + " x " + std::to_string(height) +
                         " cells; both sides must be positive");
    const auto cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (std::max(width, height) > maxSide())
        throw InputError("the grid has " + std::to_string(width) + " x " + std::to_string(height) +
                         " cells; at most " + std::to_string(maxSide()) +
                         " a side are supported: crop it or use a coarser resolution");
    if (!(std::isfinite(frame.resolution_m) && frame.resolution_m > 0.0))
        throw InputError("the resolution is " + std::to_string(frame.resolution_m) +
                         " m; it must be a positive number of metres per cell");
    if (!(std::isfinite(frame.origin_x_m) && std::isfinite(frame.origin_y_m) && std::isfinite(frame.yaw_rad)))
        throw InputError("the grid's origin must be finite numbers");
    m_cells.assign(cells, fill);
}

std::size_t ClassifiedGrid::count(CellState state) const
{
    return static_cast<std::size_t>(std::count(m_cells.begin(), m_cells.end(), state));
}

bool operator==(const ClassifiedGrid& a, const ClassifiedGrid& b)
{
    return a.m_width == b.m_width && a.m_height == b.m_height && a.m_cells == b.m_cells &&
           a.m_frame.resolution_m == b.m_frame.resolution_m && a.m_frame.origin_x_m == b.m_frame.origin_x_m &&
           a.m_frame.origin_y_m == b.m_frame.origin_y_m && a.m_frame.yaw_rad == b.m_frame.yaw_rad;
}
}  // namespace gr2to
