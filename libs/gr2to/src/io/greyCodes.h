#pragma once

#include <cstdint>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to::io
{
/** The grey that ROS's map savers write for a state. */
inline std::uint8_t greyCodeOf(CellState state)
{
    constexpr std::uint8_t codes[] = {205, 254, 0};  // in CellState's order: unknown, free, occupied
    return codes[static_cast<std::uint8_t>(state)];
}
}  // namespace gr2to::io
