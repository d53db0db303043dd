#pragma once

#include <Eigen/Core>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to
{
/** Where a ray leaves the free cells. */
struct RayEnd
{
    Cell cell;                             //!< the first cell that is not free; may lie outside the grid
    CellState state = CellState::Unknown;  //!< of that cell; outside the grid all is unknown
    double enter = 0;                      //!< length [cells] at which the ray enters it
    double leave = 0;                      //!< and at which it leaves it
};

/** Follows a ray through every cell that it passes, up to the first that is not free.
 *
 * A ray that meets the corner of four cells goes on into the opposite one, unless both cells beside it are
 * not free: then it ends at the one beside it in x. \param start  in continuous grid coordinates [cells]
 * \param direction  unit vector along the grid's axes
 * Cost: one step a cell. Source: Amanatides and Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, 1987.
 */
RayEnd castRay(const ClassifiedGrid& grid, const Eigen::Vector2d& start, const Eigen::Vector2d& direction);
}  // namespace gr2to
