#pragma once

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/HeightMap.h"
#include "gr2to/topology/PlaceGraph.h"
#include "gr2to/topology/types.h"

namespace gr2to
{
/** The doorway of a door: it spans the gap between its jambs; each jamb is a cell whose position is known to
 * the cell's size. Its state is open, since the grid shows free cells between the jambs. */
Doorway doorwayOf(const ValidatedDoor& door, const ClassifiedGrid& grid, const HeightMap& heights);

/** The virtual doorway of a link without a door, where its two circles meet. */
Doorway openingOf(const PlaceLink& link, const ClassifiedGrid& grid, const HeightMap& heights);
}  // namespace gr2to
