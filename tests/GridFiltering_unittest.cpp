#include "gr2to/stages/GridFiltering.h"

#include <gmock/gmock.h>

#include "gr2to/pipeline/Gr2To.h"
#include "support/drawMap.h"
#include "support/inputFiles.h"

using namespace gr2to;
using test::drawMap;

namespace
{
/** Filters a drawing whose cells are a square metre each. */
std::string filtered(const std::vector<std::string>& rows, double maxArea, FilteredGrid* result = nullptr)
{
    TFilterOptions options;
    options.max_blob_area = maxArea;
    const FilteredGrid f = GridFilter(options).filter(drawMap(rows, 1));
    if (result) *result = f;
    return test::drawingOf(f.grid);
}

std::string drawing(const std::vector<std::string>& rows)
{
    return test::drawingOf(drawMap(rows, 1));
}
}  // namespace

TEST(GridFilter, smallFreeStandingThingsAreTakenAway)
{
    FilteredGrid result;
    EXPECT_EQ(filtered({"#######", "#.....#", "#.#.#.#", "#..#..#", "#.....#", "#######"}, 4, &result),
              drawing({"#######", "#.....#", "#.....#", "#.....#", "#.....#", "#######"}))
        << "three cells that touch over corners are one blob";
    EXPECT_EQ(result.blobs, 1u);
    EXPECT_EQ(result.cells, 3u);
}

TEST(GridFilter, blobsOfTheLimitOrMoreStay)
{
    const std::vector<std::string> rows{"#######", "#.....#", "#.##..#", "#.....#", "#######"};
    EXPECT_EQ(filtered(rows, 2), drawing(rows));
    EXPECT_NE(filtered(rows, 2.1), drawing(rows));
}

TEST(GridFilter, whatTouchesAWallOrTheBorderStays)
{
    const std::vector<std::string> rows{"#######", "#.....#", "#....#.", ".......", "#......", "..##..."};
    EXPECT_EQ(filtered(rows, 50), drawing(rows));
}

TEST(GridFilter, unknownCellsBelongToTheirBlob)
{
    EXPECT_EQ(filtered({".....", ".#?..", "....."}, 3), drawing({".....", ".....", "....."}));
    EXPECT_EQ(filtered({".....", ".#???", "....."}, 9), drawing({".....", ".#???", "....."}))
        << "the unknown surroundings are no blob";
}

TEST(GridFilter, zeroKeepsAll)
{
    const std::vector<std::string> rows{"...", ".#.", "..."};
    FilteredGrid result;
    EXPECT_EQ(filtered(rows, 0, &result), drawing(rows));
    EXPECT_EQ(result.blobs, 0u);
}

TEST(GridFilter, freesWholeBlobsAndNothingElseOnRandomMaps)
{
    for (unsigned seed = 0; seed < 60; ++seed) {
        const ClassifiedGrid grid = test::randomMap(50, 40, seed, seed % 2 ? 0.1 : 0.3, 0.02);
        TFilterOptions options;
        options.max_blob_area = 0.0025 * (seed % 8 + 0.5);
        const FilteredGrid f = GridFilter(options).filter(grid);
        std::size_t freed = 0;
        for (std::size_t i = 0; i < grid.size(); ++i) {
            freed += f.grid[i] != grid[i] ? 1 : 0;
            ASSERT_TRUE(f.grid[i] == grid[i] || f.grid[i] == CellState::Free) << "seed " << seed;
        }
        EXPECT_EQ(freed, f.cells) << "seed " << seed;
        EXPECT_LE(f.blobs, f.cells);
        EXPECT_EQ(GridFilter(options).filter(f.grid).cells, 0u) << "filtering again finds nothing";
    }
}

namespace
{
void fill(ClassifiedGrid& grid, int left, int right, int bottom, int top, CellState state)
{
    for (int y = bottom; y <= top; ++y)
        for (int x = left; x <= right; ++x) grid.set({x, y}, state);
}

/** Whether a piece, drawn free-standing into a room of 6 m x 4 m, is left by the filter. The room has a wall
 * from either side at half its height, 2.6 m apart. */
bool isKept(int left, int right, int bottom, int top)
{
    ClassifiedGrid grid(120, 80, GridFrame{0.05, 0, 0, 0}, CellState::Occupied);
    fill(grid, 3, 116, 3, 76, CellState::Free);
    fill(grid, 3, 49, 39, 41, CellState::Occupied);
    fill(grid, 102, 116, 39, 41, CellState::Occupied);
    fill(grid, left, right, bottom, top, CellState::Occupied);
    const WallLines walls = WallExtractor(TWallOptions()).extract(grid);
    const FilteredGrid f = GridFilter(TFilterOptions()).filter(grid, walls.segments, walls.directions);
    EXPECT_TRUE(f.grid.isOccupied({40, 40})) << "walls stay";
    return f.grid.isOccupied({(left + right) / 2, (bottom + top) / 2});
}
}  // namespace

TEST(GridFilter, piecesBetweenDoorsStayWhenTheyAreInLineWithAWall)
{
    EXPECT_TRUE(isKept(68, 83, 39, 41)) << "0.8 m long, a doorway from the walls to either side";
    EXPECT_TRUE(isKept(68, 83, 41, 43)) << "not quite in line, as walls of maps are";
    EXPECT_FALSE(isKept(68, 83, 20, 22)) << "the same piece in the middle of the room";
    EXPECT_FALSE(isKept(72, 79, 39, 41)) << "shorter than pieces of wall are";
    EXPECT_TRUE(isKept(64, 87, 37, 46)) << "as thick as walls are that bear";
    EXPECT_FALSE(isKept(64, 87, 17, 26)) << "as thick in the middle of the room";
    EXPECT_FALSE(isKept(64, 87, 32, 48)) << "too thick to be a wall";
}

TEST(GridFilter, piecesInLineWithAStubOrAnotherPieceStay)
{
    const auto keeps = [](std::initializer_list<int> lefts, int stub) {
        ClassifiedGrid grid(120, 80, GridFrame{0.05, 0, 0, 0}, CellState::Occupied);
        fill(grid, 3, 116, 3, 76, CellState::Free);
        for (const int left : lefts) fill(grid, left, left + 15, 39, 41, CellState::Occupied);
        fill(grid, 117 - stub, 116, 39, 41, CellState::Occupied);
        const WallLines walls = WallExtractor(TWallOptions()).extract(grid);
        const FilteredGrid f = GridFilter(TFilterOptions()).filter(grid, walls.segments, walls.directions);
        return f.grid.isOccupied({*lefts.begin() + 8, 40});
    };
    EXPECT_FALSE(keeps({80}, 0)) << "0.8 m long, nothing but a crossing wall ahead";
    EXPECT_TRUE(keeps({80}, 3)) << "a stub of 0.15 m ahead";
    EXPECT_TRUE(keeps({50, 84}, 0)) << "two pieces in line";
    EXPECT_FALSE(keeps({20, 84}, 0)) << "too far apart for a doorway";
}

TEST(GridFilter, longPiecesStayWhereverTheyStand)
{
    EXPECT_TRUE(isKept(60, 85, 20, 22)) << "1.3 m long";
    EXPECT_FALSE(isKept(60, 85, 17, 25)) << "thicker than partitions are";
}

TEST(GridFilter, pipelineNeedsAnObstacleThatIsLeft)
{
    const auto grid = drawMap({"......", "..#...", "......", "......"}, 0.05);
    EXPECT_THAT(Gr2To().extract(grid).map.validate(), testing::IsEmpty());
}
