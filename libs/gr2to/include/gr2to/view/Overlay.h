#pragma once

#include <string>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/PlaceImage.h"
#include "gr2to/grid/VoronoiGraph.h"
#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
/** What an overlay is drawn from; the referenced objects must outlive it. */
struct OverlayInput
{
    const ClassifiedGrid& grid;
    const PlaceImage& places;
    const VoronoiGraph& voronoi;
    const std::vector<CriticalPoint>& criticalPoints;
    const TopologicalMap& map;
};
}  // namespace gr2to
