#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
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

/** A cell packed into 32 bits: sides are below 2^16. */
inline std::uint32_t packCell(int x, int y)
{
    return static_cast<std::uint32_t>(x) | static_cast<std::uint32_t>(y) << 16U;
}
inline Cell unpackCell(std::uint32_t packed)
{
    return {static_cast<int>(packed & 0xFFFFU), static_cast<int>(packed >> 16U)};
}

/** Receives a row's nearest obstacles, packed; an entry counts on free cells that reach an obstacle. */
using NearestObstacleRow = std::function<void(int y, const std::uint32_t* nearest)>;

/** Measures the distance map in two passes over the cells (columns, then the lower envelope of parabolas of
 * each row).
 *
 * \param onRow  called with the nearest obstacles of every row, from the bottom, once its distances are in
 * `map`; of obstacles equally near one counts. They are not kept: whoever needs them uses them now. Cost:
 * linear in the number of cells. Source: Gr2To paper, section 4, second stage; Meijster et al., ISMM 2000;
 * Maurer et al., PAMI 2003 (the envelope without divisions).
 */
void measureDistances(const ClassifiedGrid& grid, Obstacles obstacles, DistanceMap& map,
                      const NearestObstacleRow& onRow = {});
DistanceMap measureDistances(const ClassifiedGrid& grid, Obstacles obstacles);
}  // namespace gr2to
