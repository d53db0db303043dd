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
/** Straight and turned buildings of every layout. */
std::vector<TBuildingOptions> someBuildings()
{
    std::vector<TBuildingOptions> all;
    for (const double rotation : {0.0, 10.0, 17.0, 30.0, 45.0})
        for (const char* layout : {"straight", "l", "t", "cross", "ring"}) {
            auto o = buildingOptions(static_cast<int>(all.size()) + 1, rotation);
            o.layout = layout;
            o.width = 24;
            o.height = o.layout == "ring" ? 22 : 16;
            all.push_back(o);
        }
    return all;
}

DoorTopology topologyOf(const ClassifiedGrid& grid)
{
    return {grid, Gr2To().extract(grid)};
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
    for (const int seed : {5, 6, 10}) {
        auto options = buildingOptions(seed, 30);
        options.width = 24, options.height = 16;
        const ClassifiedGrid grid = generateBuilding(options).grid;
        const Symmetry turn{false, 1};
        const ClassifiedGrid turned = turn.apply(grid);
        const Diagram a = diagramOf(grid), b = diagramOf(turned);
        std::vector<Cell> original, moved;
        for (const std::uint32_t i : a.voronoi.cells)
            original.push_back(turn.apply(grid.cell(i), grid.width(), grid.height()));
        for (const std::uint32_t i : b.voronoi.cells) moved.push_back(turned.cell(i));
        const std::size_t far = farCells(original, moved, turned.width(), turned.height(), 3) +
                                farCells(moved, original, turned.width(), turned.height(), 3);
        EXPECT_LE(static_cast<double>(far), 0.005 * static_cast<double>(original.size())) << "seed " << seed;
    }
}
