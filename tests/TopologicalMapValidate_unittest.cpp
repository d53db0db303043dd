#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>

#include "support/someTopologicalMap.h"

namespace gr2to::test
{
namespace
{
using testing::ElementsAre;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

/** One change of a valid map, and the one line that validate() must then give. */
struct Violation
{
    std::function<void(TopologicalMap&)> change;
    std::string line;
};

void expectLines(const std::vector<Violation>& violations)
{
    for (const auto& [change, line] : violations) {
        TopologicalMap map = someMap();
        ASSERT_THAT(map.validate(), testing::IsEmpty());
        change(map);
        EXPECT_THAT(map.validate(), ElementsAre(line));
    }
}
}  // namespace

TEST(TopologicalMapValidate, findsWhatIsWrongWithTheMap)
{
    expectLines({
        {[](auto& m) { m.resolution_m = -1; }, "map: resolution = -1 m must be finite and greater than 0"},
        {[](auto& m) { m.resolution_m = INFINITE; },
         "map: resolution = inf m must be finite and greater than 0"},
        {[](auto& m) { m.frame = ""; }, "map: frame is empty; it must have at least one character"},
        {[](auto& m) { m.source = "\xFF"; },
         "map: source = '\xFF' must be UTF-8 text without control characters"},
    });
}

TEST(TopologicalMapValidate, findsWhatIsWrongWithAPlace)
{
    expectLines({
        {[](auto& m) { m.place(3).id = 4; }, "place 3: id = 4 must stay the number it was added under"},
        {[](auto& m) { m.place(3).kind = static_cast<PlaceKind>(7); },
         "place 3: kind = 7 must be 0 (room) or 1 (corridor)"},
        {[](auto& m) { m.place(3).area_m2 = 0; }, "place 3: area = 0 m2 must be finite and greater than 0"},
        {[](auto& m) { m.place(3).area_m2 = NOT_A_NUMBER; },
         "place 3: area = nan m2 must be finite and greater than 0"},
        {[](auto& m) { m.place(3).center.y = INFINITE; }, "place 3: center y = inf must be finite"},
        {[](auto& m) { m.place(3).boundary.resize(2); },
         "place 3: boundary has 2 vertices; it must have none or at least 3"},
        {[](auto& m) { m.place(3).boundary[1].x = NOT_A_NUMBER; },
         "place 3: boundary vertex 2 x = nan must be finite"},
        {[](auto& m) {
             m.place(3).boundary = {{0, 0}, {4, 3}, {4, 0}, {0, 3}};
         },
         "place 3: boundary crosses itself: the sides from vertex 1 and from vertex 3; it must be simple"},
        {[](auto& m) {
             m.place(3).words = {"a", ""};
         },
         "place 3: word 2 is empty; it must have at least one character"},
        {[](auto& m) { m.place(3).words = {"a\nb"}; },
         "place 3: word 1 = 'a?b' must have no tabs, line ends or other control characters"},
        {[](auto& m) { m.place(3).words = {"a\xC2\x85"}; },
         "place 3: word 1 = 'a\xC2\x85' must have no tabs, line ends or other control characters"},
        {[](auto& m) { m.place(3).words = {"caf\xE9"}; },
         "place 3: word 1 = 'caf\xE9' must be UTF-8 text without control characters"},
    });
}

TEST(TopologicalMapValidate, acceptsBoundariesThatTouchThemselves)
{
    TopologicalMap map = someMap();
    map.place(3).boundary = {{0, 0}, {4, 0}, {4, 0}, {2, 2}, {2, 0}, {0, 2}};
    EXPECT_THAT(map.validate(), testing::IsEmpty());
}

TEST(TopologicalMapValidate, findsWhatIsWrongWithAWall)
{
    expectLines({
        {[](auto& m) { m.place(3).walls[0].id = 0; }, "place 3, wall 0: id = 0 must be at least 1"},
        {[](auto& m) { m.place(3).walls[1].id = 10; },
         "place 3, wall 10: id = 10 is taken; ids must be unique"},
        {[](auto& m) { m.place(3).walls[0].position.mean.z = NOT_A_NUMBER; },
         "place 3, wall 30: position z = nan must be finite"},
        {[](auto& m) { m.place(3).walls[0].normal.mean.x = 0.5; },
         "place 3, wall 30: normal = 0.5 must have length 1"},
        {[](auto& m) { m.place(3).walls[0].normal.mean.y = INFINITE; },
         "place 3, wall 30: normal y = inf must be finite"},
        {[](auto& m) { m.place(3).walls[0].size.length_m = 0; },
         "place 3, wall 30: length = 0 m must be finite and greater than 0"},
        {[](auto& m) { m.place(3).walls[0].size.height_m = -1; },
         "place 3, wall 30: height = -1 m must be finite and greater than 0"},
        {[](auto& m) { m.place(3).walls[0].curvatureLength = INFINITE; },
         "place 3, wall 30: curvature length = inf must be finite"},
        {[](auto& m) { m.place(3).walls[0].curvatureHeight = NOT_A_NUMBER; },
         "place 3, wall 30: curvature height = nan must be finite"},
    });
}

TEST(TopologicalMapValidate, findsWhatIsWrongWithACovariance)
{
    expectLines({
        {[](auto& m) { m.place(3).walls[0].position.covariance(1, 1) = NOT_A_NUMBER; },
         "place 3, wall 30: the covariance of position has entry (2, 2) = nan, which must be finite"},
        {[](auto& m) { m.place(3).walls[0].position.covariance(0, 1) = 1; },
         "place 3, wall 30: the covariance of position has entry (1, 2) = 1, which must equal its mirror "
         "image 0"},
        {[](auto& m) { m.place(3).walls[0].position.covariance(2, 2) = -4; },
         "place 3, wall 30: the covariance of position has eigenvalue -4, which must not be negative"},
        {[](auto& m) { m.place(3).walls[0].normal.covariance(0, 0) = -1e-300; },
         "place 3, wall 30: the covariance of normal has eigenvalue -1e-300, which must not be negative"},
        {[](auto& m) { m.place(3).walls[0].size.covariance(0, 0) = -1; },
         "place 3, wall 30: the covariance of size has eigenvalue -1, which must not be negative"},
        {[](auto& m) {
             m.place(3).walls[0].size.height_m.reset();
             m.place(3).walls[0].size.covariance(1, 1) = 1;
         },
         "place 3, wall 30: the covariance of size has entries of the absent height, which must be 0"},
        {[](auto& m) { m.place(3).views[0].position.covariance(0, 0) = -1; },
         "place 3, view 1: the covariance of position has eigenvalue -1, which must not be negative"},
        {[](auto& m) { m = someMap([](Connection& c) { c.doorway.position.covariance(0, 0) = -1; }); },
         "connection 7, doorway: the covariance of position has eigenvalue -1, which must not be negative"},
        {[](auto& m) { m = someMap([](Connection& c) { c.doorway.size.covariance(0, 0) = -1; }); },
         "connection 7, doorway: the covariance of size has eigenvalue -1, which must not be negative"},
    });
}

TEST(TopologicalMapValidate, acceptsARankDeficientCovarianceWithRounding)
{
    TopologicalMap map = someMap();
    const double direction[3] = {1.0 / 3, 0.1, std::sqrt(2)};
    auto& covariance = map.place(3).walls[0].position.covariance;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            covariance(row, column) = direction[row] * direction[column];
    EXPECT_THAT(map.validate(), testing::IsEmpty());
}

TEST(TopologicalMapValidate, findsWhatIsWrongWithAView)
{
    expectLines({
        {[](auto& m) { m.place(3).views[0].image = ""; },
         "place 3, view 1: image is empty; it must have at least one character"},
        {[](auto& m) { m.place(3).views[0].position.mean.x = INFINITE; },
         "place 3, view 1: position x = inf must be finite"},
        {[](auto& m) { m.place(3).views[0].apertureX_rad = 7; },
         "place 3, view 1: aperture x = 7 rad must be within [0, 2 pi]"},
        {[](auto& m) { m.place(3).views[0].apertureY_rad = NOT_A_NUMBER; },
         "place 3, view 1: aperture y = nan rad must be within [0, 2 pi]"},
        {[](auto& m) { m.place(3).views[0].time_s = INFINITE; },
         "place 3, view 1: time = inf must be finite"},
        {[](auto& m) { m = someMap([](Connection& c) { c.doorway.view->apertureX_rad = -1; }); },
         "connection 7, doorway, view: aperture x = -1 rad must be within [0, 2 pi]"},
    });
}

TEST(TopologicalMapValidate, findsWhatIsWrongWithAConnection)
{
    // The class lets no such edge in; a graph that MRPT changed could have one.
    const auto insert = [](TopologicalMap& map, const Connection& connection) {
        const_cast<TopologicalMap::Graph&>(map.graph())
            .insertEdge(connection.from, connection.to, connection);
    };
    expectLines({
        {[&](auto& m) { insert(m, someConnection(7, 1, 3)); },
         "connection 7: id = 7 is taken; ids must be unique"},
        {[&](auto& m) { insert(m, someConnection(0, 1, 3)); }, "connection 0: id = 0 must be at least 1"},
        {[&](auto& m) { insert(m, someConnection(8, 1, 4)); },
         "connection 8: place 4 does not exist; both ends must be places"},
        {[&](auto& m) { insert(m, someConnection(8, 3, 3)); },
         "connection 8: from = 3 must be smaller than to = 3"},
        {[&](auto& m) { insert(m, someConnection(8, 5, 3)); },
         "connection 8: from = 5 must be smaller than to = 3"},
        {[](auto& m) { m = someMap([](Connection& c) { c.words = {""}; }); },
         "connection 7: word 1 is empty; it must have at least one character"},
        {[](auto& m) { m = someMap([](Connection& c) { c.doorway.state = static_cast<DoorState>(3); }); },
         "connection 7, doorway: state = 3 must be 0 (unknown), 1 (open) or 2 (closed)"},
        {[](auto& m) { m = someMap([](Connection& c) { c.doorway.position.mean.y = NOT_A_NUMBER; }); },
         "connection 7, doorway: position y = nan must be finite"},
        {[](auto& m) { m = someMap([](Connection& c) { c.doorway.size.length_m = -0.9; }); },
         "connection 7, doorway: length = -0.9 m must be finite and greater than 0"},
        {[](auto& m) { m = someMap([](Connection& c) { c.doorway.size.height_m = 0; }); },
         "connection 7, doorway: height = 0 m must be finite and greater than 0"},
    });
}
}  // namespace gr2to::test
