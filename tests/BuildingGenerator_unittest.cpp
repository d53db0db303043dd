#include "support/BuildingGenerator.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{
using gr2to::Cell;
using gr2to::CellState;
using gr2to::ClassifiedGrid;
using gr2to::PlaceId;
using gr2to::test::Building;
using gr2to::test::BuildingDoor;
using gr2to::test::generateBuilding;
using gr2to::test::TBuildingOptions;

constexpr double kPi = 3.14159265358979323846;

TBuildingOptions options(int seed, double rotation = 0.0, double furniture = 0.0)
{
    TBuildingOptions o;
    o.seed = seed;
    o.rotation = rotation;
    o.furniture = furniture;
    return o;
}

/** A dozen buildings of every layout, straight and turned, bare and furnished. */
std::vector<TBuildingOptions> variety()
{
    std::vector<TBuildingOptions> all;
    int seed = 100;
    for (const char* layout : {"straight", "l", "t", "cross", "ring"})
        for (const double rotation : {0.0, 27.0, 90.0}) {
            auto o = options(++seed, rotation, rotation == 0.0 ? 0.0 : 0.15);
            o.layout = layout;
            o.height = 24;
            all.push_back(o);
        }
    return all;
}

Cell cellAt(const ClassifiedGrid& grid, const Eigen::Vector2d& p)
{
    const auto c = grid.frame().toGrid(p.x(), p.y());
    return {static_cast<int>(std::lround(c.x())), static_cast<int>(std::lround(c.y()))};
}

Eigen::Vector2d passage(const BuildingDoor& door)
{
    return {std::cos(door.angle_rad), std::sin(door.angle_rad)};
}
Eigen::Vector2d across(const BuildingDoor& door)
{
    return {-std::sin(door.angle_rad), std::cos(door.angle_rad)};
}

/** Free length through the door's centre along its wall, sampled at a tenth of a cell [m]. */
double freeRun(const ClassifiedGrid& grid, const BuildingDoor& door)
{
    const double step = grid.resolution_m() / 10;
    double length = step;
    for (const double sign : {1.0, -1.0})
        for (int i = 1; grid.isFree(cellAt(grid, door.centre + sign * i * step * across(door))); ++i)
            length += step;
    return length;
}

/** Number of the 4-connected free component of every cell, from 1; 0 elsewhere. Cells in `shut` are left out.
 */
std::vector<int> components(const ClassifiedGrid& grid, const std::vector<bool>& shut, int& count)
{
    std::vector<int> number(grid.size(), 0);
    count = 0;
    for (std::size_t seed = 0; seed < grid.size(); ++seed) {
        if (grid[seed] != CellState::Free || shut[seed] || number[seed] != 0) continue;
        number[seed] = ++count;
        std::vector<std::size_t> open{seed};
        while (!open.empty()) {
            const Cell c = grid.cell(open.back());
            open.pop_back();
            for (const Cell n :
                 {Cell{c.x + 1, c.y}, Cell{c.x - 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x, c.y - 1}}) {
                if (!grid.isFree(n)) continue;
                const auto i = grid.index(n);
                if (shut[i] || number[i] != 0) continue;
                number[i] = count;
                open.push_back(i);
            }
        }
    }
    return number;
}

std::vector<bool> nothingShut(const Building& b)
{
    return std::vector<bool>(b.grid.size(), false);
}

/** The cells of all doorways by the annotation: the opening in the thickness of its wall, half a cell more
 * around. */
std::vector<bool> doorways(const Building& b)
{
    auto shut = nothingShut(b);
    const double res = b.grid.resolution_m();
    for (const auto& door : b.doors) {
        const int reach = static_cast<int>((door.width_m + door.thickness_m) / res) + 2;
        const Cell centre = cellAt(b.grid, door.centre);
        for (int y = centre.y - reach; y <= centre.y + reach; ++y)
            for (int x = centre.x - reach; x <= centre.x + reach; ++x) {
                if (!b.grid.contains({x, y})) continue;
                const Eigen::Vector2d d = b.grid.frame().toMap(x, y) - door.centre;
                if (std::abs(d.dot(across(door))) <= door.width_m / 2 + res / 2 &&
                    std::abs(d.dot(passage(door))) <= door.thickness_m / 2 + res / 2)
                    shut[b.grid.index({x, y})] = true;
            }
    }
    return shut;
}

std::string nameOf(const TBuildingOptions& o)
{
    return "seed " + std::to_string(o.seed) + ", " + o.layout + ", " + std::to_string(o.rotation) + " deg";
}

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

TEST(BuildingGenerator, sameSeedGivesTheSameBytesAndAnotherSeedAnotherBuilding)
{
    auto o = options(5, 12.0, 0.1);
    o.noise = o.speckle = o.wall_jitter = 0.05;
    const auto first = generateBuilding(o), second = generateBuilding(o);
    EXPECT_TRUE(first.grid == second.grid);
    EXPECT_EQ(first.labels.ids, second.labels.ids);
    EXPECT_EQ(annotationJson(first, "b"), annotationJson(second, "b"));
    o.seed = 6;
    EXPECT_NE(annotationJson(first, "b"), annotationJson(generateBuilding(o), "b"));
}

TEST(BuildingGenerator, planIsTheSameOnEveryPlatform)
{
    // figures of seed 1 as first generated: std::mt19937 and plain arithmetic leave no freedom
    const auto b = generateBuilding(options(1));
    EXPECT_EQ(b.rooms.size(), 26u);
    EXPECT_EQ(b.doors.size(), 27u);
}

TEST(BuildingGenerator, doorsMeasuredInTheGridAreAsWideAsAnnotated)
{
    for (const auto& o : variety()) {
        const auto b = generateBuilding(o);
        ASSERT_GE(b.doors.size(), 5u);
        for (const auto& door : b.doors) {
            EXPECT_GE(door.width_m, o.door_min_width);
            EXPECT_LE(door.width_m, 1.5 * o.door_max_width);
            EXPECT_NEAR(freeRun(b.grid, door), door.width_m, 1.5 * o.resolution)
                << nameOf(o) << ", door at " << door.centre.transpose();
        }
    }
}

TEST(BuildingGenerator, doorsLieBetweenTheRoomsThatTheyName)
{
    for (const auto& o : variety()) {
        const auto b = generateBuilding(o);
        for (const auto& door : b.doors) {
            const Eigen::Vector2d step = passage(door) * (door.thickness_m / 2 + 2 * o.resolution);
            EXPECT_LT(door.a, door.b);
            EXPECT_EQ(b.labels.at(cellAt(b.grid, door.centre - step)), door.a) << nameOf(o);
            EXPECT_EQ(b.labels.at(cellAt(b.grid, door.centre + step)), door.b) << nameOf(o);
        }
    }
}

TEST(BuildingGenerator, openDoorsJoinAllRoomsAndShutOnesPartThem)
{
    for (const auto& o : variety()) {
        const auto b = generateBuilding(o);
        int count = 0;
        components(b.grid, nothingShut(b), count);
        EXPECT_EQ(count, 1) << nameOf(o);

        const auto shut = doorways(b);
        const auto number = components(b.grid, shut, count);
        EXPECT_EQ(count, static_cast<int>(b.rooms.size())) << nameOf(o);
        std::map<int, std::set<PlaceId>> labels;
        for (std::size_t i = 0; i < number.size(); ++i)
            if (number[i] != 0) labels[number[i]].insert(b.labels.ids[i]);
        for (const auto& [component, ids] : labels) EXPECT_EQ(ids.size(), 1u) << nameOf(o);
    }
}

TEST(BuildingGenerator, closedDoorsAreWall)
{
    auto o = options(3);
    o.closed_doors = 1.0;
    const auto b = generateBuilding(o);
    int count = 0;
    components(b.grid, nothingShut(b), count);
    EXPECT_EQ(count, static_cast<int>(b.rooms.size()));
    for (const auto& door : b.doors) EXPECT_TRUE(b.grid.isOccupied(cellAt(b.grid, door.centre)));
    EXPECT_THAT(annotationJson(b, "b"), testing::HasSubstr("\"interfaces\": [\n  \n ]"));
}

TEST(BuildingGenerator, labelsCoverExactlyTheFreeCells)
{
    auto noisy = options(8, 33.0, 0.2);
    noisy.noise = 0.1, noisy.speckle = 0.01, noisy.wall_jitter = 0.3;
    auto all = variety();
    all.push_back(noisy);
    for (const auto& o : all) {
        const auto b = generateBuilding(o);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < b.grid.size(); ++i)
            wrong += (b.grid[i] == CellState::Free) != (b.labels.ids[i] != 0) ? 1U : 0U;
        EXPECT_EQ(wrong, 0u) << nameOf(o);
    }
}

TEST(BuildingGenerator, anotherResolutionShowsTheSameBuilding)
{
    auto o = options(11, 12.0, 0.1);
    const auto coarse = generateBuilding(o);
    o.resolution = 0.025;
    const auto fine = generateBuilding(o);
    ASSERT_EQ(coarse.doors.size(), fine.doors.size());
    for (std::size_t i = 0; i < fine.doors.size(); ++i)
        EXPECT_EQ(coarse.doors[i].centre, fine.doors[i].centre);
    ASSERT_EQ(coarse.walls.size(), fine.walls.size());
    std::size_t differing = 0;
    for (std::size_t i = 0; i < coarse.grid.size(); ++i) {
        const Cell c = coarse.grid.cell(i);
        const auto p = coarse.grid.frame().toMap(c);
        const Cell f{static_cast<int>(p.x() / 0.025), static_cast<int>(p.y() / 0.025)};
        if (fine.grid.contains(f) && fine.grid.at(f) != coarse.grid.at(c)) ++differing;
    }
    EXPECT_LT(static_cast<double>(differing), 0.03 * static_cast<double>(coarse.grid.size()));
}

TEST(BuildingGenerator, areasOfLabelsAndPolygonsAreThoseOfTheRoomsAtAnyRotation)
{
    for (const double rotation : {0.0, 12.0, 45.0, 90.0, -133.0}) {
        const auto b = generateBuilding(options(4, rotation));
        std::vector<double> cells(b.rooms.size() + 1, 0.0);
        for (const auto id : b.labels.ids) ++cells[id];
        std::vector<double> doorways(b.rooms.size() + 1, 0.0);
        for (const auto& d : b.doors)
            for (const auto id : {d.a, d.b}) doorways[id] += d.width_m * d.thickness_m / 2;
        for (const auto& room : b.rooms) {
            double shoelace = 0, perimeter = 0;
            for (std::size_t i = 0; i < room.polygon.size(); ++i) {
                const auto &p = room.polygon[i], &q = room.polygon[(i + 1) % room.polygon.size()];
                shoelace += (p.x() * q.y() - q.x() * p.y()) / 2;
                perimeter += (q - p).norm();
            }
            EXPECT_NEAR(shoelace, room.area_m2, 1e-6);
            const double measured = cells[room.id] * b.grid.resolution_m() * b.grid.resolution_m();
            EXPECT_NEAR(measured, room.area_m2 + doorways[room.id], perimeter * b.grid.resolution_m() / 2)
                << "room " << room.id << " at " << rotation << " deg";
            EXPECT_EQ(b.labels.at(cellAt(b.grid, room.inner)), room.id);
        }
    }
}

TEST(BuildingGenerator, wallsLieOnTheFacesOfTheirRooms)
{
    for (const auto& o : variety()) {
        const auto b = generateBuilding(o);
        std::map<PlaceId, double> length;
        for (const auto& wall : b.walls) {
            const Eigen::Vector2d along = (wall.to - wall.from).normalized(), inward(-along.y(), along.x());
            length[wall.room] += (wall.to - wall.from).norm();
            // a fifth from its end a wall may be interrupted by a door, but wall or doorway it is
            const Eigen::Vector2d p = wall.from + 0.2 * (wall.to - wall.from);
            const PlaceId behind =
                b.labels.at(cellAt(b.grid, p - inward * (wall.thickness_m + 2 * o.resolution)));
            if (behind != 0) {
                EXPECT_EQ(behind, wall.behind) << nameOf(o);
            }
            EXPECT_EQ(wall.thickness_m, wall.behind == 0 ? o.outer_wall_thickness : o.wall_thickness);
        }
        for (const auto& room : b.rooms) {
            double perimeter = 0;
            for (std::size_t i = 0; i < room.polygon.size(); ++i)
                perimeter += (room.polygon[(i + 1) % room.polygon.size()] - room.polygon[i]).norm();
            EXPECT_NEAR(length[room.id], perimeter, 0.05 * perimeter) << nameOf(o) << ", room " << room.id;
        }
    }
}

TEST(BuildingGenerator, furnitureTakesFloorButLeavesEveryDoorFree)
{
    for (int seed = 1; seed <= 6; ++seed) {
        const auto bare = generateBuilding(options(seed)), full = generateBuilding(options(seed, 0.0, 0.3));
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

TEST(BuildingGenerator, noiseAndSpeckleFlipTheStatedShares)
{
    auto o = options(9);
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

TEST(BuildingGenerator, wallJitterMovesWallsByOneCellAndKeepsThemClosed)
{
    auto o = options(9);
    o.closed_doors = 1.0;
    const auto clean = generateBuilding(o);
    o.wall_jitter = 0.5;
    const auto jittered = generateBuilding(o);
    EXPECT_FALSE(clean.grid == jittered.grid);
    int count = 0;
    components(jittered.grid, nothingShut(jittered), count);
    EXPECT_EQ(count, static_cast<int>(clean.rooms.size()));
}

TEST(BuildingGenerator, tilesJoinIntoOneBuilding)
{
    auto o = options(2);
    o.tiles_x = 3;
    o.tiles_y = 2;
    o.resolution = 0.1;
    const auto b = generateBuilding(o);
    int count = 0;
    components(b.grid, nothingShut(b), count);
    EXPECT_EQ(count, 1);
    EXPECT_GT(b.rooms.size(), 100u);
    EXPECT_NEAR(b.grid.width() * o.resolution, 3 * o.width + 2 * o.margin + o.outer_wall_thickness, 0.5);
}

TEST(BuildingGenerator, surroundingsAreUnknownAsFarAsTheMargin)
{
    auto o = options(2);
    o.margin = 2.0;
    const auto b = generateBuilding(o);
    const int cells = static_cast<int>(o.margin / o.resolution);
    for (int y = 0; y < b.grid.height(); ++y)
        for (int x = 0; x < cells; ++x) ASSERT_EQ(b.grid.at({x, y}), CellState::Unknown);
    int walls = 0;
    for (int y = 0; y < b.grid.height(); ++y) walls += b.grid.isOccupied({cells + 1, y}) ? 1 : 0;
    EXPECT_GT(walls, 0);
}

TEST(BuildingGenerator, annotationHasTheKeysThatTheScorerReads)
{
    const auto b = generateBuilding(options(2));
    const auto json = annotationJson(b, "office");
    for (const char* key :
         {"\"map\": \"office\"", "\"resolution_m\": 0.05", "\"rooms\"", "\"centroid_px\"", "\"is_corridor\"",
          "\"interfaces\"", "\"mid_px\"", "\"width_m\"", "\"kind\": \"door\"", "\"walls\""})
        EXPECT_THAT(json, testing::HasSubstr(key));
    EXPECT_THAT(
        gr2to::test::mapServerYaml(b.grid, "office.png"),
        testing::AllOf(testing::HasSubstr("image: office.png\n"), testing::HasSubstr("origin: [0, 0, 0]\n")));
}

TEST(BuildingGenerator, unreasonableOptionsAreRefusedByName)
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
