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

/** How a border lies in a door: sideways of the wall's middle at most, and over how much of the wall. */
struct BorderInDoor
{
    double off_m = 0, width_m = 0;
};

BorderInDoor borderInDoor(const BuildingDoor& door, const Polygon& border)
{
    BorderInDoor found;
    double first = 1e9, last = -1e9;
    for (const Vector2d& p : border) {
        const double along = across(door).dot(p - door.centre);
        if (std::abs(along) > door.width_m / 2 + 0.15 || std::abs(passage(door).dot(p - door.centre)) > 1)
            continue;  // another door between the same places
        found.off_m = std::max(found.off_m, std::abs(passage(door).dot(p - door.centre)));
        first = std::min(first, along);
        last = std::max(last, along);
    }
    found.width_m = std::max(0.0, last - first);
    return found;
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

TEST(Outlines, liePlanarInTheWallAtDoors)
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
            const BorderInDoor border = borderInDoor(
                door, commonVertices(polygonOf(e.map.place(a).boundary), polygonOf(e.map.place(b).boundary)));
            const double cell = e.grid.resolution_m();
            if (border.off_m <= door.thickness_m / 2 + cell && border.width_m >= door.width_m - 2 * cell)
                ++inPlane;
            else
                std::cerr << nameOf(options) << " door at " << door.centre.transpose() << " " << door.width_m
                          << " thick " << door.thickness_m << " off " << border.off_m << " width "
                          << border.width_m << "\n";
        }
    }
    EXPECT_GT(doors, 100);
    EXPECT_GE(inPlane, 0.97 * doors) << doors << " doors";
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
