#include "gr2to/topology/WallFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace gr2to;

namespace
{
constexpr double kRes = 0.05;

std::vector<Eigen::Vector2d> exactLine(double angle_rad, int points)
{
    const Eigen::Vector2d along(std::cos(angle_rad), std::sin(angle_rad));
    std::vector<Eigen::Vector2d> line;
    for (int k = 0; k < points; ++k) line.push_back(Eigen::Vector2d(3, -2) + kRes * k * along);
    return line;
}

/** The same with gaps in its second half, as walls have. */
std::vector<Eigen::Vector2d> brokenLine(double angle_rad, int points)
{
    const auto line = exactLine(angle_rad, points);
    std::vector<Eigen::Vector2d> kept;
    for (std::size_t k = 0; k < line.size(); ++k)
        if (2 * k < line.size() || k + 1 == line.size() || k % 5 == 0) kept.push_back(line[k]);
    return kept;
}

/** What many noisy fits of one line come to. */
struct Sampled
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    double acrossVariance = 0, alongVariance = 0, normalVariance = 0, lengthVariance = 0;
};

/** Moves every point evenly within its cell, as digitisation does. */
Sampled sampleFits(const std::vector<Eigen::Vector2d>& line, double angle_rad, int trials)
{
    std::mt19937 random(7);
    const auto uniform = [&] { return (static_cast<double>(random()) / 4294967296.0 - 0.5) * kRes; };
    const LineFit truth = fitLine(line, kRes);
    const Eigen::Vector2d t(std::cos(angle_rad), std::sin(angle_rad)), n(-t.y(), t.x());
    Sampled s;
    for (int trial = 0; trial < trials; ++trial) {
        auto noisy = line;
        for (auto& p : noisy) p += Eigen::Vector2d(uniform(), uniform());
        const LineFit fit = fitLine(noisy, kRes);
        const Eigen::Vector2d moved = fit.center - truth.center;
        const double turn = n.dot(fit.direction) / t.dot(fit.direction);
        const double ends = ((noisy.back() + noisy.front() - line.back() - line.front()) / 2).dot(t);
        s.mean += moved / trials;
        s.acrossVariance += moved.dot(n) * moved.dot(n) / trials;
        s.alongVariance += ends * ends / trials;
        s.normalVariance += turn * turn / trials;
        const double length = (noisy.back() - noisy.front()).dot(t) + kRes - truth.length_m;
        s.lengthVariance += length * length / trials;
    }
    return s;
}
}  // namespace

TEST(WallFit, exactLinesAreFoundAtOddAngles)
{
    for (int degrees = -88; degrees <= 90; degrees += 13) {
        const double angle = degrees * 3.14159265358979 / 180;
        const LineFit fit = fitLine(exactLine(angle, 41), kRes);
        const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
        EXPECT_NEAR(std::abs(fit.direction.dot(along)), 1, 1e-12) << degrees;
        EXPECT_NEAR(fit.direction.norm(), 1, 1e-12);
        EXPECT_LT((fit.center - (Eigen::Vector2d(3, -2) + kRes * 20 * along)).norm(), 1e-12);
        EXPECT_NEAR(fit.length_m, kRes * 41, 1e-12) << "from the first cell's edge to the last one's";
    }
}

TEST(WallFit, centerIsHalfWayBetweenTheEndsWhereverMostPointsLie)
{
    const LineFit even = fitLine(exactLine(0.4, 31), kRes), broken = fitLine(brokenLine(0.4, 31), kRes);
    EXPECT_LT((broken.center - even.center).norm(), 1e-12);
    EXPECT_NEAR(broken.length_m, even.length_m, 1e-12);
}

TEST(WallFit, directionOfBlurredLinesLeansToTheirLongSide)
{
    std::vector<Eigen::Vector2d> band;
    for (int x = 0; x < 30; ++x)
        for (int y = 0; y < 3; ++y) band.emplace_back(x * kRes, y * kRes);
    const LineFit fit = fitLine(band, kRes);
    EXPECT_NEAR(std::abs(fit.direction.x()), 1, 1e-12);
    EXPECT_NEAR(fit.center.y(), kRes, 1e-12);
}

TEST(WallFit, covarianceIsThatOfManyFitsOfPointsSpreadOverTheirCells)
{
    for (const double angle : {0.0, 0.4, 1.1}) {
        constexpr int POINTS = 30, TRIALS = 20000;
        const auto line = angle > 1 ? brokenLine(angle, POINTS) : exactLine(angle, POINTS);
        const Eigen::Vector2d t(std::cos(angle), std::sin(angle)), n(-t.y(), t.x());
        const LineFit fit = fitLine(line, kRes);
        const Sampled s = sampleFits(line, angle, TRIALS);
        const double tolerance = 0.05;  // five standard errors of a variance of 20000 samples
        EXPECT_NEAR(n.dot(fit.centerCovariance * n) / s.acrossVariance, 1, tolerance) << angle;
        EXPECT_NEAR(t.dot(fit.centerCovariance * t) / s.alongVariance, 1, tolerance) << angle;
        EXPECT_NEAR(t.dot(fit.normalCovariance * t) / s.normalVariance, 1, tolerance) << angle;
        EXPECT_NEAR(fit.lengthVariance / s.lengthVariance, 1, tolerance) << angle;
        EXPECT_LT(s.mean.norm(), 1e-3 * kRes * 10);
    }
}

TEST(WallFit, covariancesAreSymmetricAndOfTheirDirectionsOnly)
{
    const LineFit fit = fitLine(exactLine(0.7, 12), kRes);
    const Eigen::Vector2d n(-fit.direction.y(), fit.direction.x());
    EXPECT_EQ(fit.centerCovariance(0, 1), fit.centerCovariance(1, 0));
    EXPECT_EQ(fit.normalCovariance(0, 1), fit.normalCovariance(1, 0));
    EXPECT_NEAR(n.dot(fit.normalCovariance * n), 0, 1e-18) << "a unit normal moves along the line only";
    EXPECT_NEAR(n.dot(fit.centerCovariance * fit.direction), 0, 1e-18);
}

TEST(WallFit, tooFewDifferentPointsAreRefused)
{
    EXPECT_THROW(fitLine({}, kRes), std::invalid_argument);
    EXPECT_THROW(fitLine({{1, 2}}, kRes), std::invalid_argument);
    EXPECT_THROW(fitLine({{1, 2}, {1, 2}, {1, 2}}, kRes), std::invalid_argument);
    EXPECT_NO_THROW(fitLine({{1, 2}, {1, 2.05}}, kRes));
}
