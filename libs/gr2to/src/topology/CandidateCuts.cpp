#include "gr2to/topology/CandidateCuts.h"

#include <algorithm>

#include "gr2to/grid/Circles.h"
#include "gr2to/grid/Jambs.h"
#include "gr2to/topology/MeasuredHeight.h"
#include "grid/RowIndex.h"

namespace gr2to
{
namespace
{
/** An end of a wall, at its last obstacle cell before free space. */
struct WallEnd
{
    std::size_t direction;
    int step, row;
    int sense;   // where the wall would go on, 1 or -1
    int length;  // of the wall [steps]
};

/** Moves the end on through the obstacle as long as free space is beside it: through the jamb, not through a
 * crossing wall. */
bool findTip(const ClassifiedGrid& grid, const LineDirection& direction, int reach, int beside, WallEnd& end)
{
    for (int k = 0; k <= reach; ++k) {
        if (grid.isFree(direction.cell(end.step + end.sense, end.row))) return true;
        end.step += end.sense;
        bool nearFree = false;
        for (int r = 1; r <= beside && !nearFree; ++r)
            nearFree = grid.isFree(direction.cell(end.step, end.row + r)) ||
                       grid.isFree(direction.cell(end.step, end.row - r));
        if (!nearFree) return false;
    }
    return false;
}

/** The free cells ahead of an end, up to the next obstacle; none when that is out of reach. */
std::vector<Cell> freeAhead(const ClassifiedGrid& grid, const LineDirection& direction, const WallEnd& end,
                            int limit)
{
    std::vector<Cell> cells;
    int t = end.step + end.sense;
    for (int k = 0; k < limit && grid.isFree(direction.cell(t, end.row)); ++k, t += end.sense)
        cells.push_back(direction.cell(t, end.row));
    if (grid.isFree(direction.cell(t, end.row))) cells.clear();
    return cells;
}

/** The free cells between two ends that face each other; none when an obstacle parts them. */
std::vector<Cell> freeBetween(const ClassifiedGrid& grid, Cell from, Cell to)
{
    std::vector<Cell> line = lineCells(from, to);
    const auto isFree = [&](Cell c) { return grid.isFree(c); };
    const auto first = std::find_if(line.begin(), line.end(), isFree);
    const auto last = std::find_if_not(first, line.end(), isFree);
    if (std::any_of(last, line.end(), isFree)) return {};
    return {first, last};
}
/** Ends of all walls, for looking up those on one line. */
class WallEnds
{
 public:
    WallEnds(const ClassifiedGrid& grid, const std::vector<WallSegment>& segments,
             const std::vector<LineDirection>& directions, double skip_cells)
    {
        constexpr int beside = 4;  // rows in which free space keeps a jamb apart from a crossing wall
        for (const WallSegment& s : segments) {
            const LineDirection& direction = directions[s.direction];
            const int reach = static_cast<int>(skip_cells / direction.stretch());
            const int length = s.end - s.begin + 1;
            for (WallEnd end : {WallEnd{s.direction, s.begin, s.beginRow, -1, length},
                                WallEnd{s.direction, s.end, s.endRow, 1, length}})
                if (findTip(grid, direction, reach, beside, end)) m_ends.push_back(end);
        }
        for (const WallEnd& end : m_ends) m_byRow.add(end.direction, end.row, &end);
    }

    const std::vector<WallEnd>& all() const { return m_ends; }

    /** The nearest end ahead that faces this one; null when there is none near its line.
     * \param rows  off the line at most \param limit  steps ahead at most */
    const WallEnd* facing(const WallEnd& end, int rows, int limit) const
    {
        const WallEnd* best = nullptr;
        int bestGap = limit + 1;
        m_byRow.forEachNear(end.direction, end.row, rows, [&](const WallEnd* other) {
            const int gap = (other->step - end.step) * end.sense;
            if (other->sense == end.sense || gap <= 0 || gap >= bestGap) return;
            best = other;
            bestGap = gap;
        });
        return best;
    }

 private:
    std::vector<WallEnd> m_ends;
    RowIndex<const WallEnd*> m_byRow;
};
}  // namespace

std::vector<CandidateCut> extendWalls(const ClassifiedGrid& grid, const std::vector<WallSegment>& segments,
                                      const std::vector<LineDirection>& directions,
                                      const ExtensionRules& rules)
{
    const WallEnds ends(grid, segments, directions, rules.skip_cells);
    std::vector<CandidateCut> cuts;
    for (const WallEnd& end : ends.all()) {
        const LineDirection& direction = directions[end.direction];
        const int rows = static_cast<int>(rules.offset_cells * direction.stretch());
        const double reach_steps =
            rules.reach_cells / direction.stretch() + rules.reachPerLength * end.length;
        const int limit = static_cast<int>(std::min(reach_steps, rules.most_cells / direction.stretch()));
        CandidateCut cut;
        if (const WallEnd* other = ends.facing(end, rows, limit)) {
            const Cell from = direction.cell(end.step, end.row), to = direction.cell(other->step, other->row);
            cut.cells = freeBetween(grid, from, to);
            cut.kind = CutKind::WallToWall;
            cut.direction = LineDirection(to.x - from.x, to.y - from.y);
        }
        if (cut.cells.empty()) {
            cut.kind = CutKind::WallRay;
            cut.direction = direction;
            cut.cells = freeAhead(grid, direction, end, limit);
        }
        if (cut.cells.empty()) continue;
        cut.row = cut.direction.row(cut.cells[cut.cells.size() / 2]);
        cuts.push_back(std::move(cut));
    }
    return cuts;
}

void lookForLintels(const ClassifiedGrid& grid, const HeightMap& heights, double maxLength_cells,
                    std::vector<CandidateCut>& cuts)
{
    if (heights.empty()) return;
    for (CandidateCut& cut : cuts) {
        const LineDirection& d = cut.direction;
        if (static_cast<double>(cut.cells.size()) * d.stretch() > maxLength_cells) continue;
        const bool upwards = d.step(cut.cells.front()) <= d.step(cut.cells.back());
        const Cell low = upwards ? cut.cells.front() : cut.cells.back();
        const Cell high = upwards ? cut.cells.back() : cut.cells.front();
        const Jambs jambs{d.cell(d.step(low) - 1, d.row(low)), d.cell(d.step(high) + 1, d.row(high))};
        cut.lintel = hasLintel({grid, cut.cells, jambs}, heights);
    }
}

std::vector<CandidateCut> criticalCuts(const ClassifiedGrid& grid, Obstacles obstacles,
                                       const std::vector<CriticalPoint>& points, double maxLength_cells)
{
    std::vector<CandidateCut> cuts;
    for (const CriticalPoint& point : points) {
        if (2 * point.clearance_cells > maxLength_cells + 2) continue;
        const auto jambs = findJambs(grid, obstacles, point.cell, point.clearance_cells);
        if (!jambs) continue;
        const double dx = jambs->facing.x - jambs->nearest.x, dy = jambs->facing.y - jambs->nearest.y;
        if (std::hypot(dx, dy) - 1 > maxLength_cells) continue;
        CandidateCut cut;
        cut.kind = CutKind::CriticalLine;
        cut.cells = lineCells(jambs->nearest, jambs->facing);
        cut.cells.erase(
            std::remove_if(cut.cells.begin(), cut.cells.end(), [&](Cell c) { return !grid.isFree(c); }),
            cut.cells.end());
        if (cut.cells.empty()) continue;
        cut.direction = LineDirection(dx, dy);
        cut.row = cut.direction.row(cut.cells[cut.cells.size() / 2]);
        cuts.push_back(std::move(cut));
    }
    return cuts;
}
}  // namespace gr2to
