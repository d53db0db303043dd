#pragma once

#include "gr2to/topology/PlaceGraph.h"

namespace gr2to
{
/** Merges circles that no real narrowing parts, as the basins of a landscape merge over shallow saddles.
 *
 * Links are taken from wide to narrow; the two places of a link become one when its clearance is more than
 * `minDepth` of the smaller of their largest circles. A door whose link merges was none and is dropped; one
 * with a lintel never merges. \param minDepth  ratio of a narrowing's width to the smaller place's beyond
 * which it is none; 1 merges nothing \return the graph with the largest circle of each merged place Source:
 * eq. (9) carried on; persistence of the clearance's peaks, Edelsbrunner et al., DCG 2002.
 */
PlaceGraph mergeShallow(const PlaceGraph& graph, double minDepth);
}  // namespace gr2to
