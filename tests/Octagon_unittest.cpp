#include "gr2to/topology/Octagon.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/drawMap.h"
#include "support/rooms.h"

using namespace gr2to;

namespace
{
constexpr double kPi = 3.14159265358979323846;

Octagon grow(const ClassifiedGrid& grid, const Circle& circle, const std::vector<Circle>& neighbours)
{
    const DistanceMap distances = measureDistances(grid, Obstacles::OccupiedOrUnknown);
    return OctagonGrower(grid, distances, 0).grow(circle, neighbours);
}

double distanceTo(const Octagon& octagon, std::size_t k, Cell center)
{
    return (octagon[k] - Eigen::Vector2d(center.x, center.y)).norm();
}

double areaOf(const std::vector<Eigen::Vector2d>& polygon)
{
    double twice = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const auto &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
}
}  // namespace

TEST(Octagon, reachesIntoTheCornersOfARoom)
{
    ClassifiedGrid grid = test::solid(41, 41);
    test::carve(grid, {1, 1}, {39, 39});
    const Octagon octagon = grow(grid, {{20, 20}, 20}, {});
    for (const std::size_t corner : {1u, 3u, 5u, 7u})
        EXPECT_NEAR(distanceTo(octagon, corner, {20, 20}), 20 * std::sqrt(2.0), 1.5) << corner;
    const std::vector<Eigen::Vector2d> vertices(octagon.begin(), octagon.end());
    EXPECT_GT(areaOf(vertices), 0.85 * 40 * 40) << "counter-clockwise";
    EXPECT_LE(areaOf(vertices), 40 * 40);
}

TEST(Octagon, verticesStayInTheirBeams)
{
    ClassifiedGrid grid = test::solid(81, 51);
    test::carve(grid, {1, 1}, {79, 49});
    const Octagon octagon = grow(grid, {{30, 21}, 21}, {});
    for (std::size_t k = 0; k < 8; ++k) {
        const double angle = std::atan2(octagon[k].y() - 21, octagon[k].x() - 30);
        const double off = std::remainder(angle - 2 * kPi * static_cast<double>(k) / 8, 2 * kPi);
        EXPECT_LE(std::abs(off), kPi / 8 + 1e-9) << k;
        EXPECT_GE(distanceTo(octagon, k, {30, 21}), 20.99) << k;
    }
}

TEST(Octagon, neighbourInABeamLimitsItByEquation10)
{
    ClassifiedGrid grid = test::solid(101, 41);
    test::carve(grid, {1, 1}, {99, 39});
    const Circle circle{{20, 20}, 20};
    const Octagon octagon = grow(grid, circle, {{{70, 20}, 15}, {{90, 20}, 1}});
    EXPECT_NEAR(distanceTo(octagon, 0, circle.center), 20.0 / (20 + 15) * 50, 1e-9) << "the closest counts";
    EXPECT_GT(distanceTo(octagon, 7, circle.center), 25) << "a neighbour in another beam does not";
}

TEST(Octagon, rayEndsAtTheUnknown)
{
    ClassifiedGrid grid = test::solid(61, 21);
    test::carve(grid, {1, 1}, {59, 19});
    for (int y = 0; y < 21; ++y)
        for (int x = 30; x < 61; ++x) grid.set({x, y}, CellState::Unknown);
    const Octagon octagon = grow(grid, {{10, 10}, 10}, {});
    EXPECT_LE(octagon[0].x(), 30.0);
    EXPECT_NEAR(octagon[0].x(), 29.0, 1.0);
}

TEST(Octagon, closedDoorStopsIt)
{
    ClassifiedGrid grid = test::twoSquareRooms(17);
    const DistanceMap distances = measureDistances(grid, Obstacles::Occupied);
    EXPECT_GT(grow(grid, {{30, 30}, 30}, {})[0].x(), 90);
    for (int y = 22; y <= 38; ++y) grid.set({60, y}, CellState::Occupied);
    EXPECT_LE(OctagonGrower(grid, distances, 17).grow({{30, 30}, 30}, {})[0].x(), 60.5);
}

TEST(Octagon, raysThatLeapSeeWhatRaysSeeThatStep)
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        const double odds[] = {0.001, 0.01, 0.05, 0.2};
        ClassifiedGrid grid = test::randomMap(70, 55, seed, odds[seed % 4], seed % 3 ? 0.0 : 0.01);
        const DistanceMap distances = measureDistances(grid, Obstacles::OccupiedOrUnknown);
        DistanceMap nothingKnown = distances;
        for (std::int32_t& squared : nothingKnown.squared) squared = 0;
        const int door = static_cast<int>(seed % 9);  // closed between two obstacles' surroundings
        for (int k = 0; k < door; ++k)
            if (const Cell c{20 + k, 30}; grid.isFree(c) && distances.clearance_cells(c) <= door / 2.0)
                grid.set(c, CellState::Occupied);
        const OctagonGrower leaping(grid, distances, door), stepping(grid, nothingKnown, door);
        for (const Cell center : {Cell{22, 20}, Cell{35, 27}, Cell{60, 50}}) {
            if (!grid.isFree(center)) continue;
            const Circle circle{center, distances.clearance_cells(center)};
            const Octagon fast = leaping.grow(circle, {}), slow = stepping.grow(circle, {});
            for (std::size_t v = 0; v < 8; ++v)
                EXPECT_LT((fast[v] - slow[v]).norm(), 1e-9) << "seed " << seed << ", vertex " << v;
        }
    }
}

TEST(ConvexHull, ofASquareWithPointsInsideAndOnItsSidesIsTheSquare)
{
    const auto hull = convexHull({{0, 0}, {2, 2}, {1, 1}, {2, 0}, {1, 0}, {0, 2}, {2, 1}, {0, 0}});
    const std::vector<Eigen::Vector2d> expected{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    EXPECT_EQ(hull, expected);
}

TEST(ConvexHull, holdsAllPointsAndTurnsLeft)
{
    std::vector<Eigen::Vector2d> points;
    for (int k = 0; k < 200; ++k)
        points.emplace_back(std::fmod(k * 37.0, 101) / 7, std::fmod(k * k * 13.0, 97) / 5);
    const auto hull = convexHull(points);
    ASSERT_GE(hull.size(), 3u);
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const auto &a = hull[k], &b = hull[(k + 1) % hull.size()], &c = hull[(k + 2) % hull.size()];
        EXPECT_GT((b - a).x() * (c - b).y() - (b - a).y() * (c - b).x(), 0);
        for (const auto& p : points) EXPECT_GE((b - a).x() * (p - a).y() - (b - a).y() * (p - a).x(), -1e-9);
    }
}
