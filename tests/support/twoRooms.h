#pragma once

#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/view/Overlay.h"

namespace gr2to::test
{
/** Two rooms of 41 x 21 cells of 0.1 m in all, with one of everything that an overlay shows.
 *
 * The wall x = 20 has a real door at y = 8 ... 12 and a virtual opening at y = 15 ... 18. Place 1 (left) has
 * a real wall y = 0 and its vertex at (10, 10); place 2 has a virtual wall x = 30, y = 2 ... 9 and its vertex
 * at (30, 12). The Voronoi diagram is the row y = 10, its critical point lies in the door. The top right cell
 * is unknown.
 */
struct TwoRooms
{
    explicit TwoRooms(const GridFrame& frame = GridFrame{0.1, 0, 0, 0});

    OverlayInput input() const { return {grid, places, voronoi, criticalPoints, map}; }
    /** Puts the real door's centre on another cell. */
    void moveDoor(double column, double row);

    ClassifiedGrid grid;
    PlaceImage places{41, 21};
    VoronoiGraph voronoi;
    std::vector<CriticalPoint> criticalPoints;
    TopologicalMap map;

 private:
    void addMap(double doorColumn, double doorRow);
};
}  // namespace gr2to::test
