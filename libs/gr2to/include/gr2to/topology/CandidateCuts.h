#pragma once

#include <cstdint>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/HeightMap.h"
#include "gr2to/grid/VoronoiGraph.h"
#include "gr2to/grid/WallSegments.h"
#include "gr2to/topology/CutEnds.h"

namespace gr2to
{
/** Where a border between places may run. */
enum class CutKind : std::uint8_t
{
    WallRay,      //!< from the end of a wall on along the wall
    WallToWall,   //!< from the end of a wall to the end of one that continues it
    CriticalLine  //!< from jamb to jamb across a critical point
};

/** A line of free cells, 8-connected, from obstacle to obstacle. */
struct CandidateCut
{
    CutKind kind = CutKind::WallRay;
    LineDirection direction;
    int row = 0;  //!< of the cut's middle
    std::vector<Cell> cells;
    std::array<CutEnd, 2> ends;  //!< at the lowest step, and at the highest
    bool lintel = false;         //!< a 3D map shows a lintel over it
};

/** How far walls are extended: a long wall's line tells more than a stub's. */
struct ExtensionRules
{
    double reach_cells = 60;    //!< of every wall
    double reachPerLength = 4;  //!< and so many times its length
    double most_cells = 400;    //!< but no farther
    double offset_cells = 3;    //!< of an opposite wall, off the line
    double skip_cells = 6;      //!< of obstacle between a wall's end and the free space ahead
};

/** Extends walls beyond their ends: towards the end of a wall that goes on in the same direction, else to the
 * next obstacle. */
std::vector<CandidateCut> extendWalls(const ClassifiedGrid& grid, const std::vector<WallSegment>& segments,
                                      const std::vector<LineDirection>& directions,
                                      const ExtensionRules& rules);

/** Notes which cuts run under a lintel, of those no longer than that. */
void lookForLintels(const ClassifiedGrid& grid, const HeightMap& heights, double maxLength_cells,
                    std::vector<CandidateCut>& cuts);

/** The critical lines of critical points as narrow as that. */
std::vector<CandidateCut> criticalCuts(const ClassifiedGrid& grid, Obstacles obstacles,
                                       const std::vector<CriticalPoint>& points, double maxLength_cells);
}  // namespace gr2to
