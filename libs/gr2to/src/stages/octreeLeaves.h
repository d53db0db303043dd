#pragma once

#include "gr2to/grid/VoxelBoxes.h"

namespace octomap
{
class OcTree;
}

namespace gr2to
{
/** The leaves of a tree whose occupancy probability is at most `p_max` (free) or at least `p_min` (occupied).
 */
VoxelBoxes leavesOf(const octomap::OcTree& tree, double p_max, double p_min);
}  // namespace gr2to
