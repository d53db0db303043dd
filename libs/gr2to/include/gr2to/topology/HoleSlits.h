#pragma once

#include <cstddef>
#include <vector>

#include "gr2to/grid/LabelArcs.h"

namespace gr2to
{
/** For each label the number of the ring around its largest patch of cells, or the number of rings when it
 * has no cells. \param count  the largest label */
std::vector<std::size_t> mainRings(const LabelArcs& arcs, std::size_t count);

/** The corners of a ring, the first not repeated. */
std::vector<Eigen::Vector2d> cornersOf(const LabelArcs& arcs, const LabelRing& ring);

/** Cells that join holes of places to what is on their left: rows of the place's cells, a cell wide.
 *
 * Holes stay when they hold no other place and, counted from the smallest, make up no more than a hundredth
 * of their place. A slit may end at another hole: with the slits in the image as label 0, its arcs tell what
 * is left to do. \param arcs  of the image \return the slits' cells; none when all holes may stay
 */
std::vector<Cell> findSlits(const LabelArcs& arcs, std::size_t count, const PlaceImage& image);
}  // namespace gr2to
