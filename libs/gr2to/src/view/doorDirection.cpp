#include "doorDirection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gr2to::view
{
namespace
{
constexpr int kDirections = 48;  // over half a turn
constexpr double kHalfTurn_rad = 3.141592653589793;
constexpr double kStep_cells = 0.25;  // finer than a cell's corner
constexpr double kTie_cells = 1.0;    // runs are known to a cell at best

/** Length of the free run from the centre; infinite when it is longer than the reach. */
double freeRun(const ClassifiedGrid& grid, const Eigen::Vector2d& center, const Eigen::Vector2d& direction,
               double reach_cells)
{
    for (double run = 0; run <= reach_cells; run += kStep_cells) {
        const Eigen::Vector2d p = center + run * direction;
        if (!grid.isFree({static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))}))
            return run;
    }
    return std::numeric_limits<double>::infinity();
}
}  // namespace

std::optional<Eigen::Vector2d> doorDirection(const ClassifiedGrid& grid, const Eigen::Vector2d& center,
                                             double reach_cells)
{
    std::array<double, kDirections> spans{};
    const auto angle = [](std::size_t i) { return kHalfTurn_rad * static_cast<double>(i) / kDirections; };
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const Eigen::Vector2d direction(std::cos(angle(i)), std::sin(angle(i)));
        spans[i] =
            freeRun(grid, center, direction, reach_cells) + freeRun(grid, center, -direction, reach_cells);
    }
    const double shortest = *std::min_element(spans.begin(), spans.end());
    if (!std::isfinite(shortest)) return std::nullopt;
    // A direction and its opposite are the same one, so their mean is taken at twice the angle.
    Eigen::Vector2d sum(0, 0);
    for (std::size_t i = 0; i < spans.size(); ++i)
        if (spans[i] < shortest + kTie_cells)
            sum += Eigen::Vector2d(std::cos(2 * angle(i)), std::sin(2 * angle(i)));
    if (sum.norm() < 1e-9) return std::nullopt;
    const double mean = std::atan2(sum.y(), sum.x()) / 2;
    return Eigen::Vector2d(std::cos(mean), std::sin(mean));
}
}  // namespace gr2to::view
