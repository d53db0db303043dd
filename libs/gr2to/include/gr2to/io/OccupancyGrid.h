#pragma once

#include "gr2to/grid/ClassifiedGrid.h"

namespace mrpt::maps
{
class COccupancyGridMap2D;
}

namespace gr2to
{
/** Occupancy probabilities at which a cell counts as known. */
struct OccupancyThresholds
{
    double occupied = 0.65;  //!< occupied above it
    double free = 0.35;      //!< free below it
};

/** Classifies the cells of an MRPT grid.
 *
 * The occupancy probability is 1 - p, with p MRPT's probability of being free, the logistic function of the
 * stored log-odds. A log-odds of 0 is unknown whatever the thresholds. Limits and resolution, which MRPT
 * keeps as floats, become the shortest decimals that round to them (0.05 and not 0.0500000007). \throws
 * InputError  the grid has no cells Cost: one table look-up a cell.
 */
ClassifiedGrid fromOccupancyGrid(const mrpt::maps::COccupancyGridMap2D& map,
                                 const OccupancyThresholds& thresholds = {});

/** The classified cells as an MRPT grid: free and occupied as sure as its log-odds can say, unknown as even
 * odds. \throws InputError  the grid's frame is turned, which MRPT's grids cannot be
 */
mrpt::maps::COccupancyGridMap2D toOccupancyGrid(const ClassifiedGrid& grid);
}  // namespace gr2to
