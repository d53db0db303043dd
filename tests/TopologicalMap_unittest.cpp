#include "gr2to/topology/TopologicalMap.h"

#include <gmock/gmock.h>
#include <mrpt/graphs/dijkstra.h>

#include <functional>
#include <stdexcept>

#include "support/messageOf.h"
#include "support/randomTopologicalMap.h"
#include "support/someTopologicalMap.h"

namespace gr2to::test
{
namespace
{
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::uint32_t> idsOf(const std::vector<Connection>& connections)
{
    std::vector<std::uint32_t> ids;
    for (const auto& connection : connections) ids.push_back(connection.id);
    return ids;
}
}  // namespace

TEST(TopologicalMap, keepsParallelConnectionsAndListsThemById)
{
    TopologicalMap map = someMap();
    map.addConnection(someConnection(2, 5, 3));
    map.addConnection(someConnection(4, 1, 3));
    EXPECT_THAT(idsOf(map.connections()), ElementsAre(2, 4, 7));
    EXPECT_THAT(idsOf(map.connectionsOf(5)), ElementsAre(2, 7));
    EXPECT_THAT(idsOf(map.connectionsOf(1)), ElementsAre(4));
    EXPECT_THAT(idsOf(map.connectionsOf(9)), ElementsAre());
    EXPECT_EQ(map.graph().edgeCount(), 3u);
}

TEST(TopologicalMap, storesAConnectionFromTheSmallerPlaceToTheLarger)
{
    TopologicalMap map = someMap();
    map.addConnection(someConnection(2, 5, 1));
    EXPECT_EQ(map.connections().front().from, 1);
    EXPECT_EQ(map.connections().front().to, 5);
    EXPECT_TRUE(map.graph().edgeExists(1, 5));
}

TEST(TopologicalMap, runsMrptsDijkstraOverItsGraph)
{
    TopologicalMap map = someMap();
    map.addConnection(someConnection(8, 1, 3));
    using Dijkstra = mrpt::graphs::CDijkstra<TopologicalMap::Graph>;
    const Dijkstra routes(
        map.graph(), 5, [](const auto&, auto, auto, const auto& edge) { return edge.doorway.size.length_m; });
    EXPECT_DOUBLE_EQ(routes.getNodeDistanceToRoot(1).value_or(0), 1.8);
}

TEST(TopologicalMap, refusesPlacesAndConnectionsThatDoNotFit)
{
    TopologicalMap map = someMap();
    const auto placeMessage = [&](PlaceId id) {
        return messageOf<std::invalid_argument>([&] { map.addPlace(somePlace(id)); });
    };
    const auto connectionMessage = [&](std::uint32_t id, PlaceId from, PlaceId to) {
        return messageOf<std::invalid_argument>([&] { map.addConnection(someConnection(id, from, to)); });
    };
    EXPECT_THAT(placeMessage(0), HasSubstr("ids start at 1"));
    EXPECT_THAT(placeMessage(3), HasSubstr("place 3: the id is taken"));
    EXPECT_THAT(connectionMessage(0, 1, 3), HasSubstr("ids start at 1"));
    EXPECT_THAT(connectionMessage(7, 1, 3), HasSubstr("connection 7: the id is taken"));
    EXPECT_THAT(connectionMessage(8, 1, 4), HasSubstr("connection 8: there is no place 4"));
    EXPECT_THAT(connectionMessage(8, 3, 3), HasSubstr("two different places"));
    EXPECT_THROW(map.place(4), std::out_of_range);
    EXPECT_EQ(map, someMap()) << "a refusal must change nothing";
}

TEST(TopologicalMap, isEqualWhateverTheOrderOfAdding)
{
    TopologicalMap forward = someMap();
    TopologicalMap backward;
    backward.resolution_m = forward.resolution_m;
    for (const PlaceId id : {PlaceId{3}, PlaceId{1}, PlaceId{5}}) backward.addPlace(somePlace(id));
    backward.addConnection(someConnection(9, 5, 3));
    backward.addConnection(someConnection(7, 5, 3));
    EXPECT_FALSE(forward == backward);
    forward.addConnection(someConnection(9, 3, 5));
    EXPECT_TRUE(forward == backward);
}

TEST(TopologicalMap, differsInEveryAttribute)
{
    using Change = std::function<void(TopologicalMap&)>;
    const std::vector<Change> changes = {
        [](auto& m) { m.frame = "odom"; },
        [](auto& m) { m.resolution_m = 0.1; },
        [](auto& m) { m.source = "x"; },
        [](auto& m) { m.addPlace(somePlace(9)); },
        [](auto& m) { m.place(3).kind = PlaceKind::Corridor; },
        [](auto& m) { m.place(3).words = {"lab"}; },
        [](auto& m) { m.place(3).area_m2 = 1; },
        [](auto& m) { m.place(3).center.z = 1; },
        [](auto& m) { m.place(3).boundary[1].y = 1; },
        [](auto& m) { m.place(3).walls[0].id = 99; },
        [](auto& m) { m.place(3).walls[0].position.mean.z = 1; },
        [](auto& m) { m.place(3).walls[0].position.covariance(2, 1) = 1; },
        [](auto& m) { m.place(3).walls[0].normal.mean.y = 1; },
        [](auto& m) { m.place(3).walls[0].normal.covariance(0, 2) = 1; },
        [](auto& m) { m.place(3).walls[0].size.length_m = 1; },
        [](auto& m) { m.place(3).walls[0].size.height_m.reset(); },
        [](auto& m) { m.place(3).walls[0].size.covariance(1, 1) = 1; },
        [](auto& m) { m.place(3).walls[0].curvatureLength = 1; },
        [](auto& m) { m.place(3).walls[0].curvatureHeight = 1; },
        [](auto& m) { m.place(3).walls[0].real = true; },
        [](auto& m) { m.place(3).views[0].image = "x"; },
        [](auto& m) { m.place(3).views[0].position.mean.x = 1; },
        [](auto& m) { m.place(3).views[0].position.covariance(0, 0) = 1; },
        [](auto& m) { m.place(3).views[0].apertureX_rad = 2; },
        [](auto& m) { m.place(3).views[0].apertureY_rad = 2; },
        [](auto& m) { m.place(3).views[0].time_s = 1; },
        [](auto& m) { m = someMap([](Connection& c) { c.id = 8; }); },
        [](auto& m) { m = someMap([](Connection& c) { c.from = 1; }); },
        [](auto& m) { m = someMap([](Connection& c) { c.words.clear(); }); },
        [](auto& m) { m = someMap([](Connection& c) { c.doorway.real = true; }); },
        [](auto& m) { m = someMap([](Connection& c) { c.doorway.state = DoorState::Open; }); },
        [](auto& m) { m = someMap([](Connection& c) { c.doorway.position.mean.x = 1; }); },
        [](auto& m) { m = someMap([](Connection& c) { c.doorway.size.height_m = 2; }); },
        [](auto& m) { m = someMap([](Connection& c) { c.doorway.view.reset(); }); },
    };
    const TopologicalMap original = someMap();
    for (std::size_t i = 0; i < changes.size(); ++i) {
        TopologicalMap changed = someMap();
        ASSERT_TRUE(changed == original);
        changes[i](changed);
        EXPECT_FALSE(changed == original) << "change " << i;
    }
}

TEST(TopologicalMap, randomMapsAreValid)
{
    for (unsigned seed = 0; seed < 50; ++seed)
        EXPECT_THAT(randomTopologicalMap(seed).validate(), testing::IsEmpty()) << "seed " << seed;
}

TEST(TopologicalMap, anEmptyMapIsValidOnceItHasAResolution)
{
    TopologicalMap map;
    EXPECT_THAT(map.validate(), ElementsAre("map: resolution = 0 m must be finite and greater than 0"));
    map.resolution_m = 0.05;
    EXPECT_THAT(map.validate(), testing::IsEmpty());
}
}  // namespace gr2to::test
