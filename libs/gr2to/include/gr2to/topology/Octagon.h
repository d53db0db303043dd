#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "gr2to/grid/Circles.h"

namespace gr2to
{
/** Eight vertices around a circle, counter-clockwise from the right, in continuous grid coordinates [cells].
 */
using Octagon = std::array<Eigen::Vector2d, 8>;

/** Widens a circle's octagon to the farthest occupied cell that is seen from the centre inside each vertex'
 * beam.
 *
 * A vertex goes no farther than r_i / (r_i + r_j) times the distance to the closest neighbour j inside its
 * beam, eq. (10). Where no occupied cell is seen, it goes as far as the free space is seen, under the same
 * limit. \param closedDoors  grid in which the doors are drawn as occupied cells \param neighbours  circles
 * joined to this one along the Voronoi diagram
 */
Octagon growOctagon(const ClassifiedGrid& closedDoors, const Circle& circle,
                    const std::vector<Circle>& neighbours);

/** Convex hull, counter-clockwise, without collinear vertices. Source: Andrew's monotone chain. */
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);
}  // namespace gr2to
