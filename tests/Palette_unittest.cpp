#include "gr2to/view/Palette.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
using gr2to::placeColor;
using gr2to::Rgb;

/** How a person sees: a matrix on linear RGB, and the least distances that the palette promises. */
struct Vision
{
    const char* name;
    Eigen::Matrix3d linear;
    double near;  // ids at most five apart
    double any;   // any two colours
};

std::vector<Vision> visions()
{
    const auto matrix = [](std::initializer_list<double> values) {
        return Eigen::Matrix3d(
            Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.begin()));
    };
    // Machado, Oliveira and Fernandes 2009, severity 1.
    return {
        {"normal", Eigen::Matrix3d::Identity(), 19, 10},
        {"protanopia",
         matrix(
             {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998}),
         9.9, 8.9},
        {"deuteranopia",
         matrix({0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881}),
         9.9, 8.9},
        {"tritanopia",
         matrix(
             {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900}),
         8, 7}};
}

/** CIELAB (D65) of a colour as seen. */
Eigen::Vector3d lab(Rgb color, const Vision& vision)
{
    const auto toLinear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const Eigen::Vector3d rgb(toLinear(color.red / 255.0), toLinear(color.green / 255.0),
                              toLinear(color.blue / 255.0));
    Eigen::Matrix3d toXyz;
    toXyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920,
        0.9503041;
    const Eigen::Vector3d seen = (vision.linear * rgb).cwiseMax(0).cwiseMin(1);
    const Eigen::Vector3d xyz = (toXyz * seen).cwiseQuotient(toXyz * Eigen::Vector3d::Ones());
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double fx = f(xyz.x()), fy = f(xyz.y()), fz = f(xyz.z());
    return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

double leastDistance(const Vision& vision, int firstLag, int lastLag)
{
    double least = std::numeric_limits<double>::infinity();
    for (int id = 1; id <= static_cast<int>(gr2to::palette::placeColors); ++id)
        for (int lag = firstLag; lag <= lastLag; ++lag) {
            const auto a = placeColor(static_cast<gr2to::PlaceId>(id));
            const auto b = placeColor(static_cast<gr2to::PlaceId>(id + lag));
            least = std::min(least, (lab(a, vision) - lab(b, vision)).norm());
        }
    return least;
}
}  // namespace

TEST(Palette, idsNearOneAnotherDifferForEveryKindOfColourVision)
{
    for (const auto& vision : visions()) EXPECT_GE(leastDistance(vision, 1, 5), vision.near) << vision.name;
}

TEST(Palette, anyTwoPlaceColoursDifferForEveryKindOfColourVision)
{
    const int all = static_cast<int>(gr2to::palette::placeColors) - 1;
    for (const auto& vision : visions()) EXPECT_GE(leastDistance(vision, 1, all), vision.any) << vision.name;
}

TEST(Palette, placesDifferFromCellsThatBelongToNone)
{
    for (const auto& vision : visions())
        for (std::size_t id = 1; id <= gr2to::palette::placeColors; ++id)
            for (const Rgb other : {gr2to::palette::unknown, gr2to::palette::occupied, gr2to::palette::free})
                EXPECT_GE(
                    (lab(placeColor(static_cast<gr2to::PlaceId>(id)), vision) - lab(other, vision)).norm(),
                    9.9)
                    << vision.name << ", place " << id;
}

TEST(Palette, marksStandOutFromEveryPlace)
{
    for (const auto& vision : visions())
        for (std::size_t id = 1; id <= gr2to::palette::placeColors; ++id)
            for (const Rgb mark : {gr2to::palette::ink, gr2to::palette::door, gr2to::palette::voronoi})
                EXPECT_GE(
                    (lab(placeColor(static_cast<gr2to::PlaceId>(id)), vision) - lab(mark, vision)).norm(), 20)
                    << vision.name << ", place " << id;
}

TEST(Palette, placesAreLightAndNoPlaceIsWhite)
{
    EXPECT_EQ(placeColor(0), gr2to::palette::free);
    for (int id = 1; id <= 65535; id += 7)
        EXPECT_GT(lab(placeColor(static_cast<gr2to::PlaceId>(id)), visions().front()).x(), 72) << id;
}
