#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gr2to/grid/DistanceMap.h"

namespace gr2to
{
/** A binary image with a border of one empty cell, so that every cell has eight neighbours. */
class Mask
{
 public:
    Mask(int width, int height)
        : m_width(width),
          m_height(height),
          m_stride(static_cast<std::size_t>(width) + 2),
          m_bits(m_stride * (static_cast<std::size_t>(height) + 2), 0)
    {
    }
    int width() const { return m_width; }
    int height() const { return m_height; }
    std::size_t stride() const { return m_stride; }
    std::size_t index(Cell c) const
    {
        return (static_cast<std::size_t>(c.y) + 1) * m_stride + static_cast<std::size_t>(c.x) + 1;
    }
    Cell cell(std::size_t index) const
    {
        return {static_cast<int>(index % m_stride) - 1, static_cast<int>(index / m_stride) - 1};
    }
    std::uint8_t operator[](std::size_t i) const { return m_bits[i]; }
    std::uint8_t& operator[](std::size_t i) { return m_bits[i]; }
    /** Index steps to the eight neighbours, counter-clockwise from the right; even ones share a side. */
    std::array<std::ptrdiff_t, 8> neighbourSteps() const
    {
        const auto s = static_cast<std::ptrdiff_t>(m_stride);
        return {1, s + 1, s, s - 1, -1, -s - 1, -s, -s + 1};
    }

 private:
    int m_width;
    int m_height;
    std::size_t m_stride;
    std::vector<std::uint8_t> m_bits;
};

/** Whether removing a cell keeps the topology, for 4-connected figure and 8-connected ground.
 *
 * \param neighbours  bit i is set when neighbour i (counter-clockwise from the right) belongs to the figure
 */
bool isSimple(std::uint8_t neighbours);

/** Cells on which the Voronoi diagram must pass: next to them the nearest obstacle jumps by at least a
 * separation.
 *
 * Of two neighbouring cells the one with the larger clearance is taken, of equals the first in raster order.
 * The cells are two thick at most; see thin().
 */
std::vector<Cell> separatingCells(const ClassifiedGrid& grid, const DistanceMap& distances,
                                  const NearestObstacles& nearest, double minSeparation_cells);

/** Thins the free space to curves one cell wide, 4-connected, with the same components and holes.
 *
 * Cells are removed in the order of their clearance, smallest first, as long as the topology allows; the
 * anchors stay until all others are gone, then they are thinned themselves, keeping their ends. \param
 * anchors  where the curves must pass, as from separatingCells() \return the remaining cells are 1 Cost:
 * linear in the number of free cells.
 */
Mask thin(const ClassifiedGrid& grid, const DistanceMap& distances, const std::vector<Cell>& anchors);
}  // namespace gr2to
