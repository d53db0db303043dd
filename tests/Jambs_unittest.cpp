#include "gr2to/grid/Jambs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/drawMap.h"
#include "support/rooms.h"

using namespace gr2to;

namespace
{
int squared(Cell a, Cell b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

int dot(Cell at, Cell a, Cell b)
{
    return (a.x - at.x) * (b.x - at.x) + (a.y - at.y) * (b.y - at.y);
}

/** Free cells within a half width of a line through the grid's middle, walls all around. */
ClassifiedGrid slantingCorridor(double angle_rad, double halfWidth)
{
    ClassifiedGrid grid = test::solid(61, 61);
    for (int y = 0; y < 61; ++y)
        for (int x = 0; x < 61; ++x) {
            const double across = -(x - 30) * std::sin(angle_rad) + (y - 30) * std::cos(angle_rad);
            const double along = (x - 30) * std::cos(angle_rad) + (y - 30) * std::sin(angle_rad);
            if (std::abs(across) <= halfWidth && std::abs(along) <= 24) grid.set({x, y}, CellState::Free);
        }
    return grid;
}

/** Whether a way over the sides of free cells leads from one cell to another beside a line. */
bool connectedBeside(const std::vector<Cell>& line, const ClassifiedGrid& grid, Cell from, Cell to)
{
    std::set<std::size_t> seen{grid.index(from)};
    for (const Cell c : line) seen.insert(grid.index(c));
    std::vector<Cell> open{from};
    while (!open.empty()) {
        const Cell c = open.back();
        open.pop_back();
        if (c == to) return true;
        for (const Cell n : {Cell{c.x + 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x - 1, c.y}, Cell{c.x, c.y - 1}})
            if (grid.isFree(n) && seen.insert(grid.index(n)).second) open.push_back(n);
    }
    return false;
}

void expectEightConnected(const std::vector<Cell>& line)
{
    std::set<std::pair<int, int>> cells;
    for (const Cell c : line) cells.insert({c.x, c.y});
    EXPECT_EQ(cells.size(), line.size()) << "no cell twice";
    std::vector<std::pair<int, int>> open{*cells.begin()};
    cells.erase(cells.begin());
    while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (cells.erase({x + dx, y + dy}) > 0) open.emplace_back(x + dx, y + dy);
    }
    EXPECT_TRUE(cells.empty()) << cells.size() << " cells are apart";
}
}  // namespace

TEST(Jambs, ofAStraightDoorAreTheEndsOfItsWall)
{
    const ClassifiedGrid grid = test::twoSquareRooms(17);
    const auto jambs = findJambs(grid, Obstacles::Occupied, {60, 30}, 9.0);
    ASSERT_TRUE(jambs);
    const std::set<int> rows{jambs->nearest.y, jambs->facing.y};
    EXPECT_EQ(rows, (std::set<int>{21, 39}));
    EXPECT_EQ(jambs->nearest.x, 60);
    EXPECT_EQ(jambs->facing.x, 60);
}

TEST(Jambs, facingOneMayBeACellOrTwoFarther)
{
    const auto grid = test::drawMap({"..#..", ".....", ".....", ".....", ".....", "..#.."});
    const auto jambs = findJambs(grid, Obstacles::Occupied, {2, 2}, 2.0);
    ASSERT_TRUE(jambs);
    EXPECT_EQ(jambs->nearest, (Cell{2, 0}));
    EXPECT_EQ(jambs->facing, (Cell{2, 5}));
}

TEST(Jambs, ofADiagonalDoorFaceEachOther)
{
    ClassifiedGrid grid(31, 31, GridFrame{}, CellState::Free);
    for (int k = 0; k < 31; ++k)
        if (k < 11 || k > 19)
            for (int t = 0; t < 2; ++t)
                if (k + t < 31) grid.set({k + t, k}, CellState::Occupied);
    const auto jambs = findJambs(grid, Obstacles::Occupied, {15, 15}, std::sqrt(41.0));
    ASSERT_TRUE(jambs);
    EXPECT_LT(dot({15, 15}, jambs->nearest, jambs->facing), 0);
    EXPECT_NEAR(std::sqrt(squared(jambs->nearest, jambs->facing)), 10 * std::sqrt(2.0), 1.0);
}

TEST(Jambs, thereAreNoneWhenAllObstaclesLieOnOneSide)
{
    const auto grid = test::drawMap({".....", ".....", "..#..", ".###."});
    EXPECT_FALSE(findJambs(grid, Obstacles::Occupied, {2, 3}, 2.0));
    EXPECT_FALSE(findJambs(grid, Obstacles::Occupied, {0, 3}, 1.0)) << "no obstacle that near";
}

TEST(Jambs, unknownCellsCountOnlyWhenAsked)
{
    const auto grid = test::drawMap({"..?..", ".....", ".....", ".....", "..#.."});
    EXPECT_TRUE(findJambs(grid, Obstacles::OccupiedOrUnknown, {2, 2}, 2.0));
    EXPECT_FALSE(findJambs(grid, Obstacles::Occupied, {2, 2}, 2.0));
}

TEST(Jambs, areTheNearestOfTheirSidesOnRandomMaps)
{
    std::size_t found = 0, none = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        const auto grid = test::randomMap(40, 33, seed, 0.04, seed % 2 ? 0.02 : 0.0);
        const Obstacles obstacles = seed % 4 < 2 ? Obstacles::Occupied : Obstacles::OccupiedOrUnknown;
        const test::Diagram diagram = test::diagramOf(grid, obstacles, 0.15);
        for (const std::uint32_t i : diagram.voronoi.cells) {
            const Cell at = grid.cell(i);
            const double clearance = diagram.distances.clearance_cells(i);
            const auto jambs = findJambs(grid, obstacles, at, clearance);
            const double reach = (clearance + std::sqrt(8.0)) * (clearance + std::sqrt(8.0));
            int facing = INT32_MAX;
            for (std::size_t k = 0; jambs && k < grid.size(); ++k) {
                const Cell c = grid.cell(k);
                const bool counts = grid[k] == CellState::Occupied ||
                                    (grid[k] == CellState::Unknown && obstacles != Obstacles::Occupied);
                if (counts && squared(c, at) <= reach && dot(at, c, jambs->nearest) < 0)
                    facing = std::min(facing, squared(c, at));
            }
            ++(jambs ? found : none);
            if (!jambs) continue;
            ASSERT_EQ(squared(jambs->nearest, at), diagram.distances.squared[i]) << "seed " << seed;
            ASSERT_EQ(squared(jambs->facing, at), facing)
                << "seed " << seed << " at " << at.x << ", " << at.y;
        }
    }
    EXPECT_GT(found, none);
}

TEST(Jambs, linesRunFromCellToCellAndLookTheSameBackwards)
{
    for (int x = -7; x <= 7; ++x)
        for (int y = -7; y <= 7; ++y) {
            const auto line = lineCells({2, 3}, {2 + x, 3 + y});
            ASSERT_EQ(line.size(), static_cast<std::size_t>(std::max(std::abs(x), std::abs(y)) + 1));
            EXPECT_EQ(line.front(), (Cell{2, 3}));
            EXPECT_EQ(line.back(), (Cell{2 + x, 3 + y}));
            expectEightConnected(line);
            const auto mirrored = lineCells({2, 3}, {2 - x, 3 + y});
            for (std::size_t k = 0; k < line.size(); ++k)
                EXPECT_EQ(mirrored[k], (Cell{4 - line[k].x, line[k].y}));
        }
}

TEST(CriticalLine, partsCorridorsOfEveryDirection)
{
    for (int degrees = 0; degrees < 180; degrees += 9)
        for (const double halfWidth : {3.0, 5.5, 9.0}) {
            SCOPED_TRACE(std::to_string(degrees) + " deg, half width " + std::to_string(halfWidth));
            const double radians = degrees * 3.14159265358979 / 180;
            const ClassifiedGrid grid = slantingCorridor(radians, halfWidth);
            const int x = roundToCell(20 * std::cos(radians)), y = roundToCell(20 * std::sin(radians));
            const Cell end{30 + x, 30 + y}, otherEnd{30 - x, 30 - y};
            ASSERT_TRUE(connectedBeside({}, grid, end, otherEnd));
            const test::Diagram diagram = test::diagramOf(grid, Obstacles::Occupied, 1.5 * halfWidth * 0.05);
            std::size_t lines = 0;
            for (const std::uint32_t i : diagram.voronoi.cells) {
                const Cell at = grid.cell(i);
                const double clearance = diagram.distances.clearance_cells(i);
                // A narrower cell lies in a notch between two steps of a wall.
                if (squared(at, {30, 30}) > 10 * 10 || clearance < halfWidth - 1) continue;
                const auto jambs = findJambs(grid, Obstacles::Occupied, at, clearance);
                if (!jambs) continue;
                const auto line = criticalLine(grid, at, *jambs);
                for (const Cell c : line) ASSERT_TRUE(grid.isFree(c));
                ASSERT_EQ(line.front(), at);
                expectEightConnected(line);
                EXPECT_FALSE(connectedBeside(line, grid, end, otherEnd)) << at.x << ", " << at.y;
                ++lines;
            }
            EXPECT_GE(lines, 15u);
        }
}

TEST(CriticalLine, endsWhereItLeavesTheFreeSpace)
{
    const auto grid = test::drawMap({"#####", ".....", "..?..", ".....", ".....", "#####"});
    const auto line = criticalLine(grid, {2, 2}, {{2, 0}, {2, 5}});
    ASSERT_EQ(line.size(), 2u);
    EXPECT_EQ(line[0], (Cell{2, 2}));
    EXPECT_EQ(line[1], (Cell{2, 1}));
}
