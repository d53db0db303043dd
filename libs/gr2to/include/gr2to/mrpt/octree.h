#pragma once

#include <mrpt/maps/COctoMap.h>

namespace octomap
{
class OcTree;
}

namespace gr2to
{
/** The octree inside MRPT's 3D map, for `Gr2To::extract()` and `GridCompressor::compress()`; lives as long as
 * the map. */
const octomap::OcTree& octreeOf(const mrpt::maps::COctoMap& map);
}  // namespace gr2to
