#include "gr2to/topology/PlaceOutlines.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "support/drawLabels.h"
#include "support/polygons.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
constexpr double kTolerance = 1.5;
constexpr double kBlock = kLabelBlock * kLabelBlock;  // cells of a drawn character

std::vector<Polygon> outlinesOf(const PlaceImage& places, std::size_t count, double tolerance = kTolerance)
{
    std::vector<Polygon> outlines = outlinePlaces(places, count, tolerance);
    EXPECT_EQ(outlines.size(), count + 1);
    for (const Polygon& outline : outlines) EXPECT_EQ(outline.empty() ? "" : whyNotSimple(outline), "");
    return outlines;
}

bool hasVertex(const Polygon& polygon, const Eigen::Vector2d& p)
{
    return std::find(polygon.begin(), polygon.end(), p) != polygon.end();
}

bool encloses(const Polygon& polygon, const Eigen::Vector2d& p)
{
    double turns = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Eigen::Vector2d a = polygon[k] - p, b = polygon[(k + 1) % polygon.size()] - p;
        turns += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return std::abs(turns) > 1;
}

/** Two places with a wall of one cell between them that runs in waves. */
PlaceImage wavyWall()
{
    PlaceImage image(200, 60);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 200; ++x) {
            const int wall = 30 + static_cast<int>(std::lround(3 * std::sin(x / 4.0)));
            if (y != wall) image.ids[image.index({x, y})] = y < wall ? 1 : 2;
        }
    for (int x = 0; x < 200; ++x)  // 8-connected, so that no place leaks through
        for (int y = 1; y < 59; ++y)
            if (image.at({x, y}) == 1 && image.at({x, y + 1}) == 2) image.ids[image.index({x, y})] = 0;
    return image;
}
}  // namespace

TEST(PlaceOutlines, ofRectanglesAreTheirCorners)
{
    const auto outlines = outlinesOf(drawLabels({"....", ".12.", "...."}), 2);
    EXPECT_TRUE(outlines[0].empty());
    for (int id = 1; id <= 2; ++id) {
        const Polygon& outline = outlines[static_cast<std::size_t>(id)];
        EXPECT_EQ(outline.size(), 4u);
        EXPECT_EQ(areaOf(outline), kBlock);
        EXPECT_TRUE(hasVertex(outline, {39.5, 19.5}));
        EXPECT_TRUE(hasVertex(outline, {39.5, 39.5}));
    }
}

TEST(PlaceOutlines, haveACommonVertexWhereThreePlacesMeet)
{
    const auto outlines = outlinesOf(drawLabels({"......", ".1122.", ".1133.", "......"}), 3);
    for (std::size_t id = 1; id <= 3; ++id) EXPECT_TRUE(hasVertex(outlines[id], {59.5, 39.5})) << id;
    EXPECT_EQ(outlines[1].size(), 5u) << "four corners and the end of the border between 2 and 3";
}

TEST(PlaceOutlines, leaveSmallHolesInside)
{
    PlaceImage image = drawLabels({"......", ".1111.", ".1111.", ".1111.", "......"});
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 6; ++x) image.ids[image.index({45 + x, 45 + y})] = 0;
    const auto outlines = outlinesOf(image, 1);
    EXPECT_EQ(outlines[1].size(), 4u);
    EXPECT_EQ(areaOf(outlines[1]), 12 * kBlock);
}

TEST(PlaceOutlines, goAroundLargeHolesOnASlit)
{
    const auto outlines = outlinesOf(drawLabels({"......", ".1111.", ".1.11.", ".1111.", "......"}), 1);
    EXPECT_NEAR(areaOf(outlines[1]), 11 * kBlock, 0.01 * kBlock * 11);
    EXPECT_FALSE(encloses(outlines[1], {49.5, 49.5})) << "the hole";
    EXPECT_TRUE(encloses(outlines[1], {69.5, 49.5}));
    EXPECT_TRUE(encloses(outlines[1], {29.5, 55.5})) << "above the slit";
    EXPECT_TRUE(encloses(outlines[1], {29.5, 42.5})) << "and below";
}

TEST(PlaceOutlines, doNotHoldOtherPlacesHoweverSmall)
{
    PlaceImage image = drawLabels(std::vector<std::string>(20, std::string(20, '1')));
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) image.ids[image.index({200 + x, 200 + y})] = 2;
    const auto outlines = outlinesOf(image, 2);
    EXPECT_EQ(areaOf(outlines[2]), kBlock);
    EXPECT_FALSE(encloses(outlines[1], {209.5, 209.5}));
    int common = 0;
    for (const auto& p : outlines[2]) common += hasVertex(outlines[1], p) ? 1 : 0;
    EXPECT_EQ(common, static_cast<int>(outlines[2].size()));
}

TEST(PlaceOutlines, goAroundAPlaceBehindItsOwnWalls)
{
    const auto outlines = outlinesOf(drawLabels({"1111111", "1.....1", "1.222.1", "1.....1", "1111111"}), 2);
    EXPECT_FALSE(encloses(outlines[1], {69.5, 49.5}));
    EXPECT_NEAR(areaOf(outlines[1]), 20 * kBlock, 0.2 * kBlock);
    EXPECT_EQ(areaOf(outlines[2]), 3 * kBlock);
}

TEST(PlaceOutlines, openHolesBehindHoles)
{
    const auto outlines = outlinesOf(drawLabels({"11111111", "1.1.1.11", "11111111"}), 1);
    EXPECT_NEAR(areaOf(outlines[1]), 21 * kBlock, 0.25 * kBlock) << "three slits";
    for (const double x : {29.5, 69.5, 109.5}) EXPECT_FALSE(encloses(outlines[1], {x, 29.5})) << x;
}

TEST(PlaceOutlines, areThoseOfTheLargestPatches)
{
    const auto outlines = outlinesOf(drawLabels({"1.111", "....."}), 1);
    EXPECT_EQ(areaOf(outlines[1]), 3 * kBlock);
}

TEST(PlaceOutlines, areEmptyForPlacesWithoutCells)
{
    EXPECT_TRUE(outlinesOf(drawLabels({"11"}), 3)[2].empty());
}

TEST(PlaceOutlines, doNotCrossThinWalls)
{
    for (const double tolerance : {0.5, 1.5, 4.0, 20.0}) {
        const auto outlines = outlinesOf(wavyWall(), 2, tolerance);
        for (std::size_t i = 0; i < outlines[1].size(); ++i)
            for (std::size_t j = 0; j < outlines[2].size(); ++j)
                ASSERT_FALSE(sidesMeet(outlines[1][i], outlines[1][(i + 1) % outlines[1].size()],
                                       outlines[2][j], outlines[2][(j + 1) % outlines[2].size()]))
                    << tolerance;
    }
}

TEST(PlaceOutlines, keepTheirAreasWhateverTheTolerance)
{
    const PlaceImage image = wavyWall();
    std::size_t vertices = 100000;
    for (const double tolerance : {0.25, 0.75, 1.5}) {
        const auto outlines = outlinesOf(image, 2, tolerance);
        for (PlaceId id = 1; id <= 2; ++id) {
            const auto cells = static_cast<double>(std::count(image.ids.begin(), image.ids.end(), id));
            EXPECT_NEAR(areaOf(outlines[id]), cells, 0.011 * cells) << tolerance;
        }
        EXPECT_LE(outlines[1].size(), vertices) << tolerance;
        vertices = outlines[1].size();
    }
}
