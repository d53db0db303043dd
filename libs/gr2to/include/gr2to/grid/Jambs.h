#pragma once

#include <optional>
#include <vector>

#include "gr2to/grid/DistanceMap.h"

namespace gr2to
{
/** The nearest obstacles on two opposite sides of a cell of the Voronoi diagram. */
struct Jambs
{
    Cell nearest;  //!< the nearest obstacle
    Cell facing;   //!< the nearest one in the other half plane
};

/** Finds the jambs of a cell of the Voronoi diagram (Thrun's basis points).
 *
 * \param clearance_cells  of the cell; the diagram being up to a diagonal step off the middle, the facing
 * jamb may be two such steps farther \return nothing when all obstacles that near lie on one side
 */
std::optional<Jambs> findJambs(const ClassifiedGrid& grid, Obstacles obstacles, Cell at,
                               double clearance_cells);

/** Cells of the straight line between two cells, both included, 8-connected. */
std::vector<Cell> lineCells(Cell from, Cell to);

/** The line from jamb to cell to jamb, 8-connected, without the jambs; each half ends where it leaves the
 * free space. */
std::vector<Cell> criticalLine(const ClassifiedGrid& grid, Cell at, const Jambs& jambs);

/** The nearest whole number, halves away from zero: symmetric under mirrors of the grid. */
inline int roundToCell(double value)
{
    return static_cast<int>(value + (value < 0 ? -0.5 : 0.5));
}
}  // namespace gr2to
