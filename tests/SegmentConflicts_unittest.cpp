#include "gr2to/grid/SegmentConflicts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/polygons.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
constexpr double kMargin = 0.1;

double distanceBetween(const Segment& s, const Segment& t)
{
    if (sidesMeet(s.from, s.to, t.from, t.to)) return 0;
    return std::min({distanceFromSide(s.from, t.from, t.to), distanceFromSide(s.to, t.from, t.to),
                     distanceFromSide(t.from, s.from, s.to), distanceFromSide(t.to, s.from, s.to)});
}

/** Segments of random length, none of which share a vertex. */
std::vector<Segment> randomSegments(unsigned seed, std::size_t count)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> at(-100, 300), length(-30, 30);
    std::vector<Segment> segments;
    for (std::size_t k = 0; k < count; ++k) {
        const Eigen::Vector2d from(at(random), at(random));
        const double scale = k % 10 == 0 ? 10 : 1;
        segments.push_back(
            {from, from + scale * Eigen::Vector2d(length(random), length(random)), 2 * k, 2 * k + 1});
    }
    return segments;
}
}  // namespace

TEST(SegmentConflicts, areThoseThatAllPairsHave)
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const std::vector<Segment> segments = randomSegments(seed, 120);
        std::vector<bool> expected(segments.size(), false);
        for (std::size_t i = 0; i < segments.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (distanceBetween(segments[i], segments[j]) <= kMargin) expected[i] = expected[j] = true;
        EXPECT_EQ(findConflicts(segments, kMargin), expected) << "seed " << seed;
        EXPECT_NE(std::count(expected.begin(), expected.end(), true), 0);
        EXPECT_NE(std::count(expected.begin(), expected.end(), false), 0);
    }
}

TEST(SegmentConflicts, sidesOfAPolygonHaveNone)
{
    std::vector<Segment> square;
    const Polygon corners{{0, 0}, {50, 0}, {50, 50}, {0, 50}};
    for (std::size_t k = 0; k < 4; ++k) square.push_back({corners[k], corners[(k + 1) % 4], k, (k + 1) % 4});
    EXPECT_EQ(findConflicts(square, kMargin), std::vector<bool>(4, false));
    EXPECT_TRUE(findConflicts({}, kMargin).empty());
}

TEST(SegmentConflicts, aSideThatFoldsBackOnTheOneBeforeHasOne)
{
    const std::vector<Segment> spike{{{0, 0}, {10, 0}, 0, 1}, {{10, 0}, {5, 0.05}, 1, 2}};
    EXPECT_EQ(findConflicts(spike, kMargin), std::vector<bool>(2, true));
    const std::vector<Segment> corner{{{0, 0}, {10, 0}, 0, 1}, {{10, 0}, {5, 1}, 1, 2}};
    EXPECT_EQ(findConflicts(corner, kMargin), std::vector<bool>(2, false));
}

TEST(SegmentConflicts, twoSidesBetweenTheSameVerticesHaveOne)
{
    const std::vector<Segment> both{{{0, 0}, {10, 0}, 0, 1}, {{10, 0}, {0, 0}, 1, 0}};
    EXPECT_EQ(findConflicts(both, kMargin), std::vector<bool>(2, true));
}
