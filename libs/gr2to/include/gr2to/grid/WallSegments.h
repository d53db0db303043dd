#pragma once

#include <vector>

#include "gr2to/grid/WallOrientation.h"

namespace gr2to
{
/** A straight stretch of wall along one of the dominant directions. */
struct WallSegment
{
    std::size_t direction = 0;     //!< index among the dominant directions
    int begin = 0, end = 0;        //!< first and last step along the direction
    int beginRow = 0, endRow = 0;  //!< rows in the middle of the wall at its ends
    Cell cell;                     //!< one of the wall's
};

struct WallSegmentRules
{
    double minLength_cells = 10;
    double maxGap_cells = 6;
    double maxAngle_deg = 15;
    double minCoherence = 0.4;
};

/** Finds straight stretches of wall: runs of wall cells along digital lines, joined over neighbouring rows.
 */
std::vector<WallSegment> findWallSegments(const std::vector<WallCell>& cells,
                                          const std::vector<LineDirection>& directions,
                                          const WallSegmentRules& rules);
}  // namespace gr2to
