#pragma once

#include <Eigen/Core>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to
{
/** The occupied cells within a cell of a segment, in raster order.
 * \param from, to  in continuous grid coordinates [cells] \param covered  receives the part of the segment's
 * length that has one beside it
 */
std::vector<Cell> wallSupport(const ClassifiedGrid& grid, const Eigen::Vector2d& from,
                              const Eigen::Vector2d& to, double* covered);
}  // namespace gr2to
