#include "gr2to/grid/CurveCells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "support/drawCurves.h"
#include "support/drawMap.h"
#include "support/rooms.h"

using namespace gr2to;

namespace
{
constexpr double kFar = std::numeric_limits<double>::infinity();

VoronoiGraph randomDiagram(unsigned seed)
{
    return test::diagramOf(test::randomMap(50, 37, seed, seed % 2 ? 0.05 : 0.2), Obstacles::Occupied, 0.1)
        .voronoi;
}

std::vector<bool> randomSubset(std::size_t size, unsigned seed, double share)
{
    std::mt19937 random(seed);
    std::bernoulli_distribution chosen(share);
    std::vector<bool> subset(size);
    for (std::size_t i = 0; i < size; ++i) subset[i] = chosen(random);
    return subset;
}

/** Lengths of the shortest ways from a cell, by relaxing until nothing changes. */
std::vector<double> slowLengths(const CurveCells& curves, std::size_t from, const std::vector<bool>& blocked)
{
    std::vector<double> length(curves.size(), kFar);
    if (blocked[from]) return length;
    length[from] = 0;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < curves.size(); ++i)
            for (const int n : curves.neighbours(i)) {
                if (n < 0 || blocked[static_cast<std::size_t>(n)] || blocked[i]) continue;
                double& there = length[static_cast<std::size_t>(n)];
                if (length[i] + 1 < there) there = length[i] + 1, changed = true;
            }
    }
    return length;
}
std::vector<int> partsOf(const CurveCells& curves, const std::vector<bool>& blocked)
{
    int count = 0;
    return curves.parts(blocked, &count);
}

/** Of the widest way from a cell to each other one the least squared clearance, -1 where there is no way. */
std::vector<int> slowWidths(const CurveCells& curves, std::size_t from, const std::vector<bool>& blocked,
                            const DistanceMap& distances)
{
    const auto squared = [&](std::size_t i) { return distances.squared[distances.index(curves.cell(i))]; };
    std::vector<int> width(curves.size(), -1);
    if (blocked[from]) return width;
    width[from] = squared(from);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < curves.size(); ++i)
            for (const int n : curves.neighbours(i)) {
                if (n < 0 || blocked[static_cast<std::size_t>(n)]) continue;
                const int through = std::min(width[i], squared(static_cast<std::size_t>(n)));
                int& there = width[static_cast<std::size_t>(n)];
                if (through > there) there = through, changed = true;
            }
    }
    return width;
}
}  // namespace

TEST(CurveCells, floodCirclesGivesEveryCellACircleWhoseWayStaysWidest)
{
    for (unsigned seed = 0; seed < 80; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto diagram = test::diagramOf(test::randomMap(50, 37, seed, 0.05), Obstacles::Occupied, 0.1);
        const CurveCells curves(diagram.voronoi);
        const std::vector<bool> blocked = randomSubset(curves.size(), seed, seed % 3 * 0.04);
        std::mt19937 random(seed);
        std::vector<Circle> circles;
        std::vector<std::vector<int>> widths;
        for (unsigned k = 0; k < 1 + seed % 7; ++k) {
            const std::size_t at = random() % curves.size();
            circles.push_back({curves.cell(at), diagram.distances.clearance_cells(curves.cell(at))});
            widths.push_back(slowWidths(curves, at, blocked, diagram.distances));
        }
        const std::vector<int> owner =
            curves.floodCircles(circles, partsOf(curves, blocked), diagram.distances);
        for (std::size_t i = 0; i < curves.size(); ++i) {
            int widest = -1;
            for (const auto& width : widths) widest = std::max(widest, width[i]);
            ASSERT_EQ(owner[i] == CurveCells::none(), widest < 0) << i;
            if (widest >= 0) {
                ASSERT_EQ(widths[static_cast<std::size_t>(owner[i])][i], widest) << i;
            }
        }
    }
}

TEST(CurveCells, neighboursAreTheCellsBesideInTheirDirections)
{
    for (unsigned seed = 0; seed < 40; ++seed) {
        const VoronoiGraph voronoi = randomDiagram(seed);
        const CurveCells curves(voronoi);
        ASSERT_EQ(curves.size(), voronoi.cells.size());
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const Cell c = curves.cell(i);
            ASSERT_EQ(curves.find(c), static_cast<int>(i));
            const Cell beside[] = {{c.x + 1, c.y}, {c.x, c.y + 1}, {c.x - 1, c.y}, {c.x, c.y - 1}};
            for (std::size_t k = 0; k < 4; ++k)
                ASSERT_EQ(curves.neighbours(i)[k], curves.find(beside[k]))
                    << "seed " << seed << ", cell " << c.x << ", " << c.y << ", direction " << k;
        }
    }
}

TEST(CurveCells, findsNoCellBesideOrBeyondTheCurves)
{
    const test::DrawnCurves drawn = test::drawCurves({"...", "111", "..."});
    const CurveCells curves(drawn.voronoi);
    EXPECT_EQ(curves.find({1, 1}), 1);
    for (const Cell c : {Cell{1, 0}, Cell{0, 2}, Cell{-1, 1}, Cell{3, 1}, Cell{0, -1}, Cell{0, 3}})
        EXPECT_EQ(curves.find(c), CurveCells::none()) << c.x << ", " << c.y;
}

TEST(CurveCells, cellsAtTheEndsOfTwoRowsAreNoNeighbours)
{
    const test::DrawnCurves drawn = test::drawCurves({"1..", "..1"});
    const CurveCells curves(drawn.voronoi);
    for (std::size_t i = 0; i < curves.size(); ++i)
        for (const int n : curves.neighbours(i)) EXPECT_EQ(n, CurveCells::none());
}

TEST(CurveCells, partsAreWhatIsConnectedWithoutTheBlockedCells)
{
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const VoronoiGraph voronoi = randomDiagram(seed);
        const CurveCells curves(voronoi);
        const std::vector<bool> blocked = randomSubset(curves.size(), seed, seed % 3 * 0.05);
        int count = -1;
        const std::vector<int> parts = curves.parts(blocked, &count);
        int highest = -1;
        for (std::size_t i = 0; i < curves.size(); ++i) {
            ASSERT_EQ(parts[i] < 0, blocked[i]);
            ASSERT_LE(parts[i], highest + 1) << "parts are numbered in the order of their first cells";
            highest = std::max(highest, parts[i]);
        }
        ASSERT_EQ(count, highest + 1);
        for (std::size_t i = 0; i < curves.size(); i += 7) {
            if (blocked[i]) continue;
            const std::vector<double> length = slowLengths(curves, i, blocked);
            for (std::size_t j = 0; j < curves.size(); ++j)
                ASSERT_EQ(parts[i] == parts[j], length[j] < kFar) << i << ", " << j;
        }
    }
}

TEST(CurveCells, growCirclesGivesEveryCellTheCircleWithTheCheapestWay)
{
    for (unsigned seed = 0; seed < 80; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const VoronoiGraph voronoi = randomDiagram(seed);
        const CurveCells curves(voronoi);
        const std::vector<bool> blocked = randomSubset(curves.size(), seed, seed % 3 * 0.04);
        std::mt19937 random(seed);
        std::vector<Circle> circles;
        std::vector<std::vector<double>> lengths;
        for (unsigned k = 0; k < 1 + seed % 7; ++k) {
            const std::size_t at = random() % curves.size();
            circles.push_back({curves.cell(at), static_cast<double>(random() % 40) / 4.0});
            lengths.push_back(slowLengths(curves, at, blocked));
        }
        const std::vector<int> owner = curves.growCircles(circles, partsOf(curves, blocked));
        for (std::size_t i = 0; i < curves.size(); ++i) {
            double cheapest = kFar;
            for (std::size_t k = 0; k < circles.size(); ++k)
                cheapest = std::min(cheapest, lengths[k][i] - circles[k].radius_cells);
            ASSERT_EQ(owner[i] == CurveCells::none(), cheapest == kFar) << i;
            if (cheapest == kFar) continue;
            const auto k = static_cast<std::size_t>(owner[i]);
            ASSERT_NEAR(lengths[k][i] - circles[k].radius_cells, cheapest, 1e-9) << i;
        }
    }
}

TEST(CurveCells, biggerCirclesReachFarther)
{
    const test::DrawnCurves drawn = test::drawCurves({"11111111111"});
    const CurveCells curves(drawn.voronoi);
    const auto owner = curves.growCircles({{{0, 0}, 6}, {{10, 0}, 1}}, std::vector<int>(11, 0));
    EXPECT_EQ(owner, (std::vector<int>{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1}));
    std::vector<bool> blocked(11, false);
    blocked[4] = true;
    EXPECT_EQ(curves.growCircles({{{0, 0}, 6}}, partsOf(curves, blocked)),
              (std::vector<int>{0, 0, 0, 0, -1, -1, -1, -1, -1, -1, -1}));
}
