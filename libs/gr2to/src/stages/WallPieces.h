#pragma once

#include <functional>
#include <vector>

#include "gr2to/grid/Runs.h"
#include "gr2to/grid/WallSegments.h"
#include "grid/RowIndex.h"

namespace gr2to
{
struct WallPieceRules
{
    double minLength_cells = 0;          //!< of a piece wherever it stands
    double minAlignedLength_cells = 0;   //!< of a piece in line with another one or with a wall
    double mostThickness_cells = 0;      //!< of a piece in line, for half of its length at least
    double mostLoneThickness_cells = 0;  //!< the same of any other
    double doorway_cells = 0;            //!< pieces in line are at most that far apart: wider than doors are
    double inLine_cells = 0;             //!< and at most that far off the line: as thick as walls are
    double stub_cells = 0;               //!< of wall in line with a piece
};

/** Tells free-standing pieces of wall from other free-standing things.
 *
 * A piece is a straight and thin stretch, long by itself, or shorter and in line with something beyond
 * a doorway: with another piece, with a wall, or with a stub that stands out of a wall.
 */
class WallPieces
{
 public:
    /** Whether the blob with this root, of the cells that are not free, is no free-standing thing. */
    using Stands = std::function<bool(std::size_t root)>;

    WallPieces(const ClassifiedGrid& grid, const std::vector<WallSegment>& segments,
               const std::vector<LineDirection>& directions, const WallPieceRules& rules)
        : m_grid(grid), m_segments(segments), m_directions(directions), m_rules(rules)
    {
    }

    /** By root, whether a blob is a piece of wall: all that such a stretch runs over, gaps in it being gaps
     * of the map. \param runs  of the cells that are not free */
    std::vector<bool> find(Runs& runs, const Stands& stands);

 private:
    double length_cells(const WallSegment& s) const
    {
        return (s.end - s.begin + 1) * m_directions[s.direction].stretch();
    }
    std::vector<Cell> middleOf(const WallSegment& s) const;
    bool isObstacle(Cell c) const { return m_grid.contains(c) && !m_grid.isFree(c); }
    bool isThinAt(const LineDirection& direction, int step, int row, double most_cells) const;
    bool isThin(const LineDirection& direction, const std::vector<Cell>& middle, double most_cells) const;
    bool isInLine(const WallSegment& s) const;
    bool facesAStub(const WallSegment& s, Runs& runs, const Stands& stands) const;

    const ClassifiedGrid& m_grid;
    const std::vector<WallSegment>& m_segments;
    const std::vector<LineDirection>& m_directions;
    WallPieceRules m_rules;
    RowIndex<const WallSegment*> m_begins, m_ends;  //!< of walls and aligned pieces
};
}  // namespace gr2to
