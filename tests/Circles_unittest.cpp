#include "gr2to/grid/Circles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace gr2to;

namespace
{
constexpr int kWidth = 90, kHeight = 70;

/** Sorted by falling radius, with equal radii and equal centres among them. */
std::vector<Circle> randomCircles(unsigned seed, std::size_t count, double largest)
{
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> x(0, kWidth - 1), y(0, kHeight - 1),
        quarters(0, static_cast<int>(4 * largest));
    std::vector<Circle> circles;
    for (std::size_t i = 0; i < count; ++i) {
        const Cell center{x(random), y(random)};
        circles.push_back({center, quarters(random) / 4.0});
    }
    std::stable_sort(circles.begin(), circles.end(),
                     [](const Circle& a, const Circle& b) { return a.radius_cells > b.radius_cells; });
    return circles;
}

bool overlap(const Circle& a, const Circle& b, double factor = 1.0)
{
    return distance_cells(a.center, b.center) < factor * (a.radius_cells + b.radius_cells);
}

/** The definition: compares every circle with all that were kept. */
std::vector<Circle> slowDropOverlapping(const std::vector<Circle>& circles)
{
    std::vector<Circle> kept;
    for (const Circle& circle : circles)
        if (std::none_of(kept.begin(), kept.end(), [&](const Circle& k) { return overlap(circle, k); }))
            kept.push_back(circle);
    return kept;
}
}  // namespace

TEST(Circles, dropOverlappingEqualsComparingAllWithAll)
{
    for (unsigned seed = 0; seed < 300; ++seed) {
        const double largest[] = {1.0, 3.0, 8.0, 40.0};
        const auto circles = randomCircles(seed, 1 + seed % 120, largest[seed % 4]);
        const auto fast = dropOverlapping(circles, kWidth, kHeight);
        const auto slow = slowDropOverlapping(circles);
        ASSERT_EQ(fast.size(), slow.size()) << "seed " << seed;
        for (std::size_t i = 0; i < slow.size(); ++i) {
            ASSERT_EQ(fast[i].center, slow[i].center) << "seed " << seed << ", circle " << i;
            ASSERT_EQ(fast[i].radius_cells, slow[i].radius_cells) << "seed " << seed << ", circle " << i;
        }
    }
}

TEST(Circles, ofOverlappingOnesTheBiggerStaysAndOfEqualsTheFirst)
{
    const auto kept = dropOverlapping({{{20, 20}, 6}, {{10, 10}, 5}, {{15, 10}, 5}, {{25, 25}, 4}}, 40, 40);
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_EQ(kept[0].center, (Cell{20, 20}));
    EXPECT_EQ(kept[1].center, (Cell{10, 10}));
}

TEST(Circles, touchingOnesDoNotOverlap)
{
    EXPECT_EQ(dropOverlapping({{{10, 10}, 5}, {{20, 10}, 5}}, 40, 40).size(), 2u);
    EXPECT_EQ(dropOverlapping({{{10, 10}, 5}, {{19, 10}, 5}}, 40, 40).size(), 1u);
}

TEST(CircleIndex, anyWithinEqualsLookingAtAll)
{
    for (unsigned seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto circles = randomCircles(seed, 60, seed % 2 ? 4.0 : 30.0);
        CircleIndex index(kWidth, kHeight);
        for (const Circle& circle : circles) index.add(circle);
        const double factor = 1.0 + (seed % 5) / 4.0;
        const auto isOdd = [](const Circle& c) { return c.center.x % 2 == 1; };
        for (const Circle& asked : randomCircles(seed + 1000, 40, 12.0)) {
            const bool expected = std::any_of(circles.begin(), circles.end(), [&](const Circle& c) {
                return overlap(asked, c, factor) && isOdd(c);
            });
            ASSERT_EQ(index.anyWithin(asked, factor, isOdd), expected)
                << asked.center.x << ", " << asked.center.y << ", radius " << asked.radius_cells
                << ", factor " << factor;
        }
    }
}

TEST(CircleIndex, isEmptyAtFirst)
{
    const CircleIndex index(10, 10);
    EXPECT_FALSE(index.anyWithin({{5, 5}, 100}, 2.0, [](const Circle&) { return true; }));
    EXPECT_TRUE(index.circles().empty());
}
