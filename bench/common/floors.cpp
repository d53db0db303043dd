#include "common/floors.h"

#include <algorithm>

#include "support/BuildingGenerator.h"

namespace gr2to::bench
{
ClassifiedGrid floorOfSide(int side, Growth growth)
{
    constexpr double BUILDING_M = 51.2;
    constexpr int BUILDING_CELLS = 1024;
    constexpr double TILE_M = 25.6;
    test::TBuildingOptions options;
    options.seed = 7;
    options.furniture = 0.1;
    options.margin = 0;
    if (growth == Growth::Resolution) {
        options.resolution = BUILDING_M / side;
        side = BUILDING_CELLS;
    }
    const double length = BUILDING_M * side / BUILDING_CELLS;
    const int tiles = std::max(1, static_cast<int>(length / TILE_M));
    options.tiles_x = tiles;
    options.tiles_y = tiles;
    options.width = length / tiles;
    options.height = length / tiles;
    return test::generateBuilding(options).grid;
}

ClassifiedGrid upscaled(const ClassifiedGrid& grid, int factor)
{
    GridFrame frame = grid.frame();
    frame.resolution_m /= factor;
    ClassifiedGrid result(grid.width() * factor, grid.height() * factor, frame);
    for (int y = 0; y < result.height(); ++y) {
        const CellState* from = grid.row(y / factor);
        CellState* to = result.row(y);
        for (int x = 0; x < result.width(); ++x) to[x] = from[x / factor];
    }
    return result;
}
}  // namespace gr2to::bench
