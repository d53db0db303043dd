#include "io/ImageRule.h"

#include <limits>

#include "gr2to/base/errors.h"

namespace gr2to::io
{
namespace
{
constexpr unsigned kGreyLevels = 255;  // ROS's thresholds and codes are stated for 8-bit greys
constexpr double kPercent = 100.0;

bool isUnknownCode(const ImageRule& rule, unsigned sum, unsigned top)
{
    if (rule.mode != ImageMode::Trinary || rule.negate || rule.unknown_grey < 0) return false;
    return std::uint64_t{sum} * kGreyLevels == std::uint64_t(rule.unknown_grey) * top;
}

CellState stateOf(const ImageRule& rule, double occupancy)
{
    if (occupancy > rule.occupied_threshold) return CellState::Occupied;
    if (occupancy < rule.free_threshold) return CellState::Free;
    return CellState::Unknown;
}
}  // namespace

std::vector<CellState> stateTable(const ImageRule& rule, unsigned channels, unsigned maximum,
                                  const std::string& name)
{
    if (rule.mode == ImageMode::Raw && maximum != kGreyLevels)
        throw InputError(name + " has greys up to " + std::to_string(maximum) +
                         "; mode raw needs an 8-bit image (up to 255): use mode trinary or scale");
    const unsigned top = channels * maximum;
    std::vector<CellState> table(std::size_t{top} + 1, CellState::Unknown);
    for (unsigned sum = 0; sum <= top; ++sum) {
        if (isUnknownCode(rule, sum, top)) continue;
        const unsigned level = rule.negate ? top - sum : sum;
        if (rule.mode == ImageMode::Raw) {
            const double value = static_cast<double>(level) / channels;
            if (value <= kPercent) table[sum] = stateOf(rule, value / kPercent);
        } else
            table[sum] = stateOf(rule, static_cast<double>(top - level) / top);
    }
    return table;
}

void requireSize(std::uint64_t width, std::uint64_t height, const std::string& name)
{
    constexpr std::uint64_t longest = std::numeric_limits<int>::max();
    const auto size = [&] { return std::to_string(width) + " x " + std::to_string(height); };
    if (width == 0 || height == 0)
        throw InputError(name + " has " + size() + " cells; both sides must be positive");
    if (width > longest || height > longest || width * height > ClassifiedGrid::maxCells())
        throw InputError(name + " claims " + size() +
                         " cells; at most 2^31 are supported: crop it or use a coarser resolution");
}
}  // namespace gr2to::io
