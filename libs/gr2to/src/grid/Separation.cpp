#include "gr2to/grid/Separation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/forEachMarked.h"
#include "base/vectorised.h"

namespace gr2to
{
namespace
{
/** Farther apart than any separation asked for, and its square twice fits 32 bits. */
constexpr std::int32_t kFar = 0x7FFF;

/** Marks where two neighbouring rows, or a row and itself one cell further, are both free and their nearest
 * obstacles at least a distance apart. */
GR2TO_VECTORISED
void markJumps(const CellState* cellsA, const CellState* cellsB, const std::uint32_t* nearestA,
               const std::uint32_t* nearestB, std::size_t count, std::int32_t minSquared, std::uint8_t* marks)
{
    for (std::size_t i = 0; i < count; ++i) {
        const auto dx = std::abs(static_cast<std::int32_t>(nearestA[i] & 0xFFFFU) -
                                 static_cast<std::int32_t>(nearestB[i] & 0xFFFFU));
        const auto dy = std::abs(static_cast<std::int32_t>(nearestA[i] >> 16U) -
                                 static_cast<std::int32_t>(nearestB[i] >> 16U));
        const std::int32_t x = std::min(dx, kFar), y = std::min(dy, kFar);
        const bool free = (cellsA[i] == CellState::Free) & (cellsB[i] == CellState::Free);
        marks[i] = static_cast<std::uint8_t>(free & (x * x + y * y >= minSquared));
    }
}
}  // namespace

SeparationFinder::SeparationFinder(const ClassifiedGrid& grid, double minSeparation_cells)
    : m_grid(grid),
      m_minSquared(
          static_cast<std::int32_t>(std::ceil(std::pow(std::min<double>(minSeparation_cells, kFar), 2)))),
      m_nearestBelow(static_cast<std::size_t>(grid.width())),
      m_squaredBelow(m_nearestBelow.size()),
      m_below(m_nearestBelow.size(), 0),
      m_current(m_nearestBelow.size(), 0),
      m_jumps(m_nearestBelow.size(), 0)
{
}

void SeparationFinder::addRow(int y, const std::int32_t* squared, const std::uint32_t* nearest)
{
    const CellState* row = m_grid.row(y);
    const std::size_t width = m_current.size();
    if (y > 0) {
        markJumps(row, m_grid.row(y - 1), nearest, m_nearestBelow.data(), width, m_minSquared,
                  m_jumps.data());
        forEachMarked(m_jumps.data(), width,
                      [&](std::size_t x) { (squared[x] > m_squaredBelow[x] ? m_current : m_below)[x] = 1; });
    }
    markJumps(row, row + 1, nearest, nearest + 1, width - 1, m_minSquared, m_jumps.data());
    forEachMarked(m_jumps.data(), width - 1,
                  [&](std::size_t x) { m_current[squared[x + 1] > squared[x] ? x + 1 : x] = 1; });
    finishRow(y - 1);
    m_below.swap(m_current);
    std::fill(m_current.begin(), m_current.end(), std::uint8_t{0});
    std::copy(nearest, nearest + width, m_nearestBelow.begin());
    std::copy(squared, squared + width, m_squaredBelow.begin());
}

void SeparationFinder::finishRow(int y)
{
    forEachMarked(m_below.data(), m_below.size(), [&](std::size_t x) {
        m_cells.push_back({static_cast<int>(x), y});
    });
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
