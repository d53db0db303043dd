#include "gr2to/stages/DoorDetection.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/drawMap.h"
#include "support/messageOf.h"
#include "support/rooms.h"

using namespace gr2to;

namespace
{
using CellSet = std::set<std::pair<int, int>>;  // row, column: in raster order

std::vector<DoorCandidate> candidatesOf(const ClassifiedGrid& grid, const TDoorOptions& options = {})
{
    return DoorDetector(options).detect(grid, measureDistances(grid, Obstacles::Occupied));
}

/** Eq. (8) as printed, cell by cell; a sample beyond the border is not farther from obstacles. */
bool isLikely(const DistanceMap& distances, Cell c, double minClearance, double maxClearance)
{
    const double here = distances.clearance_cells(c);
    if (!(here > minClearance && here < maxClearance)) return false;
    bool farther[8];
    for (int i = 0; i < 8; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i / 8;
        const Cell sample{c.x + static_cast<int>(std::lround(minClearance * std::cos(angle))),
                          c.y + static_cast<int>(std::lround(minClearance * std::sin(angle)))};
        const bool inside =
            sample.x >= 0 && sample.y >= 0 && sample.x < distances.width && sample.y < distances.height;
        farther[i] = inside && distances.clearance_cells(sample) > here;
    }
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            if (farther[i] && farther[j] && std::abs(i - j) > 2 && std::abs(i - j) < 6) return true;
    return false;
}

CellSet slowLikelyCells(const ClassifiedGrid& grid, const TDoorOptions& options)
{
    const DistanceMap distances = measureDistances(grid, Obstacles::Occupied);
    CellSet cells;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const Cell c = grid.cell(i);
        if (isLikely(distances, c, options.min_width / (2 * grid.resolution_m()),
                     options.max_width / (2 * grid.resolution_m())))
            cells.insert({c.y, c.x});
    }
    return cells;
}

/** Grows one group after another by looking at all pairs; groups in the order of their first cells. */
std::vector<CellSet> slowGroups(CellSet cells, double radius)
{
    std::vector<CellSet> groups;
    while (!cells.empty()) {
        std::vector<std::pair<int, int>> open{*cells.begin()};
        groups.emplace_back();
        cells.erase(cells.begin());
        while (!open.empty()) {
            const auto [y, x] = open.back();
            open.pop_back();
            groups.back().insert({y, x});
            for (auto at = cells.begin(); at != cells.end();) {
                const bool close = std::hypot(at->first - y, at->second - x) < radius;
                if (close) open.push_back(*at);
                at = close ? cells.erase(at) : std::next(at);
            }
        }
    }
    return groups;
}

CellSet cellsOf(const DoorCandidate& candidate)
{
    CellSet cells;
    for (const Cell c : candidate.cells) cells.insert({c.y, c.x});
    return cells;
}

/** Candidates with a cell within three cells of the middle of the gap of twoSquareRooms(). */
std::size_t candidatesInGap(int gapCells, const TDoorOptions& options = {})
{
    const auto isNear = [](Cell c) { return std::hypot(c.x - 60.5, c.y - 30) <= 3; };
    const auto candidates = candidatesOf(test::twoSquareRooms(gapCells), options);
    return static_cast<std::size_t>(
        std::count_if(candidates.begin(), candidates.end(), [&](const DoorCandidate& candidate) {
            return std::any_of(candidate.cells.begin(), candidate.cells.end(), isNear);
        }));
}

/** Widths that suit random maps with cells of 0.05 m. */
TDoorOptions someOptions(unsigned seed)
{
    TDoorOptions options;
    options.min_width = 0.1 + 0.05 * (seed % 7);
    options.max_width = options.min_width + 0.1 + 0.15 * (seed % 5);
    return options;
}
}  // namespace

TEST(DoorDetector, twoRoomsJoinedByOneGapHaveOneDoorAtTheGap)
{
    const auto candidates = candidatesOf(test::twoSquareRooms(17));
    ASSERT_EQ(candidates.size(), 1u);
    EXPECT_NEAR(candidates[0].center.x, 60.5, 1.5);
    EXPECT_NEAR(candidates[0].center.y, 30, 1.5);
    EXPECT_EQ(candidates[0].maxClearance_cells, 15);
}

TEST(DoorDetector, gapNarrowerThanTheNarrowestDoorIsNone)
{
    EXPECT_EQ(candidatesInGap(7), 0u);
    TDoorOptions narrower;
    narrower.min_width = 0.3;
    EXPECT_EQ(candidatesInGap(7, narrower), 1u);
}

TEST(DoorDetector, gapWiderThanTheWidestDoorIsNone)
{
    EXPECT_EQ(candidatesInGap(33), 0u);
    TDoorOptions wider;
    wider.max_width = 2;
    EXPECT_EQ(candidatesInGap(33, wider), 1u);
}

TEST(DoorDetector, roomWithoutAGapHasNoDoor)
{
    EXPECT_THAT(candidatesOf(test::twoSquareRooms(0)), testing::IsEmpty());
}

TEST(DoorDetector, lengthsAreInMetresSoThatTheResolutionDoesNotMatter)
{
    ClassifiedGrid fine = test::solid(244, 122, 0.025);
    test::carve(fine, {2, 2}, {119, 119});
    test::carve(fine, {124, 2}, {241, 119});
    test::carve(fine, {120, 44}, {123, 77});
    const auto candidates = candidatesOf(fine);
    ASSERT_EQ(candidates.size(), 1u);
    EXPECT_NEAR(candidates[0].center.x, 121.5, 2);
    EXPECT_NEAR(candidates[0].center.y, 60.5, 2);
}

TEST(DoorDetector, likelyCellsAreThoseOfEquation8OnRandomMaps)
{
    std::size_t found = 0;
    for (unsigned seed = 0; seed < 120; ++seed) {
        const double odds[] = {0.003, 0.01, 0.03, 0.1};
        const auto grid = test::randomMap(60, 47, seed, odds[seed % 4]);
        const TDoorOptions options = someOptions(seed);
        CellSet cells;
        for (const DoorCandidate& candidate : candidatesOf(grid, options)) cells.merge(cellsOf(candidate));
        EXPECT_EQ(cells, slowLikelyCells(grid, options)) << "seed " << seed;
        found += cells.size();
    }
    EXPECT_GT(found, 1000u);
}

TEST(DoorDetector, samplesBeyondTheBorderAreNotFarther)
{
    ClassifiedGrid grid(41, 41, GridFrame{}, CellState::Free);
    for (int y = 0; y < 41; ++y) grid.set({20, y}, CellState::Occupied);
    for (int y = 12; y < 29; ++y) grid.set({20, y}, CellState::Free);
    for (const int cutOff : {0, 14, 18}) {
        ClassifiedGrid cut(41 - cutOff, 41, GridFrame{}, CellState::Free);
        for (std::size_t i = 0; i < cut.size(); ++i)
            cut[i] = grid.at({cut.cell(i).x + cutOff, cut.cell(i).y});
        CellSet cells;
        for (const DoorCandidate& candidate : candidatesOf(cut)) cells.merge(cellsOf(candidate));
        EXPECT_EQ(cells, slowLikelyCells(cut, {})) << cutOff;
    }
}

TEST(DoorDetector, groupsAreThoseOfComparingAllPairs)
{
    for (unsigned seed = 0; seed < 120; ++seed) {
        const double odds[] = {0.003, 0.01, 0.03, 0.1};
        const auto grid = test::randomMap(60, 47, seed, odds[seed % 4]);
        const TDoorOptions options = someOptions(seed);
        std::vector<CellSet> groups;
        for (const DoorCandidate& candidate : candidatesOf(grid, options))
            groups.push_back(cellsOf(candidate));
        EXPECT_EQ(groups, slowGroups(slowLikelyCells(grid, options), options.min_width / (2 * 0.05)))
            << "seed " << seed;
    }
}

TEST(DoorDetector, centerIsTheLikelyCellNearestToTheMean)
{
    for (unsigned seed = 0; seed < 30; ++seed)
        for (const DoorCandidate& candidate : candidatesOf(test::randomMap(60, 47, seed, 0.01))) {
            double x = 0, y = 0;
            for (const Cell c : candidate.cells) x += c.x, y += c.y;
            x /= static_cast<double>(candidate.cells.size());
            y /= static_cast<double>(candidate.cells.size());
            double nearest = 1e9;
            for (const Cell c : candidate.cells) nearest = std::min(nearest, std::hypot(c.x - x, c.y - y));
            EXPECT_NEAR(std::hypot(candidate.center.x - x, candidate.center.y - y), nearest, 1e-9);
            EXPECT_THAT(candidate.cells, testing::Contains(candidate.center));
        }
}

TEST(DoorDetector, contradictoryWidthsAreRefused)
{
    TDoorOptions options;
    options.min_width = 1.2;
    options.max_width = 1.2;
    EXPECT_THAT(test::messageOf<std::invalid_argument>([&] { DoorDetector detector(options); }),
                testing::AllOf(testing::HasSubstr("door.max_width"), testing::HasSubstr("door.min_width")));
    options.max_width = std::nan("");
    EXPECT_THROW(DoorDetector{options}, std::invalid_argument);
}
