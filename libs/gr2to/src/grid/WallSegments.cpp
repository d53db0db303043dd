#include "gr2to/grid/WallSegments.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace gr2to
{
namespace
{
struct Run
{
    int row, begin, end;
};

constexpr std::int64_t kRow = std::int64_t{1} << 32U;  // more steps than any gap and any line

std::vector<Run> runsAlong(const std::vector<WallCell>& cells, const LineDirection& direction,
                           const WallSegmentRules& rules)
{
    const double gate = std::cos(2 * rules.maxAngle_deg * 3.14159265358979323846 / 180);
    const double c = direction.doubleCos(), s = direction.doubleSin();
    std::vector<std::int64_t> members;  // row and step in one number, by which they sort
    for (const WallCell& w : cells) {
        const double coherence = std::hypot(w.doubleCos, w.doubleSin);
        if (coherence < rules.minCoherence || w.doubleCos * c + w.doubleSin * s < gate * coherence) continue;
        members.push_back(std::int64_t{direction.row(w.cell)} * kRow + direction.step(w.cell));
    }
    std::sort(members.begin(), members.end());
    std::vector<Run> runs;
    const double gap = rules.maxGap_cells / direction.stretch(),
                 length = rules.minLength_cells / direction.stretch();
    for (std::size_t i = 0; i < members.size();) {
        std::size_t k = i + 1;
        while (k < members.size() && static_cast<double>(members[k] - members[k - 1] - 1) <= gap) ++k;
        if (static_cast<double>(members[k - 1] - members[i] + 1) >= length) {
            const std::int64_t begin = members[i] & (kRow - 1), row = (members[i] - begin) / kRow;
            runs.push_back({static_cast<int>(row), static_cast<int>(begin),
                            static_cast<int>(members[k - 1] - row * kRow)});
        }
        i = k;
    }
    return runs;
}

/** Joins runs of neighbouring rows that overlap; runs are in the order of rows and steps. */
std::vector<std::size_t> joinRows(const std::vector<Run>& runs)
{
    std::vector<std::size_t> parent(runs.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    std::size_t below = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        while (below < i && (runs[below].row < runs[i].row - 1 ||
                             (runs[below].row == runs[i].row - 1 && runs[below].end < runs[i].begin)))
            ++below;
        for (std::size_t k = below; k < i && runs[k].row == runs[i].row - 1 && runs[k].begin <= runs[i].end;
             ++k) {
            if (runs[k].end < runs[i].begin) continue;
            const std::size_t a = find(k), b = find(i);
            parent[std::max(a, b)] = std::min(a, b);
        }
    }
    for (std::size_t i = 0; i < runs.size(); ++i) parent[i] = find(i);
    return parent;
}
}  // namespace

std::vector<WallSegment> findWallSegments(const std::vector<WallCell>& cells,
                                          const std::vector<LineDirection>& directions,
                                          const WallSegmentRules& rules)
{
    std::vector<WallSegment> segments;
    for (std::size_t d = 0; d < directions.size(); ++d) {
        const std::vector<Run> runs = runsAlong(cells, directions[d], rules);
        const std::vector<std::size_t> groupOf = joinRows(runs);
        std::vector<std::vector<std::size_t>> members(runs.size());
        for (std::size_t r = 0; r < runs.size(); ++r) members[groupOf[r]].push_back(r);
        const double near = 0.5 * rules.maxGap_cells;
        for (const auto& group : members) {
            if (group.empty()) continue;
            WallSegment s;
            s.direction = d;
            s.begin = runs[group[0]].begin;
            s.end = runs[group[0]].end;
            for (const std::size_t r : group) {
                s.begin = std::min(s.begin, runs[r].begin);
                s.end = std::max(s.end, runs[r].end);
            }
            double beginSum = 0, endSum = 0;
            int begins = 0, ends = 0;
            std::size_t longest = group[0];
            for (const std::size_t r : group) {
                if (runs[r].begin <= s.begin + near) beginSum += runs[r].row, ++begins;
                if (runs[r].end >= s.end - near) endSum += runs[r].row, ++ends;
                if (runs[r].end - runs[r].begin > runs[longest].end - runs[longest].begin) longest = r;
            }
            s.beginRow = static_cast<int>(std::lround(beginSum / begins));
            s.endRow = static_cast<int>(std::lround(endSum / ends));
            s.cell = directions[d].cell(runs[longest].begin, runs[longest].row);
            segments.push_back(s);
        }
    }
    return segments;
}
}  // namespace gr2to
