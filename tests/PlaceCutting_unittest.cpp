#include "gr2to/stages/PlaceCutting.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "gr2to/pipeline/Gr2To.h"
#include "gr2to/topology/FaceMerging.h"
#include "support/drawMap.h"
#include "support/messageOf.h"
#include "support/rooms.h"

using namespace gr2to;
using test::carve;
using test::solid;

namespace
{
Extraction extract(const ClassifiedGrid& grid)
{
    Extraction e = Gr2To().extract(grid);
    EXPECT_THAT(e.map.validate(), testing::IsEmpty());
    const auto without = std::count(e.places.ids.begin(), e.places.ids.end(), PlaceId{0});
    EXPECT_EQ(static_cast<std::size_t>(without), e.grid.size() - e.grid.count(CellState::Free))
        << "every free cell has a place, no other has";
    return e;
}

/** A corridor of 1.5 m along the bottom and three cubicles of 2 m by 1.2 m above it, each with a front of
 * that width. */
ClassifiedGrid cubicles(int front)
{
    ClassifiedGrid grid = solid(140, 66);
    carve(grid, {2, 2}, {137, 31});
    for (const int left : {2, 48, 94}) {
        carve(grid, {left, 36}, {left + 39, 60});
        carve(grid, {left + 20 - front / 2, 32}, {left + 19 + front / 2, 35});
    }
    return grid;
}
}  // namespace

TEST(PlaceCutting, aDoorPartsTwoRooms)
{
    const Extraction e = extract(test::twoSquareRooms(17));
    ASSERT_EQ(e.map.places().size(), 2u);
    ASSERT_EQ(e.map.graph().edgeCount(), 1u);
    const Connection connection = e.map.connections().front();
    EXPECT_TRUE(connection.doorway.real);
    EXPECT_NEAR(connection.doorway.size.length_m, 17 * 0.05, 0.051);
}

TEST(PlaceCutting, shallowCubiclesArePlacesOfTheirOwn)
{
    const Extraction e = extract(cubicles(26));
    EXPECT_EQ(e.map.places().size(), 4u);
    EXPECT_EQ(e.map.graph().edgeCount(), 3u);
}

TEST(PlaceCutting, anLShapedRoomIsOnePlace)
{
    ClassifiedGrid grid = solid(124, 124);
    carve(grid, {2, 2}, {121, 61});
    carve(grid, {2, 2}, {61, 121});
    EXPECT_EQ(extract(grid).map.places().size(), 1u);
}

TEST(PlaceCutting, aLongCorridorIsOnePlaceAndACorridor)
{
    ClassifiedGrid grid = solid(404, 40);
    carve(grid, {2, 2}, {401, 31});
    const Extraction e = extract(grid);
    ASSERT_EQ(e.map.places().size(), 1u);
    EXPECT_EQ(e.map.place(1).kind, PlaceKind::Corridor);
}

TEST(PlaceCutting, pillarsDoNotPartAHall)
{
    ClassifiedGrid grid = solid(244, 164);
    carve(grid, {2, 2}, {241, 161});
    for (int x = 60; x < 240; x += 60)
        for (int y = 40; y <= 120; y += 40)
            for (int dy = 0; dy < 8; ++dy)
                for (int dx = 0; dx < 8; ++dx) grid.set({x + dx, y + dy}, CellState::Occupied);
    EXPECT_EQ(extract(grid).map.places().size(), 1u);
}

TEST(PlaceCutting, aPieceOfWallBetweenTwoDoorsStays)
{
    ClassifiedGrid grid = test::twoSquareRooms(0);
    carve(grid, {60, 8}, {61, 22});
    carve(grid, {60, 42}, {61, 56});  // leaves 0.95 m of wall free-standing between the doors
    const Extraction e = extract(grid);
    EXPECT_EQ(e.map.places().size(), 2u);
    EXPECT_EQ(e.map.graph().edgeCount(), 2u);
}

TEST(PlaceCutting, aWallBrokenByGapsPartsRoomsAllTheSame)
{
    ClassifiedGrid grid = test::twoSquareRooms(17);
    carve(grid, {60, 1}, {61, 3});
    carve(grid, {60, 14}, {61, 16});
    carve(grid, {60, 48}, {61, 50});
    carve(grid, {60, 58}, {61, 60});  // pieces of 0.5 m stand free
    EXPECT_EQ(extract(grid).map.places().size(), 2u);
}

/** Cuts have gaps where unknown cells are no obstacles; a border with no cell of its own once crashed. */
TEST(PlaceCutting, cutsMayCrossUnknownCells)
{
    Gr2ToOptions options;
    options.distance.unknown_is_obstacle = false;
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ClassifiedGrid grid = test::randomMap(120, 90, seed, 0.02, 0.06);
        EXPECT_THAT(Gr2To(options).extract(grid).map.validate(), testing::IsEmpty());
    }
}

TEST(PlaceCutting, optionsOutOfRangeAreRefused)
{
    TCutOptions options;
    options.max_depth = -1;
    EXPECT_THAT(test::messageOf<std::invalid_argument>([&] { PlaceCutter cutter(options); }),
                testing::HasSubstr("max_depth"));
}

TEST(FaceMerging, withoutCutsEveryComponentIsARegion)
{
    ClassifiedGrid grid = test::twoSquareRooms(0);
    const DistanceMap distances = measureDistances(grid, Obstacles::OccupiedOrUnknown);
    const Regions regions = mergeFaces(grid, distances, {}, FaceMergingRules{});
    EXPECT_EQ(regions.count, 2);
    EXPECT_THAT(regions.borders, testing::IsEmpty());
    for (std::size_t i = 0; i < grid.size(); ++i)
        EXPECT_EQ(regions.ofCell[i] != 0, grid[i] == CellState::Free);
}
