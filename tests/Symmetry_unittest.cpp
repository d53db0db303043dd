#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/buildingMeasures.h"
#include "support/regions.h"
#include "support/rooms.h"
#include "support/symmetry.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
TBuildingOptions building(int seed, double rotation_deg)
{
    const char* layouts[] = {"straight", "l", "t", "cross", "ring"};
    auto o = buildingOptions(seed, rotation_deg);
    o.layout = layouts[seed % 5];
    o.width = 24;
    o.height = o.layout == "ring" ? 22 : 16;
    return o;
}

/** Straight and turned buildings of every layout. */
std::vector<TBuildingOptions> someBuildings()
{
    std::vector<TBuildingOptions> all;
    for (const double rotation : {0.0, 10.0, 17.0, 30.0, 45.0})
        for (int seed = 1; seed <= 5; ++seed) all.push_back(building(seed, rotation));
    return all;
}

/** Places as circles along the Voronoi diagram, as in the paper, with the rest of preset default. */
Gr2ToOptions circles()
{
    Gr2ToOptions options;
    options.cut.along_walls = false;
    return options;
}

DoorTopology topologyOf(const ClassifiedGrid& grid, const Gr2ToOptions& options = circles())
{
    return {grid, Gr2To(options).extract(grid)};
}

/** A door askew to the grid may be drawn at either face of its wall, three cells thick, and a cell beside. */
RegionTolerance toleranceFor(const TBuildingOptions& options, double cellsPerCell = 1)
{
    const bool straight = options.rotation == 0;
    return {straight ? 0.02 : 0.05, (straight ? 2 : 4) * cellsPerCell, 1.0};
}

void expectSameCounts(const DoorTopology& a, const DoorTopology& b, std::size_t tolerance)
{
    const auto places = [](const DoorTopology& t) {
        return static_cast<double>(t.extraction.map.places().size());
    };
    const auto joins = [](const DoorTopology& t) {
        return static_cast<double>(t.extraction.map.connections().size());
    };
    EXPECT_NEAR(places(a), places(b), static_cast<double>(tolerance));
    EXPECT_NEAR(joins(a), joins(b), static_cast<double>(tolerance));
}

/** Cells of a diagram with no cell of another within a distance. */
std::size_t farCells(const std::vector<Cell>& cells, const std::vector<Cell>& others, int width, int height,
                     double distance)
{
    ClassifiedGrid grid(width, height, GridFrame{}, CellState::Free);
    for (const Cell c : others) grid.set(c, CellState::Occupied);
    const DistanceMap distances = measureDistances(grid, Obstacles::Occupied);
    return static_cast<std::size_t>(std::count_if(
        cells.begin(), cells.end(), [&](Cell c) { return distances.clearance_cells(c) > distance; }));
}
}  // namespace

TEST(Symmetry, quarterTurnsAndMirrorsPermuteTheGraph)
{
    for (const TBuildingOptions& options : someBuildings()) {
        const ClassifiedGrid grid = generateBuilding(options).grid;
        const DoorTopology original = topologyOf(grid);
        for (const Symmetry& symmetry : symmetries()) {
            SCOPED_TRACE(nameOf(options) + ", " + symmetry.name());
            const DoorTopology moved = topologyOf(symmetry.apply(grid));
            const auto move = [&](Cell c) { return symmetry.apply(c, grid.width(), grid.height()); };
            EXPECT_EQ(differenceBetween(original, moved, move, toleranceFor(options)), "");
            expectSameCounts(original, moved, options.rotation == 0 ? 0 : 1);
        }
    }
}

/** Walls are found on lines of cells, which lie differently in a turned grid: counts may differ by little. */
TEST(Symmetry, quarterTurnsAndMirrorsHardlyChangePlacesAlongWalls)
{
    double places = 0, difference = 0;
    for (const TBuildingOptions& options : someBuildings()) {
        const ClassifiedGrid grid = generateBuilding(options).grid;
        const auto count = [](const ClassifiedGrid& g) {
            return static_cast<double>(Gr2To().extract(g).map.places().size());
        };
        const double original = count(grid);
        for (const Symmetry& symmetry : symmetries()) {
            SCOPED_TRACE(nameOf(options) + ", " + symmetry.name());
            places += original;
            difference += std::abs(count(symmetry.apply(grid)) - original);
        }
    }
    EXPECT_LE(difference, 0.04 * places);
}

TEST(Symmetry, halfTheCellSizeKeepsTheTopology)
{
    for (TBuildingOptions options : someBuildings()) {
        SCOPED_TRACE(nameOf(options));
        const ClassifiedGrid coarse = generateBuilding(options).grid;
        options.resolution /= 2;
        const ClassifiedGrid fine = generateBuilding(options).grid;
        const auto move = [&](Cell c) { return cellAt(fine, coarse.frame().toMap(c)); };
        RegionTolerance tolerance = toleranceFor(options, 2);
        tolerance.area = 0.05;  // walls gain or lose half a cell
        const DoorTopology a = topologyOf(coarse), b = topologyOf(fine);
        EXPECT_EQ(differenceBetween(a, b, move, tolerance), "");
        expectSameCounts(a, b, 1);
    }
}

TEST(Symmetry, comparisonOfRegionsSeesAClosedDoorAndAMovedOne)
{
    const DoorTopology two = topologyOf(twoSquareRooms(17));
    const auto stay = [](Cell c) { return c; };
    EXPECT_EQ(differenceBetween(two, two, stay), "");
    EXPECT_NE(differenceBetween(two, topologyOf(twoSquareRooms(0)), stay), "");
    ClassifiedGrid moved = twoSquareRooms(0);
    carve(moved, {60, 12}, {61, 28});
    EXPECT_NE(differenceBetween(two, topologyOf(moved), stay), "");
    ClassifiedGrid smaller = twoSquareRooms(17);
    for (int y = 1; y < 60; ++y) smaller.set({120, y}, CellState::Occupied);
    EXPECT_NE(differenceBetween(two, topologyOf(smaller), stay, {0.01, 2, 1}), "");
    EXPECT_EQ(differenceBetween(two, topologyOf(smaller), stay, {0.05, 2, 1}), "");
}

/** Bands of rows were once thinned one ahead of the other, and straight curves stayed along their borders. */
TEST(Symmetry, bandsOfTheThinningLeaveNoCurvesAlongTheirBorders)
{
    for (const TBuildingOptions& options : {building(5, 17), building(6, 30), building(3, 45)}) {
        const ClassifiedGrid grid = generateBuilding(options).grid;
        const Diagram diagram = diagramOf(grid);
        std::vector<Cell> original;
        for (const std::uint32_t i : diagram.voronoi.cells) original.push_back(grid.cell(i));
        const Symmetry turn{false, 1};
        const ClassifiedGrid turned = turn.apply(grid);
        const Diagram turnedDiagram = diagramOf(turned);
        std::vector<Cell> back;
        for (const std::uint32_t i : turnedDiagram.voronoi.cells)
            back.push_back(Symmetry{false, 3}.apply(turned.cell(i), turned.width(), turned.height()));
        const std::size_t far = farCells(original, back, grid.width(), grid.height(), 3) +
                                farCells(back, original, grid.width(), grid.height(), 3);
        EXPECT_LE(far, 5u) << nameOf(options);
    }
}
