#include "gr2to/grid/WallSegments.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/rooms.h"

using namespace gr2to;

namespace
{
constexpr double kPi = 3.14159265358979323846;

/** A band of occupied cells through the middle of a free grid. */
ClassifiedGrid wallAt(double angle_rad, int side = 120, int halfLength = 30)
{
    ClassifiedGrid grid(side, side, GridFrame{}, CellState::Free);
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double dx = x - side / 2, dy = y - side / 2;
            if (std::abs(c * dx + s * dy) <= halfLength && std::abs(c * dy - s * dx) <= 1.5)
                grid.set({x, y}, CellState::Occupied);
        }
    return grid;
}
}  // namespace

TEST(LineDirection, everyCellLiesOnTheLineOfItsRow)
{
    for (const double angle : {0.0, 0.3, 0.78, 0.8, 1.5, 2.0, 3.0}) {
        const LineDirection d(angle);
        for (int y = -9; y <= 9; ++y)
            for (int x = -9; x <= 9; ++x)
                EXPECT_EQ(d.cell(d.step({x, y}), d.row({x, y})), (Cell{x, y})) << angle;
        EXPECT_NEAR(d.doubleCos(), std::cos(2 * angle), 1e-12);
        EXPECT_NEAR(d.doubleSin(), std::sin(2 * angle), 1e-12);
    }
}

TEST(WallOrientation, dominantDirectionIsTheWalls)
{
    for (int degrees = 0; degrees < 180; degrees += 20) {
        const auto cells = measureWallOrientation(wallAt(degrees * kPi / 180), 3);
        const auto directions = dominantDirections(cells, 1, 0.1);
        ASSERT_EQ(directions.size(), 1u) << degrees;
        const double found =
            0.5 * std::atan2(directions[0].doubleSin(), directions[0].doubleCos()) * 180 / kPi;
        EXPECT_NEAR(std::remainder(found - degrees, 180.0), 0, 1.5) << degrees;
    }
}

TEST(WallOrientation, gridsWithoutWallsHaveNoDirection)
{
    const ClassifiedGrid grid(40, 40, GridFrame{}, CellState::Free);
    EXPECT_TRUE(measureWallOrientation(grid, 3).empty());
    EXPECT_TRUE(dominantDirections({}, 6, 0.1).empty());
}

TEST(WallSegments, oneWallIsOneSegmentOfItsLength)
{
    for (int degrees = 0; degrees < 180; degrees += 20) {
        const auto cells = measureWallOrientation(wallAt(degrees * kPi / 180), 3);
        const auto directions = dominantDirections(cells, 1, 0.1);
        const auto segments = findWallSegments(cells, directions, WallSegmentRules{});
        ASSERT_EQ(segments.size(), 1u) << degrees;
        EXPECT_NEAR((segments[0].end - segments[0].begin + 1) * directions[0].stretch(), 61, 9) << degrees;
    }
}

TEST(WallSegments, aDoorPartsAWallAndACrackDoesNot)
{
    const auto segmentsWithGap = [](int gap) {
        ClassifiedGrid grid = wallAt(0);
        test::carve(grid, {60, 50}, {59 + gap, 70});
        const auto cells = measureWallOrientation(grid, 3);
        return findWallSegments(cells, {LineDirection(0.0)}, WallSegmentRules{}).size();
    };
    EXPECT_EQ(segmentsWithGap(18), 2u);
    EXPECT_EQ(segmentsWithGap(1), 1u);
}
