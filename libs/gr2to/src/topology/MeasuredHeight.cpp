#include "gr2to/topology/MeasuredHeight.h"

#include <algorithm>
#include <cmath>

namespace gr2to
{
namespace
{
constexpr double kLineShare = 2.0 / 3;
constexpr double kBeyondShare = 1.0 / 3;
constexpr double kBeyond_m = 0.6;       // thicker than walls, less deep than a ceiling that was lowered
constexpr double kSameHeight_m = 0.15;  // things this much higher are another thing
constexpr double kMadToSigma = 1.4826;  // of a normal distribution

double medianOf(std::vector<double>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

MeasuredHeight measured(std::vector<double> values, double voxel_m)
{
    MeasuredHeight result;
    result.height_m = medianOf(values);
    std::vector<double> deviations;
    deviations.reserve(values.size());
    for (const double v : values) deviations.push_back(std::abs(v - result.height_m));
    const double sigma = kMadToSigma * medianOf(deviations);
    result.variance = voxel_m * voxel_m / 12 + sigma * sigma / static_cast<double>(values.size());
    return result;
}

std::vector<double> lintelsOver(const std::vector<Cell>& cells, const HeightMap& heights)
{
    std::vector<double> found;
    for (const Cell c : cells)
        if (const auto height = heights.lintel_m(c)) found.push_back(*height);
    return found;
}

/** Free cells of a line, moved. */
std::vector<Cell> movedLine(const ClassifiedGrid& grid, const std::vector<Cell>& line, double dx, double dy)
{
    std::vector<Cell> moved;
    for (const Cell c : line) {
        const Cell there{c.x + roundToCell(dx), c.y + roundToCell(dy)};
        if (grid.isFree(there)) moved.push_back(there);
    }
    return moved;
}
}  // namespace

std::optional<MeasuredHeight> wallHeight(const std::vector<Cell>& wall, const HeightMap& heights)
{
    std::vector<double> tops;
    for (const Cell c : wall)
        if (const auto top = heights.top_m(c)) tops.push_back(*top);
    if (tops.empty()) return {};
    return measured(std::move(tops), heights.voxel_m);
}

std::optional<MeasuredHeight> lintelHeight(const std::vector<Cell>& line, const HeightMap& heights)
{
    if (heights.empty() || line.empty()) return {};
    std::vector<double> found = lintelsOver(line, heights);
    if (static_cast<double>(found.size()) < kLineShare * static_cast<double>(line.size())) return {};
    return measured(std::move(found), heights.voxel_m);
}

bool hasLintel(const ClassifiedGrid& grid, const std::vector<Cell>& line, const Jambs& jambs,
               const HeightMap& heights)
{
    const auto lintel = lintelHeight(line, heights);
    if (!lintel) return false;
    const double x = jambs.facing.x - jambs.nearest.x, y = jambs.facing.y - jambs.nearest.y,
                 length = std::hypot(x, y);
    if (length == 0) return false;
    const double reach = kBeyond_m / grid.resolution_m() / length;
    for (const double side : {-reach, reach}) {
        const std::vector<Cell> beyond = movedLine(grid, line, -y * side, x * side);
        const auto low = lintelsOver(beyond, heights);
        const auto count = std::count_if(low.begin(), low.end(),
                                         [&](double h) { return h < lintel->height_m + kSameHeight_m; });
        if (static_cast<double>(count) >= kBeyondShare * static_cast<double>(beyond.size()) && count > 0)
            return false;
    }
    return true;
}

void setHeight(const HeightMap& heights, const std::optional<MeasuredHeight>& height,
               UncertainPoint& position, PlaneSize& size)
{
    position.mean.z = heights.floor_m;
    if (!height) return;
    size.height_m = height->height_m;
    size.covariance(1, 1) = height->variance;
    position.mean.z += height->height_m / 2;
    position.covariance(2, 2) = height->variance / 4;
}
}  // namespace gr2to
