#pragma once

#include <string>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to::test
{
/** A grid from a drawing: '#' is occupied, '?' unknown, all else free; the first row is the top (largest y).
 */
ClassifiedGrid drawMap(const std::vector<std::string>& rows, double resolution_m = 0.05);

/** A random grid of seeded noise: each cell occupied, unknown or free with the given odds. */
ClassifiedGrid randomMap(int width, int height, unsigned seed, double occupied = 0.3, double unknown = 0.05);
}  // namespace gr2to::test
