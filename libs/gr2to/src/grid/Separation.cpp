#include "gr2to/grid/Separation.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gr2to
{
SeparationFinder::SeparationFinder(const ClassifiedGrid& grid, double minSeparation_cells)
    : m_grid(grid),
      m_minSquared(static_cast<std::int64_t>(std::ceil(minSeparation_cells * minSeparation_cells))),
      m_nearestBelow(static_cast<std::size_t>(grid.width())),
      m_squaredBelow(m_nearestBelow.size()),
      m_below(m_nearestBelow.size(), 0),
      m_current(m_nearestBelow.size(), 0)
{
}

bool SeparationFinder::separated(std::uint32_t a, std::uint32_t b) const
{
    const Cell p = unpackCell(a), q = unpackCell(b);
    const std::int64_t dx = p.x - q.x, dy = p.y - q.y;
    return dx * dx + dy * dy >= m_minSquared;
}

void SeparationFinder::addRow(int y, const std::int32_t* squared, const std::uint32_t* nearest)
{
    const CellState* row = m_grid.row(y);
    const CellState* rowBelow = y > 0 ? m_grid.row(y - 1) : nullptr;
    const std::size_t width = m_current.size();
    for (std::size_t x = 0; x < width; ++x) {
        if (row[x] != CellState::Free) continue;
        if (rowBelow && rowBelow[x] == CellState::Free && nearest[x] != m_nearestBelow[x] &&
            separated(nearest[x], m_nearestBelow[x]))
            (squared[x] > m_squaredBelow[x] ? m_current : m_below)[x] = 1;
        if (x + 1 < width && row[x + 1] == CellState::Free && nearest[x] != nearest[x + 1] &&
            separated(nearest[x], nearest[x + 1]))
            m_current[squared[x + 1] > squared[x] ? x + 1 : x] = 1;
    }
    finishRow(y - 1);
    m_below.swap(m_current);
    std::fill(m_current.begin(), m_current.end(), std::uint8_t{0});
    std::copy(nearest, nearest + width, m_nearestBelow.begin());
    std::copy(squared, squared + width, m_squaredBelow.begin());
}

void SeparationFinder::finishRow(int y)
{
    const std::uint8_t *begin = m_below.data(), *end = begin + m_below.size(), *at = begin;
    const auto next = [&] {
        return static_cast<const std::uint8_t*>(std::memchr(at, 1, static_cast<std::size_t>(end - at)));
    };
    for (at = next(); at != nullptr; at = next()) m_cells.push_back({static_cast<int>(at++ - begin), y});
}

std::vector<Cell> SeparationFinder::take()
{
    finishRow(m_grid.height() - 1);
    return std::move(m_cells);
}

std::vector<Cell> measureSeparation(const ClassifiedGrid& grid, Obstacles obstacles,
                                    double minSeparation_cells, DistanceMap& distances)
{
    SeparationFinder finder(grid, minSeparation_cells);
    measureDistances(grid, obstacles, distances, [&](int y, const std::uint32_t* nearest) {
        finder.addRow(y, distances.squared.data() + distances.index({0, y}), nearest);
    });
    return finder.take();
}
}  // namespace gr2to
