#include "support/rooms.h"

#include "gr2to/stages/VoronoiExtraction.h"

namespace gr2to::test
{
ClassifiedGrid solid(int width, int height, double resolution_m)
{
    return {width, height, GridFrame{resolution_m, 0, 0, 0}, CellState::Occupied};
}

void carve(ClassifiedGrid& grid, Cell from, Cell to)
{
    for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) grid.set({x, y}, CellState::Free);
}

ClassifiedGrid twoSquareRooms(int doorCells)
{
    ClassifiedGrid grid = solid(122, 61);
    carve(grid, {1, 1}, {59, 59});
    carve(grid, {62, 1}, {120, 59});
    if (doorCells > 0) carve(grid, {60, 30 - doorCells / 2}, {61, 30 + doorCells / 2});
    return grid;
}

Diagram diagramOf(const ClassifiedGrid& grid, Obstacles obstacles, double minSeparation_m)
{
    TVoronoiOptions options;
    options.min_separation = minSeparation_m;
    const VoronoiExtractor extractor(options);
    Diagram diagram;
    const std::vector<Cell> separating = extractor.measure(grid, obstacles, diagram.distances);
    diagram.voronoi = extractor.trace(grid, diagram.distances, separating);
    return diagram;
}
}  // namespace gr2to::test
