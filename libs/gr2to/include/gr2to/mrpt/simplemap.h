#pragma once

#include <mrpt/maps/CSimpleMap.h>

#include <string>

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
/** How the scans of the keyframes are cast; section `simplemap`. */
struct TSimplemapOptions : OptionTable
{
    /** Rays for each cell of a circle around the sensor, at the scan's longest range or at `dense_range`. */
    double rays_per_cell = 2.0;
    /** Beyond it rays may lie farther apart [m]; MRPT's grids take scans up to 15 m by default. */
    double dense_range = 15.0;

    std::string section() const override { return "simplemap"; }
    std::vector<OptionField> fields() override;
};

/** The map as keyframes of MRPT's standard classes, one for each place, in the order of their ids.
 *
 * A keyframe's pose is a CPose3DPDFGaussian at the place's centre, not turned against the map frame, with the
 * variance of a position that is known to a cell, resolution^2 / 12 in x and y. Its observations:
 * - a CObservation2DRangeScan all around, `gr2to`, cast on the grid: ray i of n points to -pi + 2 pi i / n,
 *   as an MRPT grid inserts it; its range ends in the middle of what it crosses of the first occupied cell. A
 *   ray that ends at an unknown cell or at the grid's border, or only grazes a corner of an occupied cell, is
 *   invalid; its range is the free length.
 *   A corridor has more of them, one from each doorway, since nobody sees it whole from its centre;
 * - a CObservationComment with the place's XML element;
 * - a CObservationImage for each view, its image stored externally.
 *
 * The time of a keyframe is the place's id in seconds since 1970, so that the same map gives the same bytes.
 * A place whose centre is not free in the grid has no scan.
 * \param grid  the one that the map was made from
 * \throws std::invalid_argument  an option is out of range, or XML cannot hold a place
 */
mrpt::maps::CSimpleMap toSimplemap(const TopologicalMap& map, const ClassifiedGrid& grid,
                                   const TSimplemapOptions& options = {});

/** The same as the bytes of a `.simplemap` file, compressed by gzip as MRPT does it. */
std::string encodeSimplemap(const mrpt::maps::CSimpleMap& map);
}  // namespace gr2to
