#include "gr2to/compare/GraphScores.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/drawLabels.h"

namespace
{
using namespace gr2to;
using test::drawLabels;

ReferenceInterface passage(InterfaceKind kind, PlaceId a, PlaceId b, double x_px = 0, double y_px = 0,
                           double width_m = 0.9)
{
    return {kind, a, b, {x_px, y_px}, width_m};
}

constexpr auto kDoor = InterfaceKind::Door;
constexpr auto kOpening = InterfaceKind::Opening;
constexpr auto kSlit = InterfaceKind::Slit;
}  // namespace

TEST(DoorScores, doorsWithinThreeQuartersOfAMetreAreFound)
{
    // At 0.1 m a pixel the radius is 7.5 pixels.
    const std::vector<ReferenceInterface> annotated{passage(kDoor, 1, 2, 10, 10, 0.9),
                                                    passage(kDoor, 2, 3, 50, 10, 1.0)};
    const auto scores = doorScores({{{10, 17}, 0.8}, {{58, 10}, 1.0}, {{90, 90}, 1.0}}, annotated, 0.1);
    EXPECT_DOUBLE_EQ(scores.precision, 1. / 3);
    EXPECT_DOUBLE_EQ(scores.recall, 1. / 2);
    EXPECT_DOUBLE_EQ(scores.f1, 2 * (1. / 3) * (1. / 2) / (1. / 3 + 1. / 2));
    EXPECT_EQ(scores.annotated, 2);
    EXPECT_EQ(scores.predicted, 3);
    EXPECT_NEAR(scores.widthError_m.value(), 0.1, 1e-12);
}

TEST(DoorScores, everyAnnotatedDoorIsFoundOnce)
{
    const std::vector<ReferenceInterface> annotated{passage(kDoor, 1, 2, 10, 10),
                                                    passage(kDoor, 2, 3, 16, 10)};
    // The first door is nearer to the second annotation, which only the other door can reach too.
    const auto scores = doorScores({{{14, 10}, 0.9}, {{20, 10}, 0.9}}, annotated, 0.1);
    EXPECT_DOUBLE_EQ(scores.recall, 1);
    const auto twice = doorScores({{{10, 10}, 0.9}, {{11, 10}, 0.9}}, {annotated[0]}, 0.1);
    EXPECT_DOUBLE_EQ(twice.precision, 0.5);
}

TEST(DoorScores, doorsAtOpeningsAndSlitsAreForgivenByTheLenientPrecision)
{
    const std::vector<ReferenceInterface> annotated{passage(kDoor, 1, 2, 10, 10),
                                                    passage(kOpening, 2, 3, 60, 10, 4.0),
                                                    passage(kSlit, 3, 4, 200, 10, 0.2)};
    // 19 px from an opening of 4 m, 21 px from it, 7 px and 8 px from a slit.
    const auto scores = doorScores(
        {{{10, 10}, 0}, {{79, 10}, 0}, {{39, 10}, 0}, {{207, 10}, 0}, {{192, 10}, 0}}, annotated, 0.1);
    EXPECT_DOUBLE_EQ(scores.precision, 1. / 5);
    EXPECT_DOUBLE_EQ(scores.precisionLenient, 1. / 3);
    EXPECT_FALSE(scores.widthError_m);
}

TEST(DoorScores, nothingFoundOrNothingAnnotatedScoresNothing)
{
    const auto none = doorScores({}, {passage(kDoor, 1, 2)}, 0.1);
    EXPECT_EQ(none.precision + none.recall + none.f1 + none.precisionLenient, 0);
    const auto spurious = doorScores({{{1, 1}, 0.9}}, {}, 0.1);
    EXPECT_EQ(spurious.precision + spurious.recall + spurious.f1, 0);
    EXPECT_EQ(spurious.predicted, 1);
}

TEST(EdgeScores, segmentsStandForTheRoomTheyOverlapMost)
{
    // Room 1 is cut into 5 and 6; 7 is room 2, 8 room 3.
    const ContingencyTable table(drawLabels({"567788"}), drawLabels({"112233"}));
    const std::vector<ReferenceInterface> annotated{passage(kDoor, 1, 2), passage(kOpening, 2, 3)};
    const auto scores = edgeScores({{5, 6}, {7, 6}, {6, 7}, {8, 5}}, annotated, table);
    EXPECT_EQ(scores.internal, 1);
    EXPECT_EQ(scores.annotated, 2);
    EXPECT_EQ(scores.predicted, 2);  // 1-2, and 1-3 that is wrong
    EXPECT_DOUBLE_EQ(scores.precision, 0.5);
    EXPECT_DOUBLE_EQ(scores.recall, 0.5);
    EXPECT_DOUBLE_EQ(scores.f1, 0.5);
}

TEST(EdgeScores, pairsJoinedOnlyBySlitsNeitherHelpNorHurt)
{
    const ContingencyTable table(drawLabels({"123"}), drawLabels({"123"}));
    const std::vector<ReferenceInterface> annotated{passage(kSlit, 1, 2), passage(kSlit, 2, 3),
                                                    passage(kDoor, 2, 3)};
    const auto scores = edgeScores({{1, 2}, {2, 3}}, annotated, table);
    EXPECT_EQ(scores.annotated, 1);
    EXPECT_EQ(scores.predicted, 1);
    EXPECT_DOUBLE_EQ(scores.f1, 1);
}

TEST(EdgeScores, placesOutsideTheRoomsAreWrongAndAbsentOnesIgnored)
{
    const ContingencyTable table(drawLabels({"1234"}), drawLabels({"12.."}));
    const auto scores = edgeScores({{1, 2}, {2, 3}, {3, 4}, {1, 9}, {9, 9}}, {passage(kDoor, 1, 2)}, table);
    EXPECT_EQ(scores.predicted, 3);
    EXPECT_EQ(scores.internal, 0);
    EXPECT_DOUBLE_EQ(scores.precision, 1. / 3);
    EXPECT_DOUBLE_EQ(scores.recall, 1);
}

TEST(PredictedGraph, doorsAreRealDoorwaysInImageCoordinates)
{
    TopologicalMap map;
    map.resolution_m = 0.5;
    for (const PlaceId id : {PlaceId{1}, PlaceId{2}, PlaceId{3}}) {
        Place place;
        place.id = id;
        map.addPlace(place);
    }
    Connection door;
    door.id = 1;
    door.from = 1;
    door.to = 2;
    door.doorway.real = true;
    door.doorway.size.length_m = 0.9;
    door.doorway.position.mean = {2.25, 1.25, 0};
    map.addConnection(door);
    Connection opening = door;
    opening.id = 2;
    opening.from = 3;
    opening.doorway.real = false;
    map.addConnection(opening);
    const auto graph = predictedGraph(map, GridFrame{0.5, 0, 0, 0}, 10);
    ASSERT_EQ(graph.doors.size(), 1u);
    EXPECT_NEAR(graph.doors[0].mid_px.x(), 2.25 / 0.5 - 0.5, 1e-12);
    EXPECT_NEAR(graph.doors[0].mid_px.y(), 10 - 0.5 - 1.25 / 0.5, 1e-12);
    EXPECT_EQ(graph.doors[0].width_m, 0.9);
    EXPECT_THAT(graph.edges, testing::ElementsAre(std::make_pair(PlaceId{1}, PlaceId{2}),
                                                  std::make_pair(PlaceId{2}, PlaceId{3})));
    // With the grid's corner at (-3, 7) and its columns along the map's y axis: 5.75 m and 5.25 m on the far
    // side.
    const auto moved = predictedGraph(map, GridFrame{0.5, -3, 7, M_PI / 2}, 10);
    EXPECT_NEAR(moved.doors[0].mid_px.x(), -5.75 / 0.5 - 0.5, 1e-9);
    EXPECT_NEAR(moved.doors[0].mid_px.y(), 9 + 5.25 / 0.5 + 0.5, 1e-9);
}
