#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gr2to/pipeline/Gr2To.h"
#include "support/polygons.h"

namespace gr2to::test
{
/** The cells of each place's largest 4-connected patch; all others are 0. */
PlaceImage largestPatches(const PlaceImage& places);

/** Everything that is wrong with the outlines of a map, by rules that are checked cell by cell and side by
 * side: each is simple and counter-clockwise; its area is within 2 % of that of the place's largest patch;
 * two outlines meet nowhere but in common vertices and sides; a corner of cells where three places, or two
 * and none, meet is a vertex of each; places with cells side by side have common sides about as long. */
std::vector<std::string> breachesOfOutlines(const Extraction& e);

/** Sides that two outlines have in common, each from start to end on the first. */
std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> commonSides(const Polygon& a, const Polygon& b);
}  // namespace gr2to::test
