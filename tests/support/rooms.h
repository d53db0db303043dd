#pragma once

#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/VoronoiGraph.h"

namespace gr2to::test
{
/** A grid of occupied cells with its origin at (0, 0), to carve rooms from. */
ClassifiedGrid solid(int width, int height, double resolution_m = 0.05);
/** Frees the cells from one corner to the other, both included. */
void carve(ClassifiedGrid& grid, Cell from, Cell to);

/** Two rooms of 2.95 m x 2.95 m at 0.05 m a cell, side by side, a wall of 0.1 m between them.
 *
 * The rooms are cells 1-59 and 62-120 by 1-59; a door through the wall is centred on row 30.
 * \param doorCells  its width, odd; 0 for none
 */
ClassifiedGrid twoSquareRooms(int doorCells = 17);

/** What the first and third stages make of a grid, with their default options. */
struct Diagram
{
    DistanceMap distances;
    VoronoiGraph voronoi;
};
Diagram diagramOf(const ClassifiedGrid& grid, Obstacles obstacles = Obstacles::OccupiedOrUnknown,
                  double minSeparation_m = 0.5);
}  // namespace gr2to::test
