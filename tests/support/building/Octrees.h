#pragma once

#include <string>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/VoxelBoxes.h"

namespace gr2to::test
{
/** The bytes of OctoMap's binary file (`.bt`) of voxels; cubes stay leaves.
 * \param type  the tree type that the header tells
 */
std::string binaryOctree(const VoxelBoxes& voxels, const std::string& type = "OcTree");

/** The plan as a storey: floor, walls to the ceiling, free space between them; unknown cells stay unknown.
 *
 * The floor is the layer below z = 0, the ceiling the one above z = `height_m`; the grid may not be turned
 * and its origin has to lie on whole cells.
 */
VoxelBoxes extruded(const ClassifiedGrid& plan, double height_m);

/** Copies side by side along x and y, `count` along either axis. Their distance is a multiple of the largest
 * cube, so that all stay whole. */
VoxelBoxes tiled(const VoxelBoxes& voxels, int count);
}  // namespace gr2to::test
