#include "gr2to/topology/CorridorMerging.h"

#include <gmock/gmock.h>

using namespace gr2to;
using testing::ElementsAre;

namespace
{
constexpr double kTolerance = 0.2;
constexpr double kAngle = 15 * 3.14159265358979 / 180;

/** Circles joined in a row by openings. */
PlaceGraph row(const std::vector<Circle>& circles)
{
    PlaceGraph graph;
    graph.circles = circles;
    for (std::size_t k = 0; k + 1 < circles.size(); ++k) graph.links.push_back({k, k + 1, {}, 1, -1});
    return graph;
}

std::vector<std::size_t> groupsOf(const PlaceGraph& graph)
{
    return mergeCorridors(graph, kTolerance, kAngle);
}
}  // namespace

TEST(CorridorMerging, threeInARowOfOneRadiusAreOne)
{
    EXPECT_THAT(groupsOf(row({{{0, 0}, 10}, {{30, 0}, 10}, {{60, 0}, 10}})), ElementsAre(0, 0, 0));
}

TEST(CorridorMerging, twoAreNot)
{
    EXPECT_THAT(groupsOf(row({{{0, 0}, 10}, {{30, 0}, 10}})), ElementsAre(0, 1));
}

TEST(CorridorMerging, longRowsBecomeOneAndOthersStay)
{
    EXPECT_THAT(
        groupsOf(row(
            {{{0, 0}, 30}, {{50, 0}, 10}, {{80, 3}, 10.5}, {{110, 0}, 9.5}, {{140, 2}, 10}, {{190, 0}, 40}})),
        ElementsAre(0, 1, 1, 1, 1, 5));
}

TEST(CorridorMerging, radiiBeyondTheToleranceAreNotTheSame)
{
    EXPECT_THAT(groupsOf(row({{{0, 0}, 10}, {{30, 0}, 8.1}, {{60, 0}, 10}})), ElementsAre(0, 0, 0));
    EXPECT_THAT(groupsOf(row({{{0, 0}, 10}, {{30, 0}, 7.9}, {{60, 0}, 10}})), ElementsAre(0, 1, 2));
    EXPECT_THAT(groupsOf(row({{{0, 0}, 10}, {{30, 0}, 11.5}, {{60, 0}, 13}})), ElementsAre(0, 1, 2))
        << "the first and the last differ";
}

TEST(CorridorMerging, turnsBeyondTheToleranceAreNoRow)
{
    EXPECT_THAT(groupsOf(row({{{0, 0}, 10}, {{100, 0}, 10}, {{200, 24}, 10}})), ElementsAre(0, 0, 0));
    EXPECT_THAT(groupsOf(row({{{0, 0}, 10}, {{100, 0}, 10}, {{200, 29}, 10}})), ElementsAre(0, 1, 2));
    EXPECT_THAT(groupsOf(row({{{100, 0}, 10}, {{0, 0}, 10}, {{100, 5}, 10}})), ElementsAre(0, 1, 2))
        << "back and forth is no row";
}

TEST(CorridorMerging, doorsPart)
{
    PlaceGraph graph = row({{{0, 0}, 10}, {{30, 0}, 10}, {{60, 0}, 10}});
    graph.doors.emplace_back();
    graph.links[1].door = 0;
    EXPECT_THAT(groupsOf(graph), ElementsAre(0, 1, 2));
}

TEST(CorridorMerging, crossingCorridorsJoinAtTheSharedCircle)
{
    PlaceGraph graph;
    graph.circles = {{{50, 0}, 10}, {{0, 50}, 10}, {{50, 50}, 10}, {{100, 50}, 10}, {{50, 100}, 10}};
    graph.links = {{0, 2, {}, 1, -1}, {1, 2, {}, 1, -1}, {2, 3, {}, 1, -1}, {2, 4, {}, 1, -1}};
    EXPECT_THAT(groupsOf(graph), ElementsAre(0, 0, 0, 0, 0));
}

TEST(CorridorMerging, nothingToMergeIsNothing)
{
    EXPECT_THAT(groupsOf({}), testing::IsEmpty());
    EXPECT_THAT(groupsOf(row({{{0, 0}, 10}})), ElementsAre(0));
}
