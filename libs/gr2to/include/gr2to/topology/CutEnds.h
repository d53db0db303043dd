#pragma once

#include <array>

#include "gr2to/grid/LineDirection.h"

namespace gr2to
{
/** What stands where a cut ends. */
struct CutEnd
{
    /** How far the obstacle goes on in the cut's line as a wall with free space on both sides [cells]; 0 when
     * there is none. */
    double fin_cells = 0;
    /** Whether the obstacle is as deep as wide, as furniture is and walls are not. */
    bool solid = false;
};

struct CutEndRules
{
    double thickest_cells = 7;  //!< wall with free space on both sides
    double longest_cells = 20;  //!< what is beyond does not count
    double solid_cells = 8;     //!< side of the square that has to be full
};

/** Looks at the ends of a straight line of free cells: at its lowest step, then at its highest.
 * \param line  free cells in the order of steps, up or down; not empty
 */
std::array<CutEnd, 2> examineEnds(const ClassifiedGrid& grid, const LineDirection& direction,
                                  const std::vector<Cell>& line, const CutEndRules& rules);
}  // namespace gr2to
