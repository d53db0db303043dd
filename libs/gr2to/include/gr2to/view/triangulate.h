#pragma once

#include <mrpt/math/TPoint2D.h>

#include <array>
#include <vector>

namespace gr2to
{
/** Triangles that cover a simple polygon, by cutting ears; each one as three indices of vertices,
 * counter-clockwise.
 *
 * \param polygon  counter-clockwise; of one that crosses itself, some parts may be left out or covered twice
 * Cost: quadratic in the number of vertices.
 */
std::vector<std::array<std::size_t, 3>> triangulate(const std::vector<mrpt::math::TPoint2D>& polygon);
}  // namespace gr2to
