#include "WallPieces.h"

#include <algorithm>
#include <cmath>

#include "grid/thickness.h"

namespace gr2to
{
std::vector<bool> WallPieces::find(Runs& runs, const Stands& stands)
{
    struct Piece
    {
        const WallSegment& segment;
        std::vector<Cell> middle;
    };
    std::vector<Piece> pieces;
    for (const WallSegment& s : m_segments) {
        const bool isWall = stands(runs.root(runs.find(m_grid.index(s.cell))));
        std::vector<Cell> middle;
        if (length_cells(s) >= m_rules.minAlignedLength_cells) middle = middleOf(s);
        const bool isPiece =
            !middle.empty() && isThin(m_directions[s.direction], middle, m_rules.mostThickness_cells);
        if (isPiece) pieces.push_back({s, std::move(middle)});
        if (!isWall && !isPiece) continue;
        m_begins.add(s.direction, s.beginRow, &s);
        m_ends.add(s.direction, s.endRow, &s);
    }
    std::vector<bool> isWall(runs.runs().size(), false);
    for (Piece& piece : pieces) {
        const WallSegment& s = piece.segment;
        const bool standsAlone =
            length_cells(s) >= m_rules.minLength_cells &&
            isThin(m_directions[s.direction], piece.middle, m_rules.mostLoneThickness_cells);
        if (!standsAlone && !isInLine(s) && !facesAStub(s, runs, stands)) continue;
        piece.middle.push_back(s.cell);
        for (const Cell c : piece.middle)
            if (isObstacle(c)) isWall[runs.root(runs.find(m_grid.index(c)))] = true;
    }
    return isWall;
}

/** The cells in the middle of a straight stretch, from its begin to its end. */
std::vector<Cell> WallPieces::middleOf(const WallSegment& s) const
{
    std::vector<Cell> cells;
    for (int step = s.begin; step <= s.end; ++step) {
        const double part = static_cast<double>(step - s.begin) / std::max(1, s.end - s.begin);
        const int rise = static_cast<int>(std::lround(part * (s.endRow - s.beginRow)));
        cells.push_back(m_directions[s.direction].cell(step, s.beginRow + rise));
    }
    return cells;
}

bool WallPieces::isThinAt(const LineDirection& direction, int step, int row, double most_cells) const
{
    const int most = static_cast<int>(most_cells * direction.stretch());  // rows
    return thicknessAcross(m_grid, direction, step, row, most) <= most;
}

bool WallPieces::isThin(const LineDirection& direction, const std::vector<Cell>& middle,
                        double most_cells) const
{
    const auto thin = std::count_if(middle.begin(), middle.end(), [&](Cell c) {
        return isThinAt(direction, direction.step(c), direction.row(c), most_cells);
    });
    return 2 * static_cast<std::size_t>(thin) >= middle.size();
}

/** Whether a wall or another piece goes on in line with one, at most a doorway beyond either end. */
bool WallPieces::isInLine(const WallSegment& s) const
{
    const double stretch = m_directions[s.direction].stretch();
    const int rows = static_cast<int>(m_rules.inLine_cells * stretch);
    const int doorway = static_cast<int>(m_rules.doorway_cells / stretch);
    bool found = false;
    m_begins.forEachNear(s.direction, s.endRow, rows, [&](const WallSegment* other) {
        found = found || (other->begin > s.end && other->begin - s.end <= doorway);
    });
    m_ends.forEachNear(s.direction, s.beginRow, rows, [&](const WallSegment* other) {
        found = found || (other->end < s.begin && s.begin - other->end <= doorway);
    });
    return found;
}

/** Whether the first obstacle ahead, at most a doorway beyond either end, is a thin stub of something that
 * stands. */
bool WallPieces::facesAStub(const WallSegment& s, Runs& runs, const Stands& stands) const
{
    const LineDirection& direction = m_directions[s.direction];
    const int doorway = static_cast<int>(m_rules.doorway_cells / direction.stretch());
    const double length = m_rules.stub_cells / direction.stretch();
    for (const int sense : {-1, 1}) {
        const int row = sense > 0 ? s.endRow : s.beginRow;
        int step = (sense > 0 ? s.end : s.begin) + sense;
        const auto cell = [&] { return direction.cell(step, row); };
        for (int k = 0; k < 3 && isObstacle(cell()); ++k) step += sense;  // its own ragged end
        for (int k = 0; k < doorway && m_grid.isFree(cell()); ++k) step += sense;
        if (!isObstacle(cell()) || !stands(runs.root(runs.find(m_grid.index(cell()))))) continue;
        int stub = 0;
        while (stub < length && isObstacle(cell()) &&
               isThinAt(direction, step, row, m_rules.mostThickness_cells)) {
            step += sense;
            ++stub;
        }
        if (stub >= length) return true;
    }
    return false;
}
}  // namespace gr2to
