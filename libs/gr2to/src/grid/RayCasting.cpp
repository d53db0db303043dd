#include "gr2to/grid/RayCasting.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gr2to
{
namespace
{
/** The crossings of a ray with the borders between cells along one axis. */
struct Crossings
{
    int step = 0;
    double next = std::numeric_limits<double>::infinity();  //!< length at the next border
    double spacing = std::numeric_limits<double>::infinity();

    Crossings(double start, int cell, double direction)
    {
        if (direction == 0) return;
        step = direction > 0 ? 1 : -1;
        spacing = 1 / std::abs(direction);
        next = std::max(0.0, (0.5 + step * (cell - start)) * spacing);
    }
};

CellState stateAt(const ClassifiedGrid& grid, Cell cell)
{
    return grid.contains(cell) ? grid.at(cell) : CellState::Unknown;
}
}  // namespace

RayEnd castRay(const ClassifiedGrid& grid, const Eigen::Vector2d& start, const Eigen::Vector2d& direction)
{
    RayEnd end;
    end.cell = {static_cast<int>(std::lround(start.x())), static_cast<int>(std::lround(start.y()))};
    Crossings x(start.x(), end.cell.x, direction.x());
    Crossings y(start.y(), end.cell.y, direction.y());
    for (end.state = stateAt(grid, end.cell); end.state == CellState::Free;
         end.state = stateAt(grid, end.cell)) {
        end.enter = std::min(x.next, y.next);
        const bool corner = x.next == y.next;
        const Cell besideX{end.cell.x + x.step, end.cell.y}, besideY{end.cell.x, end.cell.y + y.step};
        if (corner && !grid.isFree(besideX) && !grid.isFree(besideY)) {
            end.cell = besideX;
            end.state = stateAt(grid, besideX);
            end.leave = end.enter;
            return end;
        }
        const bool alongX = corner || x.next < y.next, alongY = corner || y.next < x.next;
        if (alongX) end.cell.x += x.step, x.next += x.spacing;
        if (alongY) end.cell.y += y.step, y.next += y.spacing;
    }
    end.leave = std::min(x.next, y.next);
    return end;
}
}  // namespace gr2to
