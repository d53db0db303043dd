#include "gr2to/topology/PlaceGraph.h"

#include <algorithm>

namespace gr2to
{
double widestDoor_cells(const PlaceGraph& graph)
{
    double widest = 0;
    for (const ValidatedDoor& door : graph.doors)
        widest = std::max(widest, distance_cells(door.jambA, door.critical.cell) +
                                      distance_cells(door.critical.cell, door.jambB));
    return widest;
}
}  // namespace gr2to
