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

TEST(GridFilter, pipelineNeedsAnObstacleThatIsLeft)
{
    const auto grid = drawMap({"......", "..#...", "......", "......"}, 0.05);
    EXPECT_THAT(Gr2To().extract(grid).map.validate(), testing::IsEmpty());
}
