#pragma once

#include <vector>

#include "gr2to/grid/PlaceImage.h"
#include "gr2to/grid/VoronoiGraph.h"

namespace gr2to
{
/** Gives every free cell a place: the one whose stretch of the Voronoi diagram lies in the same region
 * between borders.
 *
 * Borders are lines of cells from obstacle to obstacle across the diagram, such as closed doors. Where they
 * fail to part two places, the places' labels spread from the diagram at equal speed and meet half-way. The
 * border's own cells go to a place beside them. Free cells that no label can reach, such as pockets inside
 * furniture or specks seen through a window, get the place that is nearest in a straight line. \param
 * placeOfCell  for each of VoronoiGraph::cells its place, 0 for none \param borders  free cells, in any order
 * Cost: linear in the number of cells.
 */
PlaceImage partition(const ClassifiedGrid& grid, const VoronoiGraph& voronoi,
                     const std::vector<PlaceId>& placeOfCell, const std::vector<Cell>& borders);

/** Gives the free cells that have no place yet one: labels spread from those that have, then the nearest
 * counts. Cost: linear in the number of cells. */
void fillUnlabelled(const ClassifiedGrid& grid, PlaceImage& image);
}  // namespace gr2to
