#pragma once

#include <vector>

#include "gr2to/grid/PlaceImage.h"
#include "gr2to/grid/VoronoiGraph.h"

namespace gr2to
{
/** Gives every free cell the place of the nearest labelled cell of the Voronoi diagram, as the free space
 * allows.
 *
 * Labels spread from the diagram at equal speed (steps over sides and over corners in turn, close to
 * Euclidean), never through the closed cells; those are filled last. Free cells that no label can reach, such
 * as pockets inside furniture or specks seen through a window, get the place that is nearest in a straight
 * line. \param placeOfCell  for each of VoronoiGraph::cells its place, 0 for none \param closed  cells of
 * closed doors Cost: linear in the number of cells.
 */
PlaceImage partition(const ClassifiedGrid& grid, const VoronoiGraph& voronoi,
                     const std::vector<PlaceId>& placeOfCell, const std::vector<Cell>& closed);
}  // namespace gr2to
