#include "gr2to/topology/MeasuredHeight.h"

#include <algorithm>
#include <cmath>

namespace gr2to
{
namespace
{
constexpr double kLineShare = 2.0 / 3;
constexpr double kBeyondShare = 1.0 / 3;
constexpr double kJambDepth_m = 0.3;
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

/** A line beside a passage's, and what hangs over it. */
struct Over
{
    int steps = 0;  //!< cells that it is moved by, across the passage's line
    std::size_t cells = 0;
    std::vector<double> lintels_m;

    bool covers(double share) const
    {
        return !lintels_m.empty() &&
               static_cast<double>(lintels_m.size()) >= share * static_cast<double>(cells);
    }
};

/** Looks at lines beside a passage's. */
class PassageView
{
 public:
    PassageView(const Passage& passage, const HeightMap& heights) : m_passage(passage), m_heights(heights)
    {
        const Cell a = passage.jambs.nearest, b = passage.jambs.facing;
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        m_acrossX = length > 0 ? (a.y - b.y) / length : 0;
        m_acrossY = length > 0 ? (b.x - a.x) / length : 0;
    }

    Over moved(int steps) const
    {
        Over over;
        over.steps = steps;
        std::vector<Cell> cells;
        for (const Cell c : m_passage.line) {
            const Cell there{c.x + roundToCell(steps * m_acrossX), c.y + roundToCell(steps * m_acrossY)};
            if (m_passage.grid.isFree(there)) cells.push_back(there);
        }
        over.cells = cells.size();
        over.lintels_m = lintelsOver(cells, m_heights);
        return over;
    }

    /** The nearest line with something over it; nothing over the result when there is none. */
    Over nearest() const
    {
        for (int steps = 0; steps <= stepsOf(kJambDepth_m); ++steps)
            for (const int side : {-steps, steps})
                if (Over over = moved(side);
                    over.covers(kLineShare) && 2 * over.cells >= m_passage.line.size())
                    return over;
        return {};
    }

    int stepsOf(double length_m) const
    {
        return static_cast<int>(std::lround(length_m / m_passage.grid.resolution_m()));
    }

 private:
    const Passage& m_passage;
    const HeightMap& m_heights;
    double m_acrossX, m_acrossY;
};
}  // namespace

std::optional<MeasuredHeight> wallHeight(const std::vector<Cell>& wall, const HeightMap& heights)
{
    std::vector<double> tops;
    for (const Cell c : wall)
        if (const auto top = heights.top_m(c)) tops.push_back(*top);
    if (tops.empty()) return {};
    return measured(std::move(tops), heights.voxel_m);
}

std::optional<MeasuredHeight> lintelHeight(const Passage& passage, const HeightMap& heights)
{
    if (heights.empty()) return {};
    Over over = PassageView(passage, heights).nearest();
    if (over.lintels_m.empty()) return {};
    return measured(std::move(over.lintels_m), heights.voxel_m);
}

bool hasLintel(const Passage& passage, const HeightMap& heights)
{
    if (heights.empty()) return false;
    const PassageView view(passage, heights);
    Over over = view.nearest();
    if (over.lintels_m.empty()) return false;
    const double tooLow = medianOf(over.lintels_m) + kSameHeight_m;
    const auto goesOn = [&](int steps) {
        Over beyond = view.moved(over.steps + steps);
        std::vector<double>& all = beyond.lintels_m;
        all.erase(std::remove_if(all.begin(), all.end(), [&](double h) { return h >= tooLow; }), all.end());
        return beyond.covers(kBeyondShare);
    };
    return !goesOn(view.stepsOf(kBeyond_m)) && !goesOn(-view.stepsOf(kBeyond_m));
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
