#include "support/pipeline.h"

namespace gr2to::test
{
Topology topologyOfPlaces(const ClassifiedGrid& grid, const Gr2ToOptions& options)
{
    const Obstacles obstacles =
        options.distance.unknown_is_obstacle ? Obstacles::OccupiedOrUnknown : Obstacles::Occupied;
    const PlaceBuilder builder(options.place);
    Topology t;
    t.diagram = diagramOf(grid, obstacles, options.voronoi.min_separation);
    t.candidates = DoorDetector(options.door).detect(grid, t.diagram.distances);
    t.criticalPoints = builder.criticalPoints(t.diagram.voronoi, t.diagram.distances, grid.resolution_m());
    t.doors = builder.validate(t.candidates, t.criticalPoints, grid, obstacles);
    t.graph = builder.build(t.doors, t.diagram.voronoi, grid, obstacles, t.diagram.distances);
    return t;
}
}  // namespace gr2to::test
