#include "gr2to/grid/DistanceMap.h"

#include <gtest/gtest.h>

#include "support/drawMap.h"

using namespace gr2to;

namespace
{
/** The definition: looks at every obstacle for every free cell. */
std::int32_t slowSquaredDistance(const ClassifiedGrid& grid, Obstacles obstacles, Cell c)
{
    std::int32_t best = DistanceMap::unreachable();
    for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x) {
            const CellState state = grid.at({x, y});
            if (state == CellState::Occupied ||
                (state == CellState::Unknown && obstacles == Obstacles::OccupiedOrUnknown))
                best = std::min(best, (x - c.x) * (x - c.x) + (y - c.y) * (y - c.y));
        }
    return best;
}

void expectExact(const ClassifiedGrid& grid, Obstacles obstacles)
{
    std::vector<Cell> nearest;
    DistanceMap map;
    measureDistances(grid, obstacles, map, [&](int, const std::uint32_t* row) {
        for (int x = 0; x < grid.width(); ++x) nearest.push_back(unpackCell(row[x]));
    });
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const Cell c = grid.cell(i);
        if (grid[i] != CellState::Free) {
            ASSERT_EQ(map.squared[i], 0);
            continue;
        }
        ASSERT_EQ(map.squared[i], slowSquaredDistance(grid, obstacles, c)) << c.x << ", " << c.y;
        if (map.squared[i] == DistanceMap::unreachable()) continue;
        const Cell o = nearest[i];
        ASSERT_EQ((o.x - c.x) * (o.x - c.x) + (o.y - c.y) * (o.y - c.y), map.squared[i]);
        ASSERT_NE(grid.at(o), CellState::Free);
        ASSERT_TRUE(obstacles != Obstacles::Occupied || grid.at(o) == CellState::Occupied);
    }
}
}  // namespace

TEST(DistanceMap, equalsBruteForceOnRandomMaps)
{
    for (unsigned seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const double odds[] = {0.001, 0.02, 0.1, 0.4};
        const auto grid =
            test::randomMap(1 + static_cast<int>(seed * 7 % 53), 1 + static_cast<int>(seed * 11 % 47), seed,
                            odds[seed % 4], seed % 3 == 0 ? 0.2 : 0.0);
        expectExact(grid, Obstacles::Occupied);
        expectExact(grid, Obstacles::OccupiedOrUnknown);
    }
}

TEST(DistanceMap, isUnreachableWithoutObstacles)
{
    const ClassifiedGrid grid(5, 4, GridFrame{}, CellState::Free);
    for (const std::int32_t d : measureDistances(grid, Obstacles::Occupied).squared)
        EXPECT_EQ(d, DistanceMap::unreachable());
}

TEST(DistanceMap, unknownCellsAreObstaclesOnlyWhenAsked)
{
    const auto grid = test::drawMap({"#...?"});
    EXPECT_EQ(measureDistances(grid, Obstacles::Occupied).squared[3], 9);
    EXPECT_EQ(measureDistances(grid, Obstacles::OccupiedOrUnknown).squared[3], 1);
}
