#include "gr2to/grid/VoronoiGraph.h"

#include <gtest/gtest.h>

#include <set>

#include "gr2to/grid/Separation.h"
#include "gr2to/grid/SimpleCells.h"
#include "gr2to/grid/Thinning.h"
#include "gr2to/stages/VoronoiExtraction.h"
#include "support/drawMap.h"
#include "support/topology.h"

using namespace gr2to;
using test::drawMap;

namespace
{
Mask diagramOf(const ClassifiedGrid& grid, double separation_cells)
{
    DistanceMap distances;
    const std::vector<Cell> separating =
        measureSeparation(grid, Obstacles::Occupied, separation_cells, distances);
    return thin(grid, distances, separating);
}

/** Whether removing the centre of a 3x3 neighbourhood keeps components and holes, by counting them. */
bool isSimpleByCounting(std::uint8_t neighbours)
{
    const Cell offsets[8] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    const auto in = [&](Cell c, bool center) {
        if (c == Cell{2, 2}) return center;
        for (unsigned i = 0; i < 8; ++i)
            if (c == Cell{2 + offsets[i].x, 2 + offsets[i].y}) return (neighbours >> i & 1U) != 0;
        return false;
    };
    const auto with = test::topologyOf(5, 5, [&](Cell c) { return in(c, true); });
    const auto without = test::topologyOf(5, 5, [&](Cell c) { return in(c, false); });
    return with == without;
}

std::uint8_t ringOf(const Mask& mask, std::size_t i)
{
    unsigned bits = 0;
    const auto steps = mask.neighbourSteps();
    for (unsigned k = 0; k < 8; ++k)
        bits |= (mask[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + steps[k])] ? 1U : 0U) << k;
    return static_cast<std::uint8_t>(bits);
}
}  // namespace

TEST(Thinning, simpleCellsAreThoseWhoseRemovalChangesNoCount)
{
    for (unsigned ring = 0; ring < 256; ++ring) {
        // A single count can stay the same while one component splits and another vanishes; a lone cell is
        // that case.
        EXPECT_EQ(isSimple(static_cast<std::uint8_t>(ring)),
                  isSimpleByCounting(static_cast<std::uint8_t>(ring)))
            << ring;
    }
}

TEST(Thinning, diagramHasTheComponentsAndHolesOfTheFreeSpaceOnRandomMaps)
{
    for (unsigned seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const double odds[] = {0.02, 0.1, 0.3, 0.5};
        const auto grid = test::randomMap(40, 31, seed, odds[seed % 4], seed % 2 ? 0.1 : 0.0);
        const Mask diagram = diagramOf(grid, seed % 5 + 1.0);
        const auto free = test::topologyOf(40, 31, [&](Cell c) { return grid.at(c) == CellState::Free; });
        const auto thinned = test::topologyOf(40, 31, [&](Cell c) { return diagram[diagram.index(c)] != 0; });
        EXPECT_EQ(free.components, thinned.components);
        EXPECT_EQ(free.holes, thinned.holes);
    }
}

TEST(Thinning, diagramIsOneCellWide)
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        const auto grid = test::randomMap(50, 40, seed, 0.05);
        const Mask diagram = diagramOf(grid, 3.0);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 50; ++x) {
                const std::size_t i = diagram.index({x, y});
                if (!diagram[i]) continue;
                const std::uint8_t ring = ringOf(diagram, i);
                const bool isEnd = __builtin_popcount(ring & 0x55U) == 1;
                EXPECT_TRUE(!isSimple(ring) || isEnd) << "seed " << seed << " at " << x << ", " << y;
            }
    }
}

TEST(Thinning, diagonalWallOneCellThickSeparates)
{
    const auto grid = drawMap({"#####", "#..##", "#.#.#", "##..#", "#####"});
    const Mask diagram = diagramOf(grid, 2.0);
    EXPECT_EQ(test::topologyOf(5, 5, [&](Cell c) { return diagram[diagram.index(c)] != 0; }).components, 2u);
}

TEST(VoronoiExtractor, corridorHasOneStraightCenterLine)
{
    const auto grid = drawMap({"####################", "#..................#", "#..................#",
                               "#..................#", "####################"},
                              0.5);
    const VoronoiExtractor extractor{TVoronoiOptions()};
    DistanceMap distances;
    const std::vector<Cell> separating = extractor.measure(grid, Obstacles::Occupied, distances);
    const VoronoiGraph graph = extractor.trace(grid, distances, separating);
    int onCenterLine = 0;
    for (const std::uint32_t i : graph.cells) onCenterLine += grid.cell(i).y == 2 ? 1 : 0;
    EXPECT_GE(onCenterLine, 14);
}

TEST(VoronoiGraph, edgesCoverTheCellsOnceAndNodesHaveTheirDegree)
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto grid = test::randomMap(60, 45, seed, 0.06);
        const VoronoiGraph graph = traceGraph(diagramOf(grid, 2.0));
        std::multiset<std::size_t> inner;
        std::vector<int> ends(graph.nodes.size(), 0);
        for (const VoronoiEdge& edge : graph.edges) {
            ASSERT_GE(edge.cells.size(), 2u);
            EXPECT_EQ(edge.cells.front(), graph.nodes[edge.from].cell);
            EXPECT_EQ(edge.cells.back(), graph.nodes[edge.to].cell);
            ++ends[edge.from];
            ++ends[edge.to];
            for (std::size_t k = 1; k < edge.cells.size(); ++k) {
                const Cell a = edge.cells[k - 1], b = edge.cells[k];
                EXPECT_EQ(std::abs(a.x - b.x) + std::abs(a.y - b.y), 1);
                if (k + 1 < edge.cells.size()) inner.insert(grid.index(b));
            }
        }
        for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
            EXPECT_EQ(graph.nodes[n].degree, ends[n]);
            inner.insert(grid.index(graph.nodes[n].cell));
        }
        EXPECT_EQ(std::vector<std::size_t>(inner.begin(), inner.end()),
                  std::vector<std::size_t>(graph.cells.begin(), graph.cells.end()));
    }
}
