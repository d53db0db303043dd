#include "gr2to/grid/Jambs.h"

#include <algorithm>
#include <cmath>

namespace gr2to
{
namespace
{
/** A diagonal step to the side lengthens the way to one jamb and shortens the way to the other. */
constexpr double kSlack = 2 * 1.41421356237309505;

std::int64_t squaredDistance(Cell a, Cell b)
{
    const std::int64_t dx = a.x - b.x, dy = a.y - b.y;
    return dx * dx + dy * dy;
}

/** Obstacles in a ring around a cell, row by row. */
std::vector<Cell> obstaclesInRing(const ClassifiedGrid& grid, Obstacles obstacles, Cell center, double inner,
                                  double outer)
{
    std::vector<Cell> found;
    const auto take = [&](int y, int first, int last) {
        for (int x = std::max(0, first); x <= std::min(grid.width() - 1, last); ++x) {
            const CellState state = grid.at({x, y});
            if (obstacles == Obstacles::Occupied ? state == CellState::Occupied : state != CellState::Free)
                found.push_back({x, y});
        }
    };
    const int reach = static_cast<int>(std::floor(outer));
    for (int dy = -reach; dy <= reach; ++dy) {
        const int y = center.y + dy;
        if (y < 0 || y >= grid.height()) continue;
        const int half = static_cast<int>(std::floor(std::sqrt(outer * outer - dy * dy)));
        if (std::abs(dy) >= inner) {
            take(y, center.x - half, center.x + half);
            continue;
        }
        const int hole = static_cast<int>(std::ceil(std::sqrt(inner * inner - dy * dy)));
        take(y, center.x - half, center.x - hole);
        take(y, center.x + hole, center.x + half);
    }
    return found;
}
}  // namespace

std::optional<Jambs> findJambs(const ClassifiedGrid& grid, Obstacles obstacles, Cell at,
                               double clearance_cells)
{
    const auto distance = [&](Cell c) { return squaredDistance(c, at); };
    const std::vector<Cell> near =
        obstaclesInRing(grid, obstacles, at, std::max(0.5, clearance_cells - 0.5), clearance_cells + kSlack);
    if (near.empty()) return std::nullopt;
    const Cell a = *std::min_element(near.begin(), near.end(),
                                     [&](Cell l, Cell r) { return distance(l) < distance(r); });
    const auto along = [&](Cell c) {
        const std::int64_t dot =
            std::int64_t{c.x - at.x} * (a.x - at.x) + std::int64_t{c.y - at.y} * (a.y - at.y);
        return static_cast<double>(dot) / std::sqrt(static_cast<double>(distance(c)));
    };
    std::optional<Cell> b;
    for (const Cell c : near)
        if (along(c) < 0 &&
            (!b || distance(c) < distance(*b) || (distance(c) == distance(*b) && along(c) < along(*b))))
            b = c;
    if (!b) return std::nullopt;
    return Jambs{a, *b};
}

std::vector<Cell> lineCells(Cell from, Cell to)
{
    const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    std::vector<Cell> cells;
    for (int k = 0; k <= steps; ++k) {
        const double t = steps == 0 ? 0.0 : static_cast<double>(k) / steps;
        cells.push_back(
            {from.x + roundToCell(t * (to.x - from.x)), from.y + roundToCell(t * (to.y - from.y))});
    }
    return cells;
}

std::vector<Cell> criticalLine(const ClassifiedGrid& grid, Cell at, const Jambs& jambs)
{
    std::vector<Cell> line;
    for (const Cell jamb : {jambs.nearest, jambs.facing})
        for (const Cell c : lineCells(at, jamb)) {
            if (!grid.isFree(c)) break;
            if (c != at || line.empty()) line.push_back(c);
        }
    return line;
}
}  // namespace gr2to
