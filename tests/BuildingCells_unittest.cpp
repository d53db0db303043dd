#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "support/buildingMeasures.h"

using gr2to::Cell;
using gr2to::CellState;
using namespace gr2to::test;

namespace
{
std::string complaint(const std::function<void(TBuildingOptions&)>& change)
{
    TBuildingOptions o;
    change(o);
    try {
        generateBuilding(o);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "no complaint";
}
}  // namespace

TEST(BuildingCells, closedDoorsAreWall)
{
    auto o = buildingOptions(3);
    o.closed_doors = 1.0;
    const auto b = generateBuilding(o);
    EXPECT_EQ(freeComponents(b.grid).count, static_cast<int>(b.rooms.size()));
    for (const auto& door : b.doors) EXPECT_TRUE(b.grid.isOccupied(cellAt(b.grid, door.centre)));
    EXPECT_THAT(annotationJson(b, "b"), testing::HasSubstr("\"interfaces\": [\n  \n ]"));
}

TEST(BuildingCells, labelsCoverExactlyTheFreeCells)
{
    auto noisy = buildingOptions(8, 33.0, 0.2);
    noisy.noise = 0.1, noisy.speckle = 0.01, noisy.wall_jitter = 0.3;
    auto all = variousBuildings();
    all.push_back(noisy);
    for (const auto& o : all) {
        const auto b = generateBuilding(o);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < b.grid.size(); ++i)
            wrong += (b.grid[i] == CellState::Free) != (b.labels.ids[i] != 0) ? 1U : 0U;
        EXPECT_EQ(wrong, 0u) << nameOf(o);
    }
}

TEST(BuildingCells, furnitureTakesFloorButLeavesEveryDoorFree)
{
    for (int seed = 1; seed <= 6; ++seed) {
        const auto bare = generateBuilding(buildingOptions(seed)),
                   full = generateBuilding(buildingOptions(seed, 0.0, 0.3));
        EXPECT_LT(static_cast<double>(full.grid.count(CellState::Free)),
                  0.97 * static_cast<double>(bare.grid.count(CellState::Free)));
        for (const auto& door : full.doors)
            for (const double side : {-1.0, 1.0})
                for (const double shift : {-0.4, 0.0, 0.4}) {
                    const Eigen::Vector2d p = door.centre +
                                              side * (door.thickness_m / 2 + 0.8) * passage(door) +
                                              shift * door.width_m * across(door);
                    if (bare.grid.isFree(cellAt(bare.grid, p))) {
                        EXPECT_TRUE(full.grid.isFree(cellAt(full.grid, p))) << "seed " << seed;
                    }
                }
    }
}

TEST(BuildingCells, noiseAndSpeckleFlipTheStatedShares)
{
    auto o = buildingOptions(9);
    const auto clean = generateBuilding(o);
    o.noise = 0.2;
    o.speckle = 0.02;
    const auto noisy = generateBuilding(o);
    double edges = 0, edgeFlips = 0, inner = 0, innerFlips = 0;
    for (std::size_t i = 0; i < clean.grid.size(); ++i) {
        const auto state = clean.grid[i];
        const Cell c = clean.grid.cell(i);
        bool edge = false;
        for (const Cell n : {Cell{c.x + 1, c.y}, Cell{c.x - 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x, c.y - 1}})
            edge = edge || (state == CellState::Free && clean.grid.isOccupied(n)) ||
                   (state == CellState::Occupied && clean.grid.isFree(n));
        const double flipped = noisy.grid[i] == state ? 0 : 1;
        if (edge)
            ++edges, edgeFlips += flipped;
        else if (state == CellState::Free)
            ++inner, innerFlips += flipped;
        else
            EXPECT_EQ(flipped, 0);
    }
    EXPECT_NEAR(edgeFlips / edges, 0.2, 0.01);
    EXPECT_NEAR(innerFlips / inner, 0.02, 0.001);
}

TEST(BuildingCells, wallJitterMovesWallsByOneCellAndKeepsThemClosed)
{
    auto o = buildingOptions(9);
    o.closed_doors = 1.0;
    const auto clean = generateBuilding(o);
    o.wall_jitter = 0.5;
    const auto jittered = generateBuilding(o);
    EXPECT_FALSE(clean.grid == jittered.grid);
    EXPECT_EQ(freeComponents(jittered.grid).count, static_cast<int>(clean.rooms.size()));
}

TEST(BuildingCells, surroundingsAreUnknownAsFarAsTheMargin)
{
    auto o = buildingOptions(2);
    o.margin = 2.0;
    const auto b = generateBuilding(o);
    const int cells = static_cast<int>(o.margin / o.resolution);
    for (int y = 0; y < b.grid.height(); ++y)
        for (int x = 0; x < cells; ++x) ASSERT_EQ(b.grid.at({x, y}), CellState::Unknown);
    int walls = 0;
    for (int y = 0; y < b.grid.height(); ++y) walls += b.grid.isOccupied({cells + 1, y}) ? 1 : 0;
    EXPECT_GT(walls, 0);
}

TEST(BuildingCells, annotationHasTheKeysThatTheScorerReads)
{
    const auto b = generateBuilding(buildingOptions(2));
    const auto json = annotationJson(b, "office");
    for (const char* key :
         {"\"map\": \"office\"", "\"resolution_m\": 0.05", "\"rooms\"", "\"centroid_px\"", "\"is_corridor\"",
          "\"interfaces\"", "\"mid_px\"", "\"width_m\"", "\"kind\": \"door\"", "\"walls\""})
        EXPECT_THAT(json, testing::HasSubstr(key));
    EXPECT_THAT(
        gr2to::test::mapServerYaml(b.grid, "office.png"),
        testing::AllOf(testing::HasSubstr("image: office.png\n"), testing::HasSubstr("origin: [0, 0, 0]\n")));
}

TEST(BuildingCells, unreasonableOptionsAreRefusedByName)
{
    using testing::HasSubstr;
    EXPECT_THAT(complaint([](auto& o) { o.resolution = 0; }), HasSubstr("building.resolution"));
    EXPECT_THAT(complaint([](auto& o) { o.resolution = std::nan(""); }), HasSubstr("building.resolution"));
    EXPECT_THAT(complaint([](auto& o) { o.door_min_width = 1.2; }),
                HasSubstr("must not exceed door_max_width"));
    EXPECT_THAT(complaint([](auto& o) { o.room_min_size = 1.1; }), HasSubstr("leaves no wall for a door"));
    EXPECT_THAT(complaint([](auto& o) { o.corridor_width = 1.0; }), HasSubstr("building.corridor_width"));
    EXPECT_THAT(complaint([](auto& o) { o.room_max_size = 2; }), HasSubstr("must not exceed room_max_size"));
    EXPECT_THAT(complaint([](auto& o) { o.wall_thickness = 0.05; }), HasSubstr("1.5 cells"));
    EXPECT_THAT(complaint([](auto& o) { o.outer_wall_thickness = 0.1; }), HasSubstr("outer_wall_thickness"));
    EXPECT_THAT(complaint([](auto& o) { o.height = 6; }), HasSubstr("building.height = 6 m is too small"));
    EXPECT_THAT(complaint([](auto& o) { o.tiles_x = o.tiles_y = 200; }), HasSubstr("too many cells"));
    EXPECT_THAT(complaint([](auto& o) { o.layout = "maze"; }), HasSubstr("building.layout"));
    EXPECT_THAT(complaint([](auto& o) { o.noise = -0.1; }), HasSubstr("building.noise"));
}
