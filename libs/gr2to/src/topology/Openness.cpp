#include "gr2to/topology/Openness.h"

#include <algorithm>

namespace gr2to
{
CutSurroundings::CutSurroundings(const FaceMap& faces, const CandidateCut& cut, const OpennessRules& rules)
{
    const LineDirection& d = cut.direction;
    const auto [first, last] = std::minmax({d.step(cut.cells.front()), d.step(cut.cells.back())});
    const int reach = static_cast<int>(rules.reach_cells / d.stretch());
    const int walks = static_cast<int>(rules.depth_cells / std::max(1.0, rules.step_cells) + 1e-9);
    for (const int side : {0, 1})
        for (int k = 1; k <= walks; ++k) {
            const double depth = k * std::max(1.0, rules.step_cells) * d.stretch();
            const int rows = static_cast<int>(std::lround(depth)) * (side == 1 ? 1 : -1);
            const int shift = static_cast<int>(std::lround(d.skew(rows)));
            m_lines[static_cast<std::size_t>(side)].push_back(
                {shift, faces.along(d, cut.row + rows, first + shift, last + 1 + shift, reach)});
        }
}

int CutSurroundings::longestWalk(bool above, int begin, int end,
                                 const std::function<bool(int)>& isInside) const
{
    int longest = 0;
    for (const Line& line : m_lines[above ? 1 : 0]) {
        const int from = begin + line.shift, to = end + line.shift;
        int walkBegin = 0, walkEnd = 0;
        const auto finish = [&] {
            if (walkBegin < to && walkEnd > from) longest = std::max(longest, walkEnd - walkBegin);
        };
        for (const FaceMap::Stretch& stretch : line.stretches) {
            if (stretch.face == 0 || !isInside(stretch.face)) continue;
            if (stretch.begin != walkEnd || walkEnd == walkBegin) {
                finish();
                walkBegin = stretch.begin;
            }
            walkEnd = stretch.end;
        }
        finish();
    }
    return longest;
}
}  // namespace gr2to
