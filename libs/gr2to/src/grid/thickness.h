#pragma once

#include "gr2to/grid/LineDirection.h"

namespace gr2to
{
/** Rows across a digital line that are not free around one of its cells, counted up to one more than `most`
 * to either side. */
inline int thicknessAcross(const ClassifiedGrid& grid, const LineDirection& direction, int step, int row,
                           int most)
{
    int up = 0, down = 0;
    while (up <= most && !grid.isFree(direction.cell(step, row + up))) ++up;
    while (down <= most && !grid.isFree(direction.cell(step, row - down))) ++down;
    return up + down - 1;
}
}  // namespace gr2to
