#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "gr2to/grid/PlaceImage.h"

namespace gr2to
{
/** The outlines of places as polygons that neighbours share.
 *
 * A place's polygon is the outer border of its largest 4-connected patch of cells, counter-clockwise and
 * simple. Where two places touch, both polygons have the same vertices; every corner where three places, or
 * two and no place, meet is a vertex of all of them. Polygons do not cross one another. Patches that are not
 * connected to the largest lie outside of the polygon. Holes are left inside it, the smallest first, as long
 * as they make up no more than a hundredth of the place and hold no other place; each of the others is joined
 * to what is on its left by a slit one cell wide, in as many steps as it takes to reach the outside. A
 * polygon's area differs by at most a hundredth from that of the border that it simplifies.
 * \param places  labels from 1 to `count` \param tolerance_cells  largest distance of a border's corner from
 * the side that stands for it; less where sides would cross or the area would change more
 * \return by place id polygons in continuous grid coordinates [cells]; empty for 0 and ids without cells
 * Cost: that of traceArcs(), twice when there are slits, and n log n for n corners of a border.
 */
std::vector<std::vector<Eigen::Vector2d>> outlinePlaces(const PlaceImage& places, std::size_t count,
                                                        double tolerance_cells);
}  // namespace gr2to
