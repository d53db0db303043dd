#include "gr2to/grid/Partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "support/buildingMeasures.h"
#include "support/drawMap.h"
#include "support/freeLabels.h"
#include "support/rooms.h"

using namespace gr2to;

namespace
{
/** Digits are cells of the diagram with their place, '0' one without; '+' is a border. */
struct DrawnPlaces
{
    explicit DrawnPlaces(const std::vector<std::string>& rows) : grid(test::drawMap(rows))
    {
        voronoi.width = grid.width();
        voronoi.height = grid.height();
        for (std::size_t i = 0; i < grid.size(); ++i) {
            const Cell c = grid.cell(i);
            const char drawn =
                rows[rows.size() - 1 - static_cast<std::size_t>(c.y)][static_cast<std::size_t>(c.x)];
            if (drawn == '+') borders.push_back(c);
            if (drawn < '0' || drawn > '9') continue;
            voronoi.cells.push_back(static_cast<std::uint32_t>(i));
            places.push_back(static_cast<PlaceId>(drawn - '0'));
        }
    }
    ClassifiedGrid grid;
    VoronoiGraph voronoi;
    std::vector<PlaceId> places;
    std::vector<Cell> borders;
};

/** The partition as a drawing: a digit for each place, '.' where there is none. */
std::vector<std::string> partitionOf(const std::vector<std::string>& rows)
{
    const DrawnPlaces drawn(rows);
    const PlaceImage image = partition(drawn.grid, drawn.voronoi, drawn.places, drawn.borders);
    std::vector<std::string> result;
    for (int y = image.height - 1; y >= 0; --y) {
        result.emplace_back();
        for (int x = 0; x < image.width; ++x)
            result.back() += image.at({x, y}) == 0 ? '.' : static_cast<char>('0' + image.at({x, y}));
    }
    return result;
}

/** Where a row has '*', any of the places is right. */
void expectPartition(const std::vector<std::string>& rows, const std::vector<std::string>& expected)
{
    std::vector<std::string> found = partitionOf(rows);
    for (std::size_t y = 0; y < expected.size(); ++y)
        for (std::size_t x = 0; x < expected[y].size(); ++x)
            if (expected[y][x] == '*' && found[y][x] != '.') found[y][x] = '*';
    EXPECT_EQ(found, expected);
}

/** Random claims of places on the diagram of a random map, and random borders. */
struct RandomPlaces
{
    explicit RandomPlaces(unsigned seed) : grid(test::randomMap(45, 38, seed, seed % 2 ? 0.1 : 0.35, 0.03))
    {
        voronoi = test::diagramOf(grid, Obstacles::Occupied, 0.15).voronoi;
        std::mt19937 random(seed);
        PlaceId place = 1;
        for (std::size_t k = 0; k < voronoi.cells.size(); ++k) {
            if (random() % 12 == 0) place = static_cast<PlaceId>(1 + random() % 9);
            places.push_back(random() % 5 == 0 ? PlaceId{0} : place);
        }
        for (std::size_t i = 0; i < grid.size(); ++i)
            if (grid[i] == CellState::Free && random() % 9 == 0) borders.push_back(grid.cell(i));
        std::shuffle(borders.begin(), borders.end(), random);
        image = partition(grid, voronoi, places, borders);
    }
    ClassifiedGrid grid;
    VoronoiGraph voronoi;
    std::vector<PlaceId> places;
    std::vector<Cell> borders;
    PlaceImage image;
};
}  // namespace

TEST(Partition, regionsBetweenBordersHaveThePlaceOfTheirStretch)
{
    expectPartition({"#########", "#....+..#", "#.11.+..#", "#....+22#", "#########"},
                    {".........", ".1111*22.", ".1111*22.", ".1111*22.", "........."});
}

TEST(Partition, borderThatRunsDiagonallyParts)
{
    expectPartition({"######", "#.+..#", "#..+2#", "#1..+#", "######"},
                    {"......", ".1*22.", ".11*2.", ".111*.", "......"});
}

TEST(Partition, placesThatNoBorderPartsMeetHalfWay)
{
    expectPartition({"###########", "#.........#", "#1.......2#", "#.........#", "###########"},
                    {"...........", ".1111*2222.", ".1111*2222.", ".1111*2222.", "..........."});
}

TEST(Partition, pocketCutOffByABorderGoesToAPlaceBesideIt)
{
    expectPartition({"########", "#1....+.", "########"}, {"........", ".1111111", "........"});
}

TEST(Partition, diagramCellsWithoutAPlaceAreFilledToo)
{
    expectPartition({"#######", "#0011.#", "#######"}, {".......", ".11111.", "......."});
}

TEST(Partition, labelsDoNotSlipThroughADiagonalWall)
{
    expectPartition({"######", "#.1#2#", "#.#..#", "##...#", "######"},
                    {"......", ".11.2.", ".1.22.", "..222.", "......"});
}

TEST(Partition, speckGoesToTheNearestPlaceInAStraightLine)
{
    expectPartition({"##########", "#1######2#", "#1###..#2#", "#1######2#", "##########"},
                    {"..........", ".1......2.", ".1...22.2.", ".1......2.", ".........."});
}

TEST(Partition, farSpecksHaveTheNearestPlaceHoweverManyThereAre)
{
    ClassifiedGrid grid = test::solid(300, 60);
    VoronoiGraph voronoi;
    voronoi.width = 300;
    voronoi.height = 60;
    std::vector<PlaceId> places;
    for (const Cell c : {Cell{2, 2}, Cell{3, 57}}) {
        grid.set(c, CellState::Free);
        voronoi.cells.push_back(static_cast<std::uint32_t>(grid.index(c)));
        places.push_back(static_cast<PlaceId>(places.size() + 1));
    }
    for (int y = 1; y < 60; y += 4)
        for (int x = 200; x < 300; x += 4) grid.set({x, y}, CellState::Free);
    const PlaceImage image = partition(grid, voronoi, places, {});
    EXPECT_EQ(test::breachOfPartition(grid, image), "");
    for (int y = 1; y < 60; y += 4) {
        if (y == 29) continue;  // about as far from either
        EXPECT_EQ(image.at({200, y}), y < 29 ? 1 : 2) << y;
    }
}

TEST(Partition, withoutAnyPlaceNoCellIsLabelled)
{
    expectPartition({"#####", "#00.#", "#####"}, {".....", ".....", "....."});
}

TEST(Partition, labelsAllFreeCellsAndNoOthersOnRandomMaps)
{
    for (unsigned seed = 0; seed < 150; ++seed) {
        const RandomPlaces r(seed);
        EXPECT_EQ(test::breachOfPartition(r.grid, r.image), "") << "seed " << seed;
        for (std::size_t k = 0; k < r.places.size(); ++k)
            if (r.places[k] != 0) {
                ASSERT_EQ(r.image.ids[r.voronoi.cells[k]], r.places[k]) << "seed " << seed << ", cell " << k;
            }
    }
}

TEST(Partition, everyPieceOfAPlaceHasItsStretchOrIsAPatchWithoutAny)
{
    for (unsigned seed = 0; seed < 150; ++seed) {
        const RandomPlaces r(seed);
        const test::Components components = test::freeComponents(r.grid);
        std::set<std::size_t> seeds;
        std::set<int> reached;  // parts of the free space that a stretch of some place lies in
        for (std::size_t k = 0; k < r.places.size(); ++k)
            if (r.places[k] != 0) {
                seeds.insert(r.voronoi.cells[k]);
                reached.insert(components.numbers[r.voronoi.cells[k]]);
            }
        for (const test::LabelPiece& piece : test::piecesOf(r.image)) {
            const auto isSeed = [&](std::size_t i) { return seeds.count(i) > 0; };
            const auto isPatch = [&](std::size_t i) { return reached.count(components.numbers[i]) == 0; };
            EXPECT_TRUE(std::any_of(piece.cells.begin(), piece.cells.end(), isSeed) ||
                        std::all_of(piece.cells.begin(), piece.cells.end(), isPatch))
                << "seed " << seed << ", place " << piece.place << ", " << piece.cells.size() << " cells";
        }
    }
}
