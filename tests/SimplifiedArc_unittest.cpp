#include "gr2to/grid/SimplifiedArc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/polygons.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
/** The sides of the cells below a line y = slope * x, from x = 0. */
Polygon steps(double slope, int length)
{
    Polygon chain{{0, 0}};
    for (int x = 1; x <= length; ++x) {
        const double y = std::floor(slope * x);
        if (y != chain.back().y()) {
            chain.emplace_back(x, chain.back().y());
            chain.emplace_back(x, y);
        }
    }
    chain.emplace_back(length + 1, chain.back().y());
    return chain;
}

/** Area between two chains with the same ends. */
double areaBetween(Polygon a, const Polygon& b)
{
    a.insert(a.end(), b.rbegin(), b.rend());
    return areaOf(a);
}

double distanceFrom(const Polygon& chain, const Eigen::Vector2d& p)
{
    double least = 1e9;
    for (std::size_t k = 1; k < chain.size(); ++k)
        least = std::min(least, distanceFromSide(p, chain[k - 1], chain[k]));
    return least;
}
}  // namespace

TEST(SimplifiedArc, aStraightChainHasTwoVertices)
{
    const Polygon chain{{0, 0}, {3, 0}, {9, 0}};
    EXPECT_EQ(SimplifiedArc(chain, false, 1.5).vertices(), (Polygon{{0, 0}, {9, 0}}));
}

TEST(SimplifiedArc, cornersOfARectangleStayWhereTheyAre)
{
    const Polygon chain{{0, 0}, {40, 0}, {40, 20}, {0, 20}, {0, 0}};
    EXPECT_EQ(SimplifiedArc(chain, true, 1.5).vertices(), chain);
}

TEST(SimplifiedArc, stepsOfASlopeBecomeOneSide)
{
    for (const double slope : {0.1, 0.37, 0.8, 1.0}) {
        const Polygon chain = steps(slope, 120);
        const SimplifiedArc arc(chain, false, 1.5);
        EXPECT_LE(arc.sides(), 2u) << slope;
        EXPECT_EQ(arc.vertices().front(), chain.front());
        EXPECT_EQ(arc.vertices().back(), chain.back());
    }
}

TEST(SimplifiedArc, aSideThatBendsOffStepsRunsThroughTheirMiddle)
{
    for (const double slope : {0.1, 0.37, 0.8}) {  // a slope, then straight back down to close the polygon
        Polygon chain = steps(slope, 160);
        chain.emplace_back(chain.back().x(), -50);
        chain.emplace_back(0, -50);
        chain.push_back(chain.front());
        const SimplifiedArc arc(chain, true, 1.5);
        const double area = areaOf(chain);
        EXPECT_NEAR(areaOf(arc.vertices()), area, 0.001 * std::abs(area)) << slope;
    }
}

/** Sides once ran askew along a whole wall, from its far end to the end of a door's border in the wall. */
TEST(SimplifiedArc, aJogAtAnEndStaysAJog)
{
    const Polygon wallAndJog{{0, 0}, {40, 0}, {40, 30}, {39, 30}};
    EXPECT_EQ(SimplifiedArc(wallAndJog, false, 1.5).vertices(), wallAndJog);
    const Polygon jogsAtBothEnds{{0, 1}, {0, 0}, {40, 0}, {40, 1}};
    EXPECT_EQ(SimplifiedArc(jogsAtBothEnds, false, 1.5).vertices(), jogsAtBothEnds);
}

TEST(SimplifiedArc, leftOutPointsAreWithinTheToleranceAndAreasAgree)
{
    std::mt19937 random(7);
    std::uniform_int_distribution<int> step(-1, 1);
    for (int round = 0; round < 50; ++round) {
        Polygon chain{{0, 0}};
        for (int x = 1; x < 200; ++x) {
            chain.emplace_back(x, chain.back().y());
            chain.emplace_back(x, chain.back().y() + step(random));
        }
        const double tolerance = 1.5;
        const SimplifiedArc arc(chain, false, tolerance);
        EXPECT_LT(arc.sides(), chain.size() / 4);
        for (const auto& p : chain)
            EXPECT_LE(distanceFrom(arc.vertices(), p), 2 * tolerance) << "moved by as much";
        EXPECT_LE(std::abs(areaBetween(chain, arc.vertices())), 0.15 * 200) << "round " << round;
    }
}

TEST(SimplifiedArc, refiningASideEndsAtTheChain)
{
    const Polygon chain = steps(0.37, 40);
    SimplifiedArc arc(chain, false, 1.5);
    for (int round = 0; round < 200; ++round) {
        for (std::size_t side = 0; side < arc.sides(); ++side) arc.refine(side);
        arc.update();
    }
    EXPECT_EQ(arc.vertices(), chain);
}

TEST(SimplifiedArc, tighteningEndsAtTheChain)
{
    const Polygon chain = steps(0.37, 40);
    SimplifiedArc arc(chain, false, 1.5);
    for (int round = 0; round < 20; ++round) arc.tighten();
    arc.update();
    EXPECT_EQ(arc.vertices(), chain);
}
