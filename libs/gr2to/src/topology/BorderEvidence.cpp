#include "gr2to/topology/BorderEvidence.h"

#include <algorithm>
#include <cmath>

namespace gr2to
{
namespace
{
// Weights [nat per unit of the measure], rounded; see doc/algorithm.md.
constexpr double kPrior = -0.8;
constexpr double kOpennessOfWiderSide = -5.1;  // of the side to which the border is more open
constexpr double kOpennessOfBoth = -2.3;       // product
constexpr double kArea = 0.6;                  // logarithm of each area
constexpr double kShorterFin = 2.4;            // per metre
constexpr double kLongerFin = 1.25;            // per metre
constexpr double kRectangularity = 2.4;        // of the smaller region
constexpr double kNarrowness = -0.85;          // half the length over the smaller region's radius
constexpr double kBetterRectangle = -12;       // gain in rectangularity by merging
constexpr double kLength = -0.4;               // logarithm of the total length
constexpr double kSolidEnd = -1.3;
constexpr double kElongation = -0.9;  // logarithm, of the less elongated region
constexpr double kMouth = 1.5;        // twice what the regression gives: mouths are few among its samples
constexpr double kLintel = 5;  // not from the regression, whose maps are flat: lintels are built over doors

// Measures beyond these say no more.
constexpr double kShorterFin_m = 0.5;
constexpr double kLongerFin_m = 1;
constexpr double kNarrownessMost = 3;
constexpr double kSmallest_m2 = 0.3;
constexpr double kSmallerLargest_m2 = 30;
constexpr double kLargest_m2 = 200;
constexpr double kShortest_m = 0.2;
constexpr double kLongest_m = 20;
constexpr double kSmallestRadius_m = 0.1;

/** Logarithm of how many squares of the largest circle's diameter fill the region. */
double elongation(const BorderSide& side)
{
    const double diameter = 2 * std::max(side.radius_m, kSmallestRadius_m);
    return std::log(std::clamp(side.area_m2 / (diameter * diameter), 0.5, 20.0));
}

double areas(const BorderMeasures& border)
{
    return std::log(std::clamp(border.smaller.area_m2, kSmallest_m2, kSmallerLargest_m2)) +
           std::log(std::clamp(border.larger.area_m2, kSmallest_m2, kLargest_m2));
}

/** How much better a rectangle the whole is than its parts. That corridors make no rectangle when they meet
 * says little. */
double gainInRectangularity(const BorderMeasures& border, double leastElongation)
{
    const BorderSide &a = border.smaller, &b = border.larger;
    const double parts =
        (a.rectangularity * a.area_m2 + b.rectangularity * b.area_m2) / (a.area_m2 + b.area_m2);
    return (border.unionRectangularity - parts) * std::exp(-std::clamp(leastElongation, 0.0, 3.0));
}

bool isMouth(const BorderMeasures& border, const MouthRules& mouth)
{
    const auto [narrower, wider] = std::minmax(border.smaller.radius_m, border.larger.radius_m);
    return std::min(border.smaller.openness, border.larger.openness) <= mouth.openness &&
           narrower <= mouth.contrast * wider;
}
}  // namespace

double borderEvidence(const BorderMeasures& border, const MouthRules& mouth)
{
    const BorderSide &a = border.smaller, &b = border.larger;
    const double leastElongation = std::min(elongation(a), elongation(b));
    const double narrowness =
        std::min(border.length_m / 2 / std::max(a.radius_m, kSmallestRadius_m), kNarrownessMost);
    return kPrior + kOpennessOfWiderSide * std::max(a.openness, b.openness) +
           kOpennessOfBoth * a.openness * b.openness + kArea * areas(border) +
           kShorterFin * std::min(border.shorterFin_m, kShorterFin_m) +
           kLongerFin * std::min(border.longerFin_m, kLongerFin_m) + kRectangularity * a.rectangularity +
           kNarrowness * narrowness + kBetterRectangle * gainInRectangularity(border, leastElongation) +
           kLength * std::log(std::clamp(border.total_m, kShortest_m, kLongest_m)) +
           (border.solidEnd ? kSolidEnd : 0) + kElongation * leastElongation +
           (isMouth(border, mouth) ? kMouth : 0) + (border.lintel ? kLintel : 0);
}
}  // namespace gr2to
