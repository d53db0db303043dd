#pragma once

#include "gr2to/pipeline/Gr2To.h"
#include "support/rooms.h"

namespace gr2to::test
{
/** What the second to fourth stages make of a grid, with all that is in between. */
struct Topology
{
    Diagram diagram;
    std::vector<DoorCandidate> candidates;
    std::vector<CriticalPoint> criticalPoints;
    std::vector<ValidatedDoor> doors;  //!< before the useless ones are dropped
    PlaceGraph graph;
};
Topology topologyOfPlaces(const ClassifiedGrid& grid,
                          const Gr2ToOptions& options = Gr2ToOptions::preset("paper"));
}  // namespace gr2to::test
