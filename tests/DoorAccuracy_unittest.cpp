#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gr2to/pipeline/Gr2To.h"
#include "support/buildingMeasures.h"

using namespace gr2to;
using namespace gr2to::test;

/** Doors of clean buildings against their annotation: measured are a recall and a precision of 1 when the
 * building is aligned with the grid. When it is not, places as circles give at least 0.99 of both, places
 * along walls 0.96 and 0.93; the thresholds leave room for a door or two. */
namespace
{
constexpr double kNear_m = 0.25;

struct DoorScores
{
    int annotated = 0, hit = 0, found = 0, right = 0;
    double worstWidth_m = 0;  //!< largest error of a width

    double recall() const { return static_cast<double>(hit) / annotated; }
    double precision() const { return static_cast<double>(right) / found; }
};

double distance(const Connection& connection, const BuildingDoor& door)
{
    const auto& p = connection.doorway.position.mean;
    return std::hypot(p.x - door.centre.x(), p.y - door.centre.y());
}

void score(const Building& building, const Gr2ToOptions& options, DoorScores& scores)
{
    std::vector<Connection> found;
    for (const Connection& c : Gr2To(options).extract(building.grid).map.connections())
        if (c.doorway.real) found.push_back(c);
    scores.found += static_cast<int>(found.size());
    scores.annotated += static_cast<int>(building.doors.size());
    for (const BuildingDoor& door : building.doors) {
        const auto at = std::min_element(found.begin(), found.end(), [&](const auto& a, const auto& b) {
            return distance(a, door) < distance(b, door);
        });
        if (at == found.end() || distance(*at, door) > kNear_m) continue;
        ++scores.hit;
        scores.worstWidth_m =
            std::max(scores.worstWidth_m, std::abs(at->doorway.size.length_m - door.width_m));
    }
    for (const Connection& c : found)
        scores.right += std::any_of(building.doors.begin(), building.doors.end(),
                                    [&](const BuildingDoor& d) { return distance(c, d) <= kNear_m; })
                            ? 1
                            : 0;
}

DoorScores scoresAt(double rotation_deg, bool filtered = false, bool alongWalls = true)
{
    Gr2ToOptions options;
    options.cut.along_walls = alongWalls;
    if (!filtered) options.filter.max_blob_area = 0;
    DoorScores scores;
    int seed = 0;
    for (const char* layout : {"straight", "l", "t", "cross", "ring"})
        for (int k = 0; k < 2; ++k) {
            auto o = buildingOptions(++seed, rotation_deg);
            o.layout = layout;
            o.width = 30;
            o.height = 24;
            score(generateBuilding(o), options, scores);
        }
    return scores;
}
}  // namespace

TEST(DoorAccuracy, everyDoorOfAnAlignedBuildingIsFoundAndNothingElse)
{
    const DoorScores scores = scoresAt(0);
    EXPECT_GT(scores.annotated, 200);
    EXPECT_EQ(scores.hit, scores.annotated);
    EXPECT_EQ(scores.right, scores.found);
}

TEST(DoorAccuracy, doorsOfTurnedBuildingsAreFound)
{
    for (const double rotation : {10.0, 17.0, 30.0, 45.0}) {
        const DoorScores circles = scoresAt(rotation, false, false);
        EXPECT_GE(circles.recall(), 0.98) << rotation << " deg";
        EXPECT_GE(circles.precision(), 0.98) << rotation << " deg";
        const DoorScores walls = scoresAt(rotation);
        EXPECT_GE(walls.recall(), 0.95) << rotation << " deg";
        EXPECT_GE(walls.precision(), 0.92) << rotation << " deg";
    }
}

TEST(DoorAccuracy, filterOfFurnitureCostsFewDoors)
{
    const DoorScores scores = scoresAt(0, true);
    EXPECT_GE(scores.recall(), 0.92);
    EXPECT_GE(scores.precision(), 0.98);
}

TEST(DoorAccuracy, widthsAreRightWithinACellAndAHalf)
{
    for (const double rotation : {0.0, 17.0, 45.0})
        EXPECT_LE(scoresAt(rotation, false, rotation == 0).worstWidth_m, 1.5 * 0.05 + 1e-9)
            << rotation << " deg";
}
