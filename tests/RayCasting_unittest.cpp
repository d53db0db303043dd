#include "gr2to/grid/RayCasting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/drawMap.h"

namespace gr2to::test
{
namespace
{
/** The part of a ray that lies in a cell, by the cell's four sides. */
struct Chord
{
    double enter = 0;
    double leave = std::numeric_limits<double>::infinity();

    void cut(double start, double direction, int cell)
    {
        double low = (cell - 0.5 - start) / direction, high = (cell + 0.5 - start) / direction;
        if (low > high) std::swap(low, high);
        enter = std::max(enter, low);
        leave = std::min(leave, high);
    }
};

/** The slow way: of all cells that the ray crosses and that are not free, the one that it enters first. */
RayEnd firstObstacle(const ClassifiedGrid& grid, const Eigen::Vector2d& start, const Eigen::Vector2d& d)
{
    RayEnd first;
    first.enter = std::numeric_limits<double>::infinity();
    for (int y = -1; y <= grid.height(); ++y)
        for (int x = -1; x <= grid.width(); ++x) {
            if (grid.isFree({x, y})) continue;
            Chord chord;
            chord.cut(start.x(), d.x(), x);
            chord.cut(start.y(), d.y(), y);
            if (chord.enter >= chord.leave || chord.enter >= first.enter) continue;
            const CellState state = grid.contains({x, y}) ? grid.at({x, y}) : CellState::Unknown;
            first = {{x, y}, state, chord.enter, chord.leave};
        }
    return first;
}
}  // namespace

TEST(RayCasting, endsWhereTheSlowWayDoes)
{
    constexpr unsigned SEED = 5;
    std::mt19937 random(SEED);
    std::uniform_real_distribution<double> anywhere(0, 24), angle(-M_PI, M_PI), share(0, 1);
    int hits = 0;
    for (int round = 0; round < 200; ++round) {
        ClassifiedGrid grid(25, 25, GridFrame{}, CellState::Free);
        for (std::size_t i = 0; i < grid.size(); ++i) {
            const double p = share(random);
            if (p < 0.08) grid[i] = p < 0.04 ? CellState::Occupied : CellState::Unknown;
        }
        for (int i = 0; i < 50; ++i) {
            const Eigen::Vector2d start(anywhere(random), anywhere(random));
            const double a = angle(random);
            const Eigen::Vector2d direction(std::cos(a), std::sin(a));
            SCOPED_TRACE("seed " + std::to_string(SEED) + ", round " + std::to_string(round));
            const RayEnd fast = castRay(grid, start, direction), slow = firstObstacle(grid, start, direction);
            EXPECT_EQ(fast.cell, slow.cell);
            EXPECT_EQ(fast.state, slow.state);
            EXPECT_NEAR(fast.enter, slow.enter, 1e-9);
            EXPECT_NEAR(fast.leave, slow.leave, 1e-9);
            hits += fast.enter > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(hits, 5000);
}

TEST(RayCasting, alongAnAxisAndOutOfTheGrid)
{
    const ClassifiedGrid grid = drawMap({"....#", "....."}, 1);
    const RayEnd wall = castRay(grid, {0, 1}, {1, 0});
    EXPECT_EQ(wall.cell, (Cell{4, 1}));
    EXPECT_EQ(wall.state, CellState::Occupied);
    EXPECT_DOUBLE_EQ(wall.enter, 3.5);
    EXPECT_DOUBLE_EQ(wall.leave, 4.5);
    const RayEnd border = castRay(grid, {0, 0}, {1, 0});
    EXPECT_EQ(border.cell, (Cell{5, 0}));
    EXPECT_EQ(border.state, CellState::Unknown);
    EXPECT_DOUBLE_EQ(border.enter, 4.5);
    EXPECT_EQ(castRay(grid, {2, 0}, {0, -1}).cell, (Cell{2, -1}));
}

TEST(RayCasting, aCornerLetsThroughUnlessBothSidesAreShut)
{
    const double half = std::sqrt(0.5);
    EXPECT_EQ(castRay(drawMap({"..#", "#..", ".#."}, 1), {0, 0}, {half, half}).cell, (Cell{1, 0}));
    EXPECT_EQ(castRay(drawMap({"..#", "#..", "..."}, 1), {0, 0}, {half, half}).cell, (Cell{2, 2}));
    EXPECT_EQ(castRay(drawMap({"..#", "...", ".#."}, 1), {0, 0}, {half, half}).cell, (Cell{2, 2}));
}

TEST(RayCasting, startsInAnObstacleWithoutLength)
{
    const RayEnd end = castRay(drawMap({"#."}, 1), {0, 0}, {1, 0});
    EXPECT_EQ(end.cell, (Cell{0, 0}));
    EXPECT_EQ(end.enter, 0);
    EXPECT_DOUBLE_EQ(end.leave, 0.5);
}
}  // namespace gr2to::test
