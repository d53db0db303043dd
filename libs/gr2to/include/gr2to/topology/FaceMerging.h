#pragma once

#include <vector>

#include "gr2to/grid/DistanceMap.h"
#include "gr2to/topology/BorderEvidence.h"
#include "gr2to/topology/CandidateCuts.h"
#include "gr2to/topology/Openness.h"

namespace gr2to
{
/** When a border is kept. */
struct FaceMergingRules
{
    OpennessRules walks;
    MouthRules mouth;
    std::vector<LineDirection> directions;  //!< that the building's walls run in
    double minEvidence = 0;                 //!< of a border that stays [nat], see borderEvidence()
    double minFace_cells = 120;             //!< smaller faces join a neighbour before all else
    double minPlace_cells = 600;            //!< smaller regions join a neighbour in the end
    double minRadius_cells = 10;            //!< so do narrower ones
};

/** A straight border between two regions. */
struct RegionBorder
{
    int from = 0;  //!< smaller than `to`
    int to = 0;
    Cell jambA, jambB;  //!< the cells just beyond its ends
    Cell middle;
    double length_cells = 0;  //!< of its free cells
    std::vector<Cell> cells;
    bool lintel = false;  //!< a 3D map shows a lintel over it
};

struct Regions
{
    std::vector<int> ofCell;  //!< from 1; 0 on cells that are not free
    int count = 0;
    std::vector<RegionBorder> borders;  //!< what is left of the cuts, in their order
};

/** Cuts the free space into faces and merges them across borders that nothing speaks for, the weakest first;
 * what a merger changes is measured anew.
 *
 * Cost: linear in the number of cells, plus the walks beside each cut, plus O(B log B) for B borders of
 * faces.
 */
Regions mergeFaces(const ClassifiedGrid& grid, const DistanceMap& distances,
                   const std::vector<CandidateCut>& cuts, const FaceMergingRules& rules);
}  // namespace gr2to
