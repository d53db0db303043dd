#pragma once

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to::bench
{
/** How a larger floor differs from a smaller one. */
enum class Growth
{
    Tiles,      //!< more rooms, cells of 0.05 m
    Resolution  //!< smaller cells, the same 51.2 m x 51.2 m building
};

/** A furnished, turned building without unknown surroundings' excess, about `side` x `side` cells; the same
 * on every run. \throws std::invalid_argument  the side asks for cells that the generator does not make
 */
ClassifiedGrid floorOfSide(int side, Growth growth = Growth::Tiles);

/** Each cell becomes `factor` x `factor` cells of the same building. */
ClassifiedGrid upscaled(const ClassifiedGrid& grid, int factor);
}  // namespace gr2to::bench
