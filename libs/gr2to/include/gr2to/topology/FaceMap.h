#pragma once

#include <vector>

#include "gr2to/topology/CandidateCuts.h"

namespace gr2to
{
/** The free space cut into faces, and what lies beside a cut. */
class FaceMap
{
 public:
    /** A stretch of a digital line in one face; 0 stands for cells that are not free. */
    struct Stretch
    {
        int begin = 0, end = 0;  //!< steps; the end is after the last
        int face = 0;
    };

    /** A piece of a cut between two faces. */
    struct Piece
    {
        int begin = 0, end = 0;    //!< steps along the cut's direction
        int below = 0, above = 0;  //!< faces in the rows below and above
    };

    /** Faces are the 4-connected parts of the free space without the cuts; a cut's own cells join a face
     * beside them. Cost: linear in the number of cells. */
    FaceMap(const ClassifiedGrid& grid, const std::vector<CandidateCut>& cuts);

    int count() const { return m_count; }
    /** From 1; 0 on cells that are not free. */
    const std::vector<int>& ofCell() const { return m_face; }
    int at(const LineDirection& direction, int step, int row) const
    {
        const Cell c = direction.cell(step, row);
        return m_grid.contains(c) ? m_face[m_grid.index(c)] : 0;
    }

    /** The pieces of a cut, in the order of steps. */
    std::vector<Piece> piecesOf(const CandidateCut& cut) const;
    /** The faces along a line, from `begin` to `end` and on to the next obstacle, at most `reach` steps. */
    std::vector<Stretch> along(const LineDirection& direction, int row, int begin, int end, int reach) const;

 private:
    void joinCuts(std::vector<std::size_t> cells);

    const ClassifiedGrid& m_grid;
    std::vector<int> m_face;
    int m_count = 0;
};
}  // namespace gr2to
