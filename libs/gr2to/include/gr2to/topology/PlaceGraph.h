#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "gr2to/grid/Circles.h"
#include "gr2to/grid/PlaceImage.h"
#include "gr2to/grid/VoronoiGraph.h"

namespace gr2to
{
/** A spot where a door is likely, eq. (8). */
struct DoorCandidate
{
    Cell center;              //!< the likely cell nearest to the mean of all
    std::vector<Cell> cells;  //!< likely cells, in raster order
    /** Half the widest door: the clearance of every likely cell is less. */
    double maxClearance_cells = std::numeric_limits<double>::infinity();
};

/** A door that a critical point supports; its line runs from jamb to critical point to jamb. */
struct ValidatedDoor
{
    CriticalPoint critical;
    Cell jambA;              //!< obstacle nearest to the critical point
    Cell jambB;              //!< nearest obstacle on the other side
    std::vector<Cell> line;  //!< free cells of the closed door, 8-connected from jamb to jamb
    bool lintel = false;     //!< a 3D map shows a lintel over it, the strongest evidence that it is real
};

/** Two circles joined along the Voronoi diagram. */
struct PlaceLink
{
    std::size_t from = 0;  //!< index of a circle, smaller than `to`
    std::size_t to = 0;
    Cell at;                     //!< where the two meet on the diagram
    double clearance_cells = 0;  //!< at that cell
    int door = -1;               //!< index of the door that the link passes, -1 for an opening
};

/** A line across the Voronoi diagram where two circles' stretches of it meet without a door. */
struct PlaceBorder
{
    std::size_t from = 0;  //!< index of a circle, smaller than `to`
    std::size_t to = 0;
    std::vector<Cell> line;  //!< free cells, 8-connected
};

/** Circles, doors and links: the topology that the fourth stage finds. */
struct PlaceGraph
{
    std::vector<Circle> circles;       //!< places before they are delimited, in raster order of their centres
    std::vector<ValidatedDoor> doors;  //!< in raster order of their critical points
    std::vector<PlaceLink> links;      //!< in the order of (from, to, position)
    std::vector<PlaceBorder> borders;  //!< one for every opening that a link stands for
    /** For each of VoronoiGraph::cells the circle that it belongs to, or -1: on closed doors and in pockets
     * too small. */
    std::vector<int> circleOfCell;
    /** For each cell of the grid one more than the circle that it belongs to, 0 for none yet. Empty when
     * circles are to be told apart by the diagram alone. */
    PlaceImage regions;
};

/** Length of the longest closed door, from jamb to jamb over its critical point [cells]; 0 without doors. */
double widestDoor_cells(const PlaceGraph& graph);
}  // namespace gr2to
