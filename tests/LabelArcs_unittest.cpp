#include "gr2to/grid/LabelArcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "gr2to/topology/HoleSlits.h"
#include "support/drawLabels.h"
#include "support/polygons.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
LabelArcs arcsOf(const std::vector<std::string>& rows)
{
    return traceArcs(drawLabels(rows, 1));
}

PlaceImage randomLabels(unsigned seed, int width, int height, int labels)
{
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> label(0, labels);
    PlaceImage image(width, height);
    for (PlaceId& id : image.ids) id = static_cast<PlaceId>(label(random));
    return image;
}

/** The four labels around a corner, counter-clockwise from the upper right. */
std::vector<PlaceId> labelsAround(const PlaceImage& image, int x, int y)
{
    std::vector<PlaceId> labels;
    for (const Cell c : {Cell{x, y}, Cell{x - 1, y}, Cell{x - 1, y - 1}, Cell{x, y - 1}})
        labels.push_back(c.x >= 0 && c.y >= 0 && c.x < image.width && c.y < image.height ? image.at(c)
                                                                                         : PlaceId{0});
    return labels;
}

/** Counted corner by corner: sides between different labels, nodes, corners that arcs pass twice. */
struct Counts
{
    explicit Counts(const PlaceImage& image)
    {
        for (int y = 0; y <= image.height; ++y)
            for (int x = 0; x <= image.width; ++x) {
                const auto l = labelsAround(image, x, y);
                sides += (l[0] != l[3] ? 1 : 0) + (l[0] != l[1] ? 1 : 0);
                const bool passed = l[0] != l[1] && l[1] != l[2] && l[2] != l[3] && l[3] != l[0] &&
                                    (l[0] == l[2] || l[1] == l[3]);
                twice += passed ? 1 : 0;
                nodes += !passed && std::set<PlaceId>(l.begin(), l.end()).size() > 2 ? 1 : 0;
            }
    }
    int sides = 0, nodes = 0, twice = 0;
};
}  // namespace

TEST(LabelArcs, aSquareHasOneClosedArcWithItsCorners)
{
    const LabelArcs arcs = arcsOf({"....", ".11.", ".11.", "...."});
    ASSERT_EQ(arcs.arcs.size(), 1u);
    const LabelArc& arc = arcs.arcs[0];
    EXPECT_TRUE(arc.isClosed());
    EXPECT_EQ(arc.points.size(), 5u);
    EXPECT_EQ(arc.points.front(), arc.points.back());
    EXPECT_TRUE(arcs.nodes.empty());
    ASSERT_EQ(arcs.rings.size(), 1u);
    EXPECT_EQ(arcs.rings[0].label, 1);
    EXPECT_EQ(arcs.rings[0].area_cells, 4);
    const Polygon corners = cornersOf(arcs, arcs.rings[0]);
    for (const Eigen::Vector2d& expected : {Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(2.5, 2.5)})
        EXPECT_NE(std::find(corners.begin(), corners.end(), expected), corners.end());
}

TEST(LabelArcs, twoLabelsShareTheArcBetweenThem)
{
    const LabelArcs arcs = arcsOf({"1122", "1122"});
    EXPECT_EQ(arcs.nodes.size(), 2u);
    EXPECT_EQ(arcs.arcs.size(), 3u);
    ASSERT_EQ(arcs.rings.size(), 2u);
    int shared = 0;
    for (const LabelArc& arc : arcs.arcs)
        if (arc.left != 0 && arc.right != 0) {
            ++shared;
            EXPECT_EQ(arc.points.size(), 2u);
        }
    EXPECT_EQ(shared, 1);
    for (const LabelRing& ring : arcs.rings) {
        EXPECT_EQ(ring.area_cells, 4);
        EXPECT_EQ(ring.sides.size(), 2u);
    }
}

TEST(LabelArcs, aHoleIsARingOfNegativeArea)
{
    const LabelArcs arcs = arcsOf({"1111", "1221", "1111"});
    ASSERT_EQ(arcs.rings.size(), 3u);
    std::multiset<std::pair<int, double>> found;
    for (const LabelRing& ring : arcs.rings) found.insert({ring.label, ring.area_cells});
    EXPECT_EQ(found, (std::multiset<std::pair<int, double>>{{1, 12}, {1, -2}, {2, 2}}));
}

TEST(LabelArcs, cellsThatMeetOverACornerAreApartWhenTheOthersAreNoPlace)
{
    const LabelArcs arcs = arcsOf({".1", "1."});
    EXPECT_TRUE(arcs.nodes.empty());
    EXPECT_EQ(arcs.rings.size(), 2u);
    for (const LabelRing& ring : arcs.rings) EXPECT_NEAR(ring.area_cells, 1 - 1 / 32.0, 1e-12);
}

TEST(LabelArcs, cellsThatMeetOverACornerAreJoinedWhenTheyAloneAreEqual)
{
    const LabelArcs arcs = arcsOf({"21", "1."});
    std::map<PlaceId, int> rings;
    for (const LabelRing& ring : arcs.rings) ++rings[ring.label];
    EXPECT_EQ(rings[1], 1);
    EXPECT_EQ(rings[2], 1);
}

TEST(LabelArcs, everySideIsInOneArcAndEveryNodeIsFound)
{
    for (unsigned seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const PlaceImage image =
            randomLabels(seed, 3 + static_cast<int>(seed % 20), 12, 1 + static_cast<int>(seed % 4));
        const Counts counts(image);
        const LabelArcs arcs = traceArcs(image);
        EXPECT_EQ(arcs.nodes.size(), static_cast<std::size_t>(counts.nodes));
        double length = 0;
        for (const LabelArc& arc : arcs.arcs) {
            EXPECT_NE(arc.left, arc.right);
            for (std::size_t k = 1; k < arc.points.size(); ++k)
                length += (arc.points[k] - arc.points[k - 1]).norm();
        }
        EXPECT_NEAR(length, counts.sides - counts.twice * 2 * (0.5 - std::sqrt(2.0) / 4), 1e-9);
    }
}

TEST(LabelArcs, ringsAreSimpleAndEncloseTheirLabelsCells)
{
    for (unsigned seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const PlaceImage image =
            randomLabels(seed, 14, 4 + static_cast<int>(seed % 12), 1 + static_cast<int>(seed % 3));
        const LabelArcs arcs = traceArcs(image);
        std::map<PlaceId, double> area;
        for (const LabelRing& ring : arcs.rings) {
            const Polygon corners = cornersOf(arcs, ring);
            EXPECT_EQ(whyNotSimple(corners), "");
            EXPECT_NEAR(areaOf(corners), ring.area_cells, 1e-9);
            area[ring.label] += ring.area_cells;
        }
        for (const auto& [label, cells] : area)
            EXPECT_NEAR(cells, static_cast<double>(std::count(image.ids.begin(), image.ids.end(), label)),
                        Counts(image).twice / 16.0);
    }
}

TEST(LabelArcs, anImageWithoutLabelsHasNoArcs)
{
    EXPECT_TRUE(traceArcs(PlaceImage(7, 3)).arcs.empty());
    EXPECT_EQ(arcsOf({"1"}).rings.size(), 1u);
}
