#pragma once

#include <map>
#include <vector>

#include "gr2to/topology/CandidateCuts.h"

namespace gr2to
{
struct FaceMergingRules
{
    double resolution_m = 0.05;
    double maxRatio = 0.8;
    double maxSumRay = 1.0;
    double maxSumWall = 1.1;
    double maxSumCritical = 0.75;
    double mouthRatio = 0.35;
    double mouthContrast = 0.6;
    double door_m = 0;
    double minRadius_m = 0;
    double minDepth_m = 0.15;
    double maxDepth_m = 1.8;
    double minFace_m2 = 0.3;
    double minPlace_m2 = 2.0;
};

/** A straight border between two regions. */
struct RegionBorder
{
    int from = 0;  //!< smaller than `to`
    int to = 0;
    Cell jambA, jambB;        //!< just beyond its ends
    Cell middle;
    double length_cells = 0;  //!< of the free cells
    std::vector<Cell> cells;
};

/** For each cell the region that it belongs to, from 1; 0 on cells that are not free. */
struct Regions
{
    std::vector<RegionBorder> borders;
    std::vector<int> ofCell;
    int count = 0;
};

/** Cuts the free space, and takes back the cuts that part nothing. */
Regions mergeFaces(const ClassifiedGrid& grid, const DistanceMap& distances, const std::vector<CandidateCut>& cuts,
                   const FaceMergingRules& rules);
}  // namespace gr2to
