#pragma once

#include <cstddef>
#include <vector>

#include "gr2to/topology/PlaceGraph.h"

namespace gr2to
{
/** Groups circles into places: three or more in a row, of the same radius, joined without a door, are one
 * corridor.
 *
 * \param radiusTolerance  largest relative difference of radii that are the same
 * \param angleTolerance_rad  largest turn at the middle one of three circles in a row
 * \return for each circle the smallest index of its group
 * Source: Gr2To paper, section 4, end of the fifth stage.
 */
std::vector<std::size_t> mergeCorridors(const PlaceGraph& graph, double radiusTolerance,
                                        double angleTolerance_rad);
}  // namespace gr2to
