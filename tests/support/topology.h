#pragma once

#include <cstddef>
#include <functional>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to::test
{
/** Components and holes of a set of cells. */
struct PlanarTopology
{
    std::size_t components = 0;  //!< 4-connected
    std::size_t holes = 0;       //!< 8-connected components of the rest that do not reach the surroundings

    friend bool operator==(const PlanarTopology& a, const PlanarTopology& b)
    {
        return a.components == b.components && a.holes == b.holes;
    }
};

/** Counts by flood filling, slowly and surely. */
PlanarTopology topologyOf(int width, int height, const std::function<bool(Cell)>& inSet);
}  // namespace gr2to::test
