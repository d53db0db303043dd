#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to
{
/** Which cells the clearance of a cell is measured to. */
enum class Obstacles : std::uint8_t
{
    Occupied,          //!< occupied cells alone, the paper's map_dist
    OccupiedOrUnknown  //!< unknown cells too: nobody has seen that a robot could be there
};

/** Exact Euclidean distance of every free cell to the nearest obstacle, in cells, centre to centre.
 *
 * Obstacles have distance 0, and so have cells that are neither free nor an obstacle: only free cells are
 * asked. Cells beyond the grid's border are no obstacles.
 */
struct DistanceMap
{
    int width = 0;
    int height = 0;
    std::vector<std::int32_t>
        squared;  //!< squared distance [cells^2]; unreachable() where there is no obstacle

    static constexpr std::int32_t unreachable() { return INT32_MAX; }
    std::size_t index(Cell c) const
    {
        return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(c.x);
    }
    double clearance_cells(std::size_t i) const { return std::sqrt(static_cast<double>(squared[i])); }
    double clearance_cells(Cell c) const { return clearance_cells(index(c)); }
};

/** The obstacle cell nearest to each free cell. */
struct NearestObstacles
{
    std::vector<std::uint32_t> packed;  //!< column + 65536 * row of the obstacle; own position on obstacles

    static std::uint32_t pack(int x, int y)
    {
        return static_cast<std::uint32_t>(x) | static_cast<std::uint32_t>(y) << 16U;
    }
    Cell at(std::size_t i) const
    {
        return {static_cast<int>(packed[i] & 0xFFFFU), static_cast<int>(packed[i] >> 16U)};
    }
};

/** Measures the distance map in two passes over the cells (columns, then the lower envelope of parabolas of
 * each row).
 *
 * \param nearest  when not null, receives the nearest obstacle of every free cell; of several the leftmost
 * column's Cost: linear in the number of cells. Source: Gr2To paper, section 4, second stage; Meijster et
 * al., ISMM 2000; Maurer et al., PAMI 2003 (the envelope without divisions).
 */
DistanceMap measureDistances(const ClassifiedGrid& grid, Obstacles obstacles,
                             NearestObstacles* nearest = nullptr);
}  // namespace gr2to
