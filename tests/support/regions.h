#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "gr2to/pipeline/Gr2To.h"

namespace gr2to::test
{
/** Places joined by openings: what a person calls a room or a corridor, bounded by walls and doors. */
struct Region
{
    double area_m2 = 0;
    std::size_t doors = 0;  //!< door ends in it
};

/** An extraction by its doors alone, however finely its halls are cut by virtual borders. */
struct DoorTopology
{
    DoorTopology(const ClassifiedGrid& grid, Extraction extraction);

    ClassifiedGrid grid;
    Extraction extraction;
    std::vector<Region> regions;
    std::vector<std::size_t> regionOfPlace;  //!< by place id; [0] is of no place
    std::vector<Cell> doors;                 //!< cells that hold the doors' positions

    std::size_t regionAt(Cell free) const { return regionOfPlace[extraction.places.at(free)]; }
};

/** What two extractions may differ by. */
struct RegionTolerance
{
    double area = 0.02;     //!< relative, of regions of at least a square metre
    double door_cells = 2;  //!< shift of a door, in cells of the second
    double minArea_m2 = 1.0;
};

/** The first difference between two extractions of one building; empty when one region or door of either
 * matches one of the other. \param move  where a cell of the first lies in the second
 */
std::string differenceBetween(const DoorTopology& a, const DoorTopology& b,
                              const std::function<Cell(Cell)>& move, const RegionTolerance& tolerance = {});
}  // namespace gr2to::test
