#pragma once

#include <vector>

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/HeightMap.h"
#include "gr2to/grid/VoronoiGraph.h"
#include "gr2to/topology/PlaceGraph.h"

namespace gr2to
{
struct TPlaceOptions : OptionTable
{
    double critical_rise = 0.05;
    double door_support = 0.25;
    bool one_door_per_candidate = false;
    double min_radius = 0.25;
    bool meet_at_narrowest = true;
    double min_depth = 0.75;
    double narrow_opening = 1.5;
    double lintel_width = 2.0;

    std::string section() const override { return "place"; }
    std::vector<OptionField> fields() override;
};

/** Fourth stage: validates doors by critical points, finds places as circles, joins them along the Voronoi
 * diagram.
 *
 * Source: Gr2To paper, section 4, fourth stage, and eq. (9) with its misprints mended (doc/algorithm.md).
 */
class PlaceBuilder
{
 public:
    /** \throws std::invalid_argument  an option is out of range */
    explicit PlaceBuilder(TPlaceOptions options);

    /** Local minima of the clearance along the diagram, in raster order. */
    std::vector<CriticalPoint> criticalPoints(const VoronoiGraph& voronoi, const DistanceMap& distances,
                                              double resolution_m) const;

    /** The doors that a critical point supports: of the points closer than `door_support` to a likely cell
     * the narrowest.
     *
     * Along walls that run askew to the grid, and between neighbouring doors, likely cells chain together to
     * one candidate; unless `one_door_per_candidate` it then has as many doors as there are supporting points
     * that are as narrow as a door and whose circles do not hold a narrower one's centre.
     *
     * Its line runs from the nearest obstacle over the critical point to the nearest obstacle on the other
     * side. \param obstacles  what the distances were measured to
     * \param heights  of a 3D map: points under a lintel no wider than `lintel_width` are doors without a
     * candidate, being the strongest evidence there is \return in raster order of their critical points
     */
    std::vector<ValidatedDoor> validate(const std::vector<DoorCandidate>& candidates,
                                        const std::vector<CriticalPoint>& points, const ClassifiedGrid& grid,
                                        Obstacles obstacles, const HeightMap& heights = {}) const;

    /** Circles, eq. (9), and their links; a door that does not part two places is dropped.
     *
     * Every connected part of the diagram, cut at the doors, that holds a circle of `min_radius` has a place.
     */
    PlaceGraph build(std::vector<ValidatedDoor> doors, const VoronoiGraph& voronoi,
                     const ClassifiedGrid& grid, Obstacles obstacles, const DistanceMap& distances,
                     const HeightMap& heights = {}) const;

 private:
    TPlaceOptions m_options;
};
}  // namespace gr2to
