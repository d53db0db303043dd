#include "gr2to/stages/SpaceDelimitation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "support/freeLabels.h"
#include "support/pipeline.h"

using namespace gr2to;
using test::carve;
using test::solid;

namespace
{
Extraction extractionOf(const ClassifiedGrid& grid)
{
    return Gr2To().extract(grid);
}

/** One room of 59 x 59 cells whose right wall is unknown between two rows. */
ClassifiedGrid roomWithUnknownStretch(int fromRow, int toRow)
{
    ClassifiedGrid grid = solid(61, 61);
    carve(grid, {1, 1}, {59, 59});
    for (int y = fromRow; y <= toRow; ++y) grid.set({60, y}, CellState::Unknown);
    return grid;
}

/** A corridor 2 m wide and 20 m long with rooms at both ends. */
ClassifiedGrid corridor()
{
    ClassifiedGrid grid = solid(600, 121);
    carve(grid, {1, 1}, {99, 119});
    carve(grid, {500, 1}, {598, 119});
    carve(grid, {103, 41}, {496, 80});
    carve(grid, {100, 52}, {102, 68});  // doors of 0.85 m
    carve(grid, {497, 52}, {499, 68});
    return grid;
}

const Wall& wallFacing(const Place& place, double x, double y)
{
    const Wall* best = &place.walls.front();
    for (const Wall& wall : place.walls)
        if (wall.normal.mean.x * x + wall.normal.mean.y * y >
            best->normal.mean.x * x + best->normal.mean.y * y)
            best = &wall;
    return *best;
}
}  // namespace

TEST(SpaceDelimiter, rectangularRoomHasRealWallsAndItsExactArea)
{
    ClassifiedGrid grid = solid(61, 61);
    carve(grid, {1, 1}, {59, 59});
    const TopologicalMap map = extractionOf(grid).map;
    ASSERT_EQ(map.places().size(), 1u);
    const Place& room = map.place(1);
    EXPECT_EQ(room.kind, PlaceKind::Room);
    EXPECT_NEAR(room.area_m2, 59 * 59 * 0.05 * 0.05, 1e-9);
    EXPECT_NEAR(room.center.x, 30.5 * 0.05, 1e-9) << "cell (30, 30), whose centre is half a cell in";
    EXPECT_NEAR(room.center.y, 30.5 * 0.05, 1e-9);
    ASSERT_GE(room.walls.size(), 4u);
    double real = 0, all = 0;
    for (const Wall& wall : room.walls) {
        real += wall.real ? wall.size.length_m : 0;
        all += wall.size.length_m;
    }
    EXPECT_GT(real / all, 0.9);
}

TEST(SpaceDelimiter, wallNormalsPointOutwards)
{
    const Extraction e = extractionOf(corridor());
    for (const auto& [id, place] : e.map.places())
        for (const Wall& wall : place.walls) {
            double inner = 1e9;  // along the normal, a wall lies farther out than the polygon's middle
            Eigen::Vector2d middle(0, 0);
            for (const auto& p : place.boundary) middle += Eigen::Vector2d(p.x, p.y);
            middle /= static_cast<double>(place.boundary.size());
            inner = wall.normal.mean.x * (wall.position.mean.x - middle.x()) +
                    wall.normal.mean.y * (wall.position.mean.y - middle.y());
            EXPECT_GT(inner, 0) << "place " << id << ", wall " << wall.id;
            EXPECT_NEAR(wall.normal.mean.norm(), 1, 1e-12);
        }
}

TEST(SpaceDelimiter, sideIsRealWhenOver80PercentOfItAreOccupied)
{
    // The right side runs over about 25 rows around row 30 or, with corners, over all of them.
    const TopologicalMap whole = extractionOf(roomWithUnknownStretch(1, 0)).map;
    EXPECT_TRUE(wallFacing(whole.place(1), 1, 0).real);
    const TopologicalMap gap = extractionOf(roomWithUnknownStretch(28, 31)).map;
    EXPECT_TRUE(wallFacing(gap.place(1), 1, 0).real) << "four cells of some thirty are missing";
    const TopologicalMap open = extractionOf(roomWithUnknownStretch(10, 50)).map;
    EXPECT_FALSE(wallFacing(open.place(1), 1, 0).real);
}

TEST(SpaceDelimiter, shareOfARealWallIsAnOption)
{
    TDelimitationOptions strict;
    strict.real_wall_ratio = 1;  // nothing is more than all
    const test::Topology t = test::topologyOfPlaces(roomWithUnknownStretch(1, 0));
    const DelimitedSpace space = SpaceDelimiter(strict).delimit(
        roomWithUnknownStretch(1, 0), t.diagram.distances, t.diagram.voronoi, t.graph);
    for (const Wall& wall : space.map.place(1).walls) EXPECT_FALSE(wall.real);
}

TEST(SpaceDelimiter, doorwayHasItsWidthAndItsPlaceWithinACell)
{
    for (const int doorCells : {11, 17, 25}) {
        const TopologicalMap map = extractionOf(test::twoSquareRooms(doorCells)).map;
        ASSERT_EQ(map.connections().size(), 1u) << doorCells;
        const Connection door = map.connections()[0];
        EXPECT_TRUE(door.doorway.real);
        EXPECT_EQ(door.doorway.state, DoorState::Open);
        EXPECT_NEAR(door.doorway.size.length_m, doorCells * 0.05, 0.05 + 1e-9);
        EXPECT_NEAR(door.doorway.position.mean.x, 61 * 0.05, 0.05);
        EXPECT_NEAR(door.doorway.position.mean.y, 30.5 * 0.05, 0.05);
        EXPECT_FALSE(door.doorway.size.height_m) << "a grid does not show heights";
    }
}

TEST(SpaceDelimiter, idsFollowTheRasterOrderOfTheCentres)
{
    ClassifiedGrid grid = solid(121, 121);
    for (const Cell corner : {Cell{1, 1}, Cell{62, 1}, Cell{1, 62}, Cell{62, 62}})
        carve(grid, corner, {corner.x + 58, corner.y + 58});
    const Extraction e = extractionOf(grid);
    ASSERT_EQ(e.map.places().size(), 4u);
    EXPECT_EQ(e.places.at({30, 30}), 1);
    EXPECT_EQ(e.places.at({90, 30}), 2);
    EXPECT_EQ(e.places.at({30, 90}), 3);
    EXPECT_EQ(e.places.at({90, 90}), 4);
    std::set<std::uint32_t> walls;
    for (const auto& [id, place] : e.map.places())
        for (const Wall& wall : place.walls) walls.insert(wall.id);
    EXPECT_EQ(*walls.begin(), 1u);
    EXPECT_EQ(*walls.rbegin(), walls.size()) << "without gaps";
}

TEST(SpaceDelimiter, circlesAlongACorridorMergeToOnePlace)
{
    const ClassifiedGrid grid = corridor();
    const Extraction e = extractionOf(grid);
    ASSERT_EQ(e.map.places().size(), 3u);
    const Place& hall = e.map.place(e.places.at({300, 60}));
    EXPECT_EQ(hall.kind, PlaceKind::Corridor);
    EXPECT_NEAR(hall.area_m2, 394 * 40 * 0.05 * 0.05, 3 * 17 * 2 * 0.05 * 0.05) << "but for the doorways";
    EXPECT_EQ(e.map.place(e.places.at({50, 60})).kind, PlaceKind::Room);
    EXPECT_EQ(e.map.connections().size(), 2u);
    for (const Connection& connection : e.map.connections()) EXPECT_TRUE(connection.doorway.real);
    EXPECT_THAT(e.map.validate(), testing::IsEmpty());
    EXPECT_EQ(test::breachOfPartition(grid, e.places), "");
}

TEST(SpaceDelimiter, toleranceZeroLeavesUnequalCirclesApart)
{
    const ClassifiedGrid grid = corridor();
    const test::Topology t = test::topologyOfPlaces(grid);
    TDelimitationOptions options;
    const auto placesWith = [&](double angle) {
        options.corridor_angle_tolerance = angle;
        return SpaceDelimiter(options).delimit(grid, t.diagram.distances, t.diagram.voronoi, t.graph);
    };
    EXPECT_EQ(placesWith(15).map.places().size(), 3u);
    EXPECT_GT(placesWith(15).mergedCircles, 2u);
    options.corridor_radius_tolerance = 0;
    EXPECT_GE(placesWith(0).map.places().size(), 3u);
}

TEST(SpaceDelimiter, placesLieInTheMapFrame)
{
    const ClassifiedGrid drawn = test::twoSquareRooms(17);
    ClassifiedGrid grid(drawn.width(), drawn.height(), GridFrame{0.05, 7, -3, 0.5});
    for (std::size_t i = 0; i < grid.size(); ++i) grid[i] = drawn[i];
    const Extraction e = extractionOf(grid), plain = extractionOf(drawn);
    for (const auto& [id, place] : plain.map.places()) {
        const Eigen::Vector2d g = drawn.frame().toGrid(place.center.x, place.center.y);
        const Eigen::Vector2d expected = grid.frame().toMap(g.x(), g.y());
        EXPECT_NEAR(e.map.place(id).center.x, expected.x(), 1e-9);
        EXPECT_NEAR(e.map.place(id).center.y, expected.y(), 1e-9);
        EXPECT_NEAR(e.map.place(id).area_m2, place.area_m2, 1e-9);
    }
}
