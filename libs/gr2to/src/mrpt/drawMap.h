#pragma once

#include <mrpt/opengl/CSetOfObjects.h>

#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
/** The map as objects of MRPT's 3D scenes: boundaries on the floor, upright walls and doors, and the graph of
 * the places above them. Walls and doors without a measured height are drawn 2.5 m and 2 m high. */
mrpt::opengl::CSetOfObjects::Ptr drawMap(const TopologicalMap& map);
}  // namespace gr2to
