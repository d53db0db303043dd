#pragma once

#include <string>
#include <vector>

#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/VoronoiGraph.h"

namespace gr2to::test
{
/** Curves drawn by hand, with the clearance along them. */
struct DrawnCurves
{
    VoronoiGraph voronoi;
    DistanceMap distances;
};

/** A digit from 1 to 9 is a cell of the curves with that clearance in cells; the first row is the top. */
DrawnCurves drawCurves(const std::vector<std::string>& rows);
}  // namespace gr2to::test
