#pragma once

#include "gr2to/topology/TopologicalMap.h"

namespace gr2to::test
{
/** A valid map of odd contents, the same for the same seed.
 *
 * Places with gaps between their ids, isolated places, parallel connections, views on places and doorways,
 * absent heights, zero and full-rank covariances, words of several scripts and with XML's special characters,
 * and numbers such as 0.1 + 0.2, 1e-300, the smallest denormal and the largest double.
 */
TopologicalMap randomTopologicalMap(unsigned seed);
}  // namespace gr2to::test
