#pragma once

#include <vector>

#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/Padded.h"

namespace gr2to
{
/** Thins the free space to curves one cell wide, 4-connected, with the same components and holes.
 *
 * Cells are removed in the order of their clearance, smallest first, as long as the topology allows; the
 * anchors stay until all others are gone, then they are thinned themselves, keeping their ends.
 * \param anchors  where the curves must pass, as from SeparationFinder \return the remaining cells are 1
 * Cost: linear in the number of free cells.
 */
Mask thin(const ClassifiedGrid& grid, const DistanceMap& distances, const std::vector<Cell>& anchors);
}  // namespace gr2to
