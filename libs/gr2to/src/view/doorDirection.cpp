#include "doorDirection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gr2to::view
{
namespace
{
constexpr std::size_t kDirections = 36;  // over half a turn
constexpr double kHalfTurn_rad = 3.141592653589793;
constexpr double kStep_cells = 0.5;
constexpr double kFarthest_cells = 1e6;  // wider than any grid; keeps an absurd reach countable
constexpr double kTie_cells = 1.0;       // runs are known to a cell at best
constexpr int kShift_cells = 2;          // a door's centre may lie beside a thin wall's axis by so much

Eigen::Vector2d unit(double angle_rad)
{
    return {std::cos(angle_rad), std::sin(angle_rad)};
}

/** Length of the free run from a point; infinite when it is longer than the reach. */
double freeRun(const ClassifiedGrid& grid, const Eigen::Vector2d& from, const Eigen::Vector2d& direction,
               double reach_cells)
{
    const int steps = static_cast<int>(std::min(kFarthest_cells, reach_cells) / kStep_cells);
    for (int i = 0; i <= steps; ++i) {
        const double run = i * kStep_cells;
        const Eigen::Vector2d p = from + run * direction;
        if (!grid.isFree({static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))}))
            return run;
    }
    return std::numeric_limits<double>::infinity();
}

/** Shortest free run, both ways together, through the centre or a point beside it; 0 is no run at all. */
double span(const ClassifiedGrid& grid, const Eigen::Vector2d& center, const Eigen::Vector2d& direction,
            double reach_cells)
{
    double shortest = std::numeric_limits<double>::infinity();
    for (int shift = -kShift_cells; shift <= kShift_cells; ++shift) {
        const Eigen::Vector2d from = center + shift * Eigen::Vector2d(-direction.y(), direction.x());
        const double run =
            freeRun(grid, from, direction, reach_cells) + freeRun(grid, from, -direction, reach_cells);
        if (run > 0) shortest = std::min(shortest, run);
    }
    return shortest;
}
}  // namespace

std::optional<Eigen::Vector2d> doorDirection(const ClassifiedGrid& grid, const Eigen::Vector2d& center,
                                             double reach_cells)
{
    std::array<double, kDirections> spans{};
    const auto angle = [](std::size_t i) { return kHalfTurn_rad * static_cast<double>(i) / kDirections; };
    for (std::size_t i = 0; i < spans.size(); ++i) spans[i] = span(grid, center, unit(angle(i)), reach_cells);
    const double shortest = *std::min_element(spans.begin(), spans.end());
    if (!std::isfinite(shortest)) return std::nullopt;
    // A direction and its opposite are the same one, so their mean is taken at twice the angle.
    Eigen::Vector2d sum(0, 0);
    for (std::size_t i = 0; i < spans.size(); ++i)
        if (spans[i] < shortest + kTie_cells) sum += unit(2 * angle(i));
    if (sum.norm() < 1e-9) return std::nullopt;
    return unit(std::atan2(sum.y(), sum.x()) / 2);
}

std::optional<Eigen::Vector2d> contactDirection(const PlaceImage& places, PlaceId a, PlaceId b,
                                                const Eigen::Vector2d& center, double reach_cells)
{
    const auto within = [](double v, int size) { return static_cast<int>(std::clamp(v, 0.0, size - 1.0)); };
    const auto touch = [&](Cell one, Cell other) {
        const PlaceId first = places.at(one), second = places.at(other);
        return (first == a && second == b) || (first == b && second == a);
    };
    Eigen::Vector2d sum(0, 0), squares(0, 0);
    double product = 0, count = 0;
    const auto add = [&](double x, double y) {
        const Eigen::Vector2d p(x - center.x(), y - center.y());
        sum += p;
        squares += p.cwiseProduct(p);
        product += p.x() * p.y();
        ++count;
    };
    const int left = within(center.x() - reach_cells, places.width),
              right = within(center.x() + reach_cells, places.width),
              bottom = within(center.y() - reach_cells, places.height),
              top = within(center.y() + reach_cells, places.height);
    for (int y = bottom; y <= top; ++y)
        for (int x = left; x <= right; ++x) {
            if (x < right && touch({x, y}, {x + 1, y})) add(x + 0.5, y);
            if (y < top && touch({x, y}, {x, y + 1})) add(x, y + 0.5);
        }
    if (count < 2) return std::nullopt;
    const Eigen::Vector2d spread = squares - sum.cwiseProduct(sum) / count;
    product -= sum.x() * sum.y() / count;
    return unit(std::atan2(2 * product, spread.x() - spread.y()) / 2);
}
}  // namespace gr2to::view
