#pragma once

#include "gr2to/topology/FaceMerging.h"
#include "gr2to/topology/PlaceGraph.h"

namespace gr2to
{
struct RegionGraphRules
{
    double minDoor_cells = 10;
    double maxDoor_cells = 30;
    double minLoneArea_cells = 300;  //!< of a place without passages
};

/** Places, doors and openings of regions and their borders.
 *
 * A place is a region that has a passage, or is large enough without one and as wide as the narrowest door;
 * its circle is the region's largest. A border as wide as a door is a door, a wider one an opening; narrower
 * ones connect nothing.
 *
 * \param distances  clearance from `obstacles`
 * \throws OutputError  more places than PlaceId can number
 */
PlaceGraph graphOfRegions(const Regions& regions, const VoronoiGraph& voronoi, const ClassifiedGrid& grid,
                          Obstacles obstacles, const DistanceMap& distances, const RegionGraphRules& rules);
}  // namespace gr2to
