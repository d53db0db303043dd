#pragma once

#include <cstdint>
#include <vector>

#include "gr2to/grid/LineDirection.h"

namespace gr2to
{
/** An occupied cell near free ones, and the direction in which the wall runs there. */
struct WallCell
{
    Cell cell;
    float doubleCos = 0;  //!< cosine and sine of twice the direction's angle times the coherence:
    float doubleSin = 0;  //!< a vector of length 1 on a straight wall, 0 where no direction prevails
    float weight = 0;     //!< strength of the evidence: how much of the free space's rim is near
};

/** Measures which way walls run, by the structure tensor of the free space.
 *
 * The gradient of the mask of free cells is squared (as a tensor) and averaged over a window of
 * `window_cells`. \return in raster order, the occupied cells within the window of the free space's rim Cost:
 * linear in the number of cells. Source: Bigun and Granlund, ICCV 1987.
 */
std::vector<WallCell> measureWallOrientation(const ClassifiedGrid& grid, double window_cells);

/** The directions in which most walls run: peaks of the histogram of orientations, the strongest first.
 * \param most  how many at most  \param least  part of the strongest that a direction has to have
 */
std::vector<LineDirection> dominantDirections(const std::vector<WallCell>& cells, std::size_t most,
                                              double least);
}  // namespace gr2to
