#pragma once

#include <array>
#include <cstdint>

namespace gr2to
{
/** Whether removing a cell keeps the topology, for 4-connected figure and 8-connected ground.
 *
 * \param neighbours  bit i is set when neighbour i (counter-clockwise from the right) belongs to the figure
 */
bool isSimple(std::uint8_t neighbours);

/** isSimple() of every set of neighbours. */
const std::array<bool, 256>& simpleTable();
}  // namespace gr2to
