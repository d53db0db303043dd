#pragma once

#include <functional>

#include "gr2to/topology/TopologicalMap.h"

namespace gr2to::test
{
/** A valid place of 12 m2 with a word, a triangular boundary, a view, and walls 10 id and 10 id + 1. */
Place somePlace(PlaceId id);

/** A valid connection with a word, a doorway of 0.9 m and a view. */
Connection someConnection(std::uint32_t id, PlaceId from, PlaceId to);

/** A valid map: places 1, 3 and 5, the last two joined by connection 7, which may be changed before it is
 * added. */
TopologicalMap someMap(const std::function<void(Connection&)>& change = [](Connection&) {});
}  // namespace gr2to::test
