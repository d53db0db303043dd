#pragma once

#include <mrpt/math/TPoint2D.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace gr2to
{
/** Two sides of a polygon that cross, by the numbers of their first vertices; nothing when none do.
 *
 * Sides that only touch, within rounding, do not cross. \param polygon  finite vertices, the first not
 * repeated Cost: quick for sides that are short against the polygon, quadratic at worst.
 */
std::optional<std::pair<std::size_t, std::size_t>> crossingSides(
    const std::vector<mrpt::math::TPoint2D>& polygon);
}  // namespace gr2to
