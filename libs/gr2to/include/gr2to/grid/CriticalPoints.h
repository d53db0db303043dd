#pragma once

#include <vector>

#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/VoronoiGraph.h"

namespace gr2to
{
/** Local minima of the clearance along the Voronoi diagram.
 *
 * A stretch of least clearance counts when, along the diagram and to both sides, the clearance rises above it
 * by at least `minRise_cells` before it falls below it. Of a level stretch the middle cell is taken. \param
 * minRise_cells  ripples smaller than this come from digitisation [cells] \return in raster order Source:
 * Thrun, AIJ 1998 (critical points); Gr2To paper, section 4, fourth stage.
 */
std::vector<CriticalPoint> findCriticalPoints(const VoronoiGraph& voronoi, const DistanceMap& distances,
                                              double minRise_cells);
}  // namespace gr2to
