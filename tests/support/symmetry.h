#pragma once

#include <string>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to::test
{
/** One of the eight ways to lay a square grid onto itself: a mirror, then quarter turns. */
struct Symmetry
{
    bool mirrored = false;  //!< left and right exchanged first
    int quarterTurns = 0;   //!< counter-clockwise

    /** Where a cell of a grid of the given size goes. */
    Cell apply(Cell c, int width, int height) const;
    /** The grid with its cells moved; its frame stays. */
    ClassifiedGrid apply(const ClassifiedGrid& grid) const;
    std::string name() const;
};

/** All but the identity. */
std::vector<Symmetry> symmetries();
}  // namespace gr2to::test
