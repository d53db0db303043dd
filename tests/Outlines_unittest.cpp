#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "gr2to/io/GridReader.h"
#include "support/annotatedMaps.h"
#include "support/buildingMeasures.h"
#include "support/outlines.h"
#include "support/rooms.h"

using namespace gr2to;
using namespace gr2to::test;
using Eigen::Vector2d;

/** Outlines of whole maps in preset default. */
namespace
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t kEvery = 12;  // sanitizers take ten times as long
#else
constexpr std::size_t kEvery = 1;
#endif

void checkAnnotatedMaps(const std::string& folder)
{
    const std::vector<AnnotatedMap> maps = annotatedMaps(folder);
    if (maps.empty())
        GTEST_SKIP() << "the evaluation data " << folder << " is not here: its maps are not tested";
    for (std::size_t k = 0; k < maps.size(); k += kEvery) {
        TGridReaderOptions options;
        options.resolution = maps[k].resolution_m;
        EXPECT_THAT(breachesOfOutlines(Gr2To().extract(readGrid(maps[k].image, options))), testing::IsEmpty())
            << maps[k].image.filename();
    }
}

/** The annotated buildings, and one with all kinds of noise. */
std::vector<TBuildingOptions> buildings()
{
    auto all = variousBuildings();
    auto noisy = buildingOptions(77, 12.0, 0.2);
    noisy.noise = 0.1, noisy.speckle = 0.003, noisy.wall_jitter = 0.3, noisy.closed_doors = 0.3;
    all.push_back(noisy);
    return all;
}

PlaceId placeAt(const Extraction& e, const Vector2d& p)
{
    const Cell c = cellAt(e.grid, p);
    return e.grid.contains(c) ? e.places.at(c) : PlaceId{0};
}

/** Farthest distance of a door's middle line, but for a cell and a half at either jamb, from the common sides
 * of the outlines of the places that it joins [m]. */
double distanceFromBorder(const Extraction& e, const BuildingDoor& door, PlaceId a, PlaceId b)
{
    const auto sides = commonSides(polygonOf(e.map.place(a).boundary), polygonOf(e.map.place(b).boundary));
    const double half = door.width_m / 2 - 1.5 * e.grid.resolution_m();
    double farthest = 0;
    for (double along = -half; along <= half; along += e.grid.resolution_m()) {
        double nearest = 1e9;
        for (const auto& [from, to] : sides)
            nearest = std::min(nearest, distanceFromSide(door.centre + along * across(door), from, to));
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}
}  // namespace

TEST(Outlines, ofBuildingsAreSimpleSharedAndAsLargeAsTheirCells)
{
    for (const TBuildingOptions& options : buildings())
        EXPECT_THAT(breachesOfOutlines(Gr2To().extract(generateBuilding(options).grid)), testing::IsEmpty())
            << nameOf(options);
}

TEST(Outlines, ofBuildingsCoverTheAreasOfTheirPlaces)
{
    for (const TBuildingOptions& options : variousBuildings()) {
        const Extraction e = Gr2To().extract(generateBuilding(options).grid);
        for (const auto& [id, place] : e.map.places())
            EXPECT_NEAR(areaOf(polygonOf(place.boundary)), place.area_m2, 0.02 * place.area_m2)
                << nameOf(options) << ", place " << id;
    }
}

TEST(Outlines, ofPlacesAsCirclesAreSharedAsWell)
{
    Gr2ToOptions options;
    options.cut.along_walls = false;
    for (const TBuildingOptions& building : variousBuildings())
        EXPECT_THAT(breachesOfOutlines(Gr2To(options).extract(generateBuilding(building).grid)),
                    testing::IsEmpty())
            << nameOf(building);
}

TEST(Outlines, lieInTheWallsPlaneAtDoors)
{
    int doors = 0, inPlane = 0;
    for (const TBuildingOptions& options : variousBuildings()) {
        const Building building = generateBuilding(options);
        const Extraction e = Gr2To().extract(building.grid);
        for (const BuildingDoor& door : building.doors) {
            const Vector2d beyond = passage(door) * (door.thickness_m / 2 + 0.3);
            const PlaceId a = placeAt(e, door.centre - beyond), b = placeAt(e, door.centre + beyond);
            if (door.closed || a == 0 || b == 0 || a == b) continue;
            ++doors;
            inPlane += distanceFromBorder(e, door, a, b) <= door.thickness_m / 2 + e.grid.resolution_m();
        }
    }
    EXPECT_GT(doors, 400);
    EXPECT_GE(inPlane, 0.995 * doors) << doors << " doors; a place that is cut wrongly may end beside one";
}

TEST(Outlines, lieOnTheStraightLineBetweenTheCornersOfAnOpening)
{
    ClassifiedGrid grid = solid(205, 102);
    carve(grid, {1, 1}, {100, 100});
    carve(grid, {104, 1}, {203, 100});
    carve(grid, {101, 31}, {103, 70});
    const Extraction e = Gr2To().extract(grid);
    ASSERT_EQ(e.map.places().size(), 2u);
    const auto sides = commonSides(polygonOf(e.map.place(1).boundary), polygonOf(e.map.place(2).boundary));
    ASSERT_EQ(sides.size(), 1u);
    const auto [from, to] = sides.front();
    const double cell = grid.resolution_m();
    for (const Vector2d& p : {from, to}) {
        EXPECT_GE(p.x(), 101 * cell - 1e-9) << "between the faces of the wall";
        EXPECT_LE(p.x(), 104 * cell + 1e-9);
    }
    EXPECT_EQ(from.x(), to.x());
    EXPECT_NEAR(std::min(from.y(), to.y()), 31 * cell, 1e-9);
    EXPECT_NEAR(std::max(from.y(), to.y()), 71 * cell, 1e-9);
    for (const auto& [id, place] : e.map.places())
        EXPECT_EQ(
            std::count_if(place.walls.begin(), place.walls.end(), [](const Wall& w) { return !w.real; }), 1)
            << "the opening";
}

TEST(Outlines, ofRoomsAreTheirWallsAndDoors)
{
    const Extraction e = Gr2To().extract(twoSquareRooms(17));
    const Place& room = e.map.place(1);
    EXPECT_EQ(room.boundary.size(), 8u) << "four corners and four at the door";
    ASSERT_EQ(room.walls.size(), 4u) << "the closed door is a part of its wall";
    for (const Wall& wall : room.walls) {
        EXPECT_TRUE(wall.real);
        EXPECT_NEAR(wall.size.length_m, 59 * 0.05, 4 * 0.05) << "with the corners' cells";
        EXPECT_NEAR(std::max(std::abs(wall.normal.mean.x), std::abs(wall.normal.mean.y)), 1, 0.01);
    }
}

TEST(Outlines, haveNoWallsAlongTheSlitsOfRings)
{
    ClassifiedGrid grid = solid(202, 202);
    carve(grid, {1, 1}, {200, 200});
    for (int y = 41; y <= 160; ++y)
        for (int x = 41; x <= 160; ++x) grid.set({x, y}, CellState::Occupied);
    const Extraction e = Gr2To().extract(grid);
    ASSERT_EQ(e.map.places().size(), 1u);
    const Place& ring = e.map.place(1);
    EXPECT_NEAR(areaOf(polygonOf(ring.boundary)), ring.area_m2, 0.02 * ring.area_m2);
    EXPECT_GE(ring.walls.size(), 8u);
    for (const Wall& wall : ring.walls) EXPECT_TRUE(wall.real) << "at " << wall.position.mean.asString();
}

TEST(Outlines, haveNoEffectOnPresetPaper)
{
    const Extraction e = Gr2To(Gr2ToOptions::preset("paper")).extract(twoSquareRooms(17));
    for (const auto& [id, place] : e.map.places()) EXPECT_EQ(place.boundary.size(), 8u) << "an octagon";
    EXPECT_THAT(commonSides(polygonOf(e.map.place(1).boundary), polygonOf(e.map.place(2).boundary)),
                testing::IsEmpty());
}

TEST(Outlines, ofAnnotatedMapsOfIpa)
{
    checkAnnotatedMaps("ipa");
}

TEST(Outlines, ofAnnotatedMapsOfRose)
{
    checkAnnotatedMaps("rose");
}

TEST(Outlines, areTheSameOnEveryRun)
{
    const ClassifiedGrid grid = generateBuilding(buildingOptions(5, 20, 0.2)).grid;
    EXPECT_TRUE(Gr2To().extract(grid).map == Gr2To().extract(grid).map);
}
