#include "gr2to/stages/PlaceConstruction.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "support/buildingMeasures.h"
#include "support/pipeline.h"

using namespace gr2to;
using test::carve;
using test::solid;
using test::topologyOfPlaces;

namespace
{
PlaceBuilder builder(bool oneDoorPerCandidate = false)
{
    TPlaceOptions options;
    options.one_door_per_candidate = oneDoorPerCandidate;
    return PlaceBuilder(options);
}

std::vector<Cell> doorCells(const std::vector<ValidatedDoor>& doors)
{
    std::vector<Cell> cells;
    for (const ValidatedDoor& door : doors) cells.push_back(door.critical.cell);
    return cells;
}

DoorCandidate candidateAt(std::vector<Cell> cells)
{
    DoorCandidate candidate;
    candidate.center = cells.front();
    candidate.cells = std::move(cells);
    candidate.maxClearance_cells = 15;
    return candidate;
}

/** A corridor 0.85 m wide, of 41 rows from wall to wall, so that all its cells have jambs. */
ClassifiedGrid narrowCorridor()
{
    ClassifiedGrid grid = solid(201, 41);
    carve(grid, {1, 12}, {199, 28});
    return grid;
}
}  // namespace

TEST(PlaceBuilder, doorIsValidOnlyWithACriticalPointNearIt)
{
    const ClassifiedGrid grid = narrowCorridor();
    const std::vector<DoorCandidate> candidates{candidateAt({{50, 20}})};
    const auto doorsWith = [&](const std::vector<CriticalPoint>& points) {
        return doorCells(builder().validate(candidates, points, grid, Obstacles::Occupied));
    };
    EXPECT_THAT(doorsWith({}), testing::IsEmpty());
    EXPECT_THAT(doorsWith({{{56, 20}, 9}}), testing::IsEmpty()) << "0.30 m away";
    EXPECT_THAT(doorsWith({{{55, 20}, 9}}), testing::ElementsAre(Cell{55, 20})) << "0.25 m away";
    EXPECT_THAT(doorsWith({{{50, 20}, 9}, {{150, 20}, 9}}), testing::ElementsAre(Cell{50, 20}));
}

TEST(PlaceBuilder, criticalPointWithoutACandidateIsNoDoor)
{
    EXPECT_THAT(builder().validate({}, {{{50, 20}, 9}}, narrowCorridor(), Obstacles::Occupied),
                testing::IsEmpty());
}

TEST(PlaceBuilder, ofPointsInOneDoorwayTheNarrowestCounts)
{
    const ClassifiedGrid grid = narrowCorridor();
    const std::vector<DoorCandidate> candidates{candidateAt({{50, 20}, {51, 20}, {52, 20}})};
    const std::vector<CriticalPoint> points{{{47, 20}, 9.2}, {{51, 20}, 9}, {{55, 20}, 9}};
    for (const bool one : {false, true})
        EXPECT_THAT(doorCells(builder(one).validate(candidates, points, grid, Obstacles::Occupied)),
                    testing::ElementsAre(Cell{51, 20}));
}

TEST(PlaceBuilder, likelyCellsThatChainFromDoorToDoorAreEveryDoorUnlessAsPrinted)
{
    const ClassifiedGrid grid = narrowCorridor();
    std::vector<Cell> chain;
    for (int x = 40; x <= 120; ++x) chain.push_back({x, 20});
    const std::vector<CriticalPoint> points{{{50, 20}, 9}, {{80, 20}, 8.9}, {{110, 20}, 9}, {{95, 20}, 17}};
    EXPECT_THAT(doorCells(builder().validate({candidateAt(chain)}, points, grid, Obstacles::Occupied)),
                testing::ElementsAre(Cell{50, 20}, Cell{80, 20}, Cell{110, 20}))
        << "the point wider than a door is none";
    EXPECT_THAT(doorCells(builder(true).validate({candidateAt(chain)}, points, grid, Obstacles::Occupied)),
                testing::ElementsAre(Cell{80, 20}));
}

TEST(PlaceBuilder, twoRoomsAndADoorAreTwoCirclesAndOneLink)
{
    const test::Topology t = topologyOfPlaces(test::twoSquareRooms(17));
    ASSERT_EQ(t.graph.circles.size(), 2u);
    EXPECT_LE(distance_cells(t.graph.circles[0].center, {30, 30}), 1);
    EXPECT_LE(distance_cells(t.graph.circles[1].center, {91, 30}), 1);
    ASSERT_EQ(t.graph.doors.size(), 1u);
    ASSERT_EQ(t.graph.links.size(), 1u);
    EXPECT_EQ(t.graph.links[0].door, 0);
    EXPECT_EQ(t.graph.links[0].from, 0u);
    EXPECT_EQ(t.graph.links[0].to, 1u);
    EXPECT_THAT(t.graph.borders, testing::IsEmpty());
}

TEST(PlaceBuilder, doorThatPartsNoTwoPlacesIsDropped)
{
    ClassifiedGrid grid = test::twoSquareRooms(0);
    carve(grid, {60, 22}, {69, 38});  // a niche as wide as a door is no door, though it narrows
    for (int y = 1; y < 60; ++y) grid.set({70, y}, CellState::Occupied);
    const test::Topology t = topologyOfPlaces(grid);
    EXPECT_THAT(t.graph.doors, testing::IsEmpty());
}

TEST(PlaceBuilder, doorThatCanBeWalkedAroundInTheSamePlaceStaysOnlyBetweenTwoCircles)
{
    for (int seed = 1; seed <= 4; ++seed) {
        const test::Topology t =
            topologyOfPlaces(test::generateBuilding(test::buildingOptions(seed, 12 * seed, 0.1)).grid);
        for (const PlaceLink& link : t.graph.links) EXPECT_NE(link.from, link.to) << "seed " << seed;
        std::vector<int> carried(t.graph.doors.size(), 0);
        for (const PlaceLink& link : t.graph.links)
            if (link.door >= 0) ++carried[static_cast<std::size_t>(link.door)];
        EXPECT_THAT(carried, testing::Each(1)) << "seed " << seed;
    }
}

TEST(PlaceBuilder, twoDoorsBetweenTheSameRoomsAreBothKept)
{
    ClassifiedGrid grid = test::twoSquareRooms(0);
    carve(grid, {60, 6}, {61, 22});
    carve(grid, {60, 38}, {61, 54});
    const test::Topology t = topologyOfPlaces(grid);
    ASSERT_EQ(t.graph.circles.size(), 2u);
    ASSERT_EQ(t.graph.links.size(), 2u);
    for (const PlaceLink& link : t.graph.links) {
        EXPECT_GE(link.door, 0);
        EXPECT_EQ(link.from, 0u);
        EXPECT_EQ(link.to, 1u);
    }
    EXPECT_NE(t.graph.links[0].door, t.graph.links[1].door);
}

TEST(PlaceBuilder, roomWithoutADoorIsAPlaceWithoutLinks)
{
    const test::Topology t = topologyOfPlaces(test::twoSquareRooms(0));
    EXPECT_EQ(t.graph.circles.size(), 2u);
    EXPECT_THAT(t.graph.links, testing::IsEmpty());
}

TEST(PlaceBuilder, everyPartOfTheDiagramThatIsWideEnoughHasACircle)
{
    ClassifiedGrid grid = test::twoSquareRooms(0);
    carve(grid, {60, 30}, {61, 30});  // no door: too narrow
    EXPECT_EQ(topologyOfPlaces(grid).graph.circles.size(), 2u);
    ClassifiedGrid closets = solid(20, 11);
    carve(closets, {1, 1}, {9, 9});    // a circle of a radius of 5 cells fits, 0.25 m
    carve(closets, {11, 1}, {17, 7});  // none does
    EXPECT_EQ(topologyOfPlaces(closets).graph.circles.size(), 1u);
}

TEST(PlaceBuilder, wideOpeningIsALinkWithoutADoorAndHasABorder)
{
    ClassifiedGrid grid = solid(200, 81);
    carve(grid, {1, 1}, {79, 79});
    carve(grid, {120, 1}, {198, 79});
    carve(grid, {80, 20}, {119, 60});
    const test::Topology t = topologyOfPlaces(grid);
    EXPECT_GE(t.graph.circles.size(), 2u);
    EXPECT_THAT(t.graph.doors, testing::IsEmpty());
    ASSERT_GE(t.graph.links.size(), 1u);
    for (const PlaceLink& link : t.graph.links) EXPECT_EQ(link.door, -1);
    EXPECT_GE(t.graph.borders.size(), t.graph.links.size());
}

TEST(PlaceBuilder, circlesOfAWholeBuildingAreDisjointAndInRasterOrder)
{
    for (int seed = 1; seed <= 6; ++seed) {
        const test::Topology t =
            topologyOfPlaces(test::generateBuilding(test::buildingOptions(seed, 15 * seed)).grid);
        const auto& circles = t.graph.circles;
        const auto raster = [](const Circle& a, const Circle& b) {
            return a.center.y != b.center.y ? a.center.y < b.center.y : a.center.x < b.center.x;
        };
        EXPECT_TRUE(std::is_sorted(circles.begin(), circles.end(), raster)) << "seed " << seed;
        std::size_t overlapping = 0;
        for (std::size_t a = 0; a < circles.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                overlapping += distance_cells(circles[a].center, circles[b].center) <
                                       circles[a].radius_cells + circles[b].radius_cells
                                   ? 1
                                   : 0;
        EXPECT_EQ(overlapping, 0u) << "seed " << seed;
    }
}

TEST(PlaceBuilder, nothingNarrowsBetweenCirclesThatEquation9Drops)
{
    ClassifiedGrid room = solid(202, 61);
    carve(room, {1, 1}, {200, 59});  // 10 m x 3 m: circles of 30 cells at 2 r would touch
    const test::Topology t = topologyOfPlaces(room);
    for (std::size_t a = 0; a < t.graph.circles.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const Circle &p = t.graph.circles[a], &q = t.graph.circles[b];
            EXPECT_GE(distance_cells(p.center, q.center), std::sqrt(2.0) * (p.radius_cells + q.radius_cells));
        }
    EXPECT_GE(t.graph.circles.size(), 2u);
}
