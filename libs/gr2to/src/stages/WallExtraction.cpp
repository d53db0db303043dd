#include "gr2to/stages/WallExtraction.h"

#include <algorithm>

namespace gr2to
{
namespace
{
constexpr std::size_t kMostDirections = 6;
constexpr double kLeastOfStrongest = 0.1;  // a direction has at least a tenth of the strongest one's walls
}  // namespace

std::vector<OptionField> TWallOptions::fields()
{
    return {{"window", &window, "m", "Reach within which the direction of a wall is measured.", 0.02, 2},
            {"min_length", &min_length, "m", "Shortest straight stretch that counts as a wall.", 0.05, 20},
            {"max_gap", &max_gap, "m", "Widest gap within a straight wall.", 0, 5},
            {"max_angle", &max_angle, "deg",
             "A wall runs along a direction of the building when it deviates by at most this.", 1, 45}};
}

void WallLines::dropRemoved(const ClassifiedGrid& grid)
{
    segments.erase(std::remove_if(segments.begin(), segments.end(),
                                  [&](const WallSegment& s) { return !grid.isOccupied(s.cell); }),
                   segments.end());
}

WallExtractor::WallExtractor(TWallOptions options) : m_options(std::move(options))
{
    m_options.check();
}

WallLines WallExtractor::extract(const ClassifiedGrid& grid) const
{
    const double resolution = grid.resolution_m();
    const std::vector<WallCell> cells = measureWallOrientation(grid, m_options.window / resolution);
    WallLines lines;
    lines.directions = dominantDirections(cells, kMostDirections, kLeastOfStrongest);
    WallSegmentRules rules;
    rules.minLength_cells = m_options.min_length / resolution;
    rules.maxGap_cells = m_options.max_gap / resolution;
    rules.maxAngle_deg = m_options.max_angle;
    lines.segments = findWallSegments(cells, lines.directions, rules);
    return lines;
}
}  // namespace gr2to
