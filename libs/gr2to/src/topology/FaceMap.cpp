#include "gr2to/topology/FaceMap.h"

#include <algorithm>

#include "gr2to/grid/Runs.h"

namespace gr2to
{
FaceMap::FaceMap(const ClassifiedGrid& grid, const std::vector<CandidateCut>& cuts)
    : m_grid(grid), m_face(grid.size(), 0)
{
    std::vector<std::uint8_t> isCut(grid.size(), 0);
    std::vector<std::size_t> cutCells;
    for (const CandidateCut& cut : cuts)
        for (const Cell c : cut.cells)
            if (std::uint8_t& mark = isCut[grid.index(c)]; mark == 0) {
                mark = 1;
                cutCells.push_back(grid.index(c));
            }
    Runs runs(grid.width(), grid.height(), Runs::Connectivity::Sides,
              [&](std::size_t i) { return grid[i] == CellState::Free && isCut[i] == 0; });
    std::vector<int> numberOfRoot(runs.runs().size(), 0);
    for (std::size_t r = 0; r < numberOfRoot.size(); ++r) {
        const std::size_t root = runs.root(r);
        if (root == r) numberOfRoot[r] = ++m_count;
        std::fill(m_face.begin() + runs.runs()[r].begin, m_face.begin() + runs.runs()[r].end,
                  numberOfRoot[root]);
    }
    std::sort(cutCells.begin(), cutCells.end());
    joinCuts(std::move(cutCells));
}

/** Wave by wave; a spot of cut cells that touches no face becomes one. */
void FaceMap::joinCuts(std::vector<std::size_t> cells)
{
    const auto faceBeside = [&](std::size_t i) {
        const Cell c = m_grid.cell(i);
        for (const Cell n : {Cell{c.x + 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x - 1, c.y}, Cell{c.x, c.y - 1}})
            if (m_grid.contains(n) && m_face[m_grid.index(n)] != 0) return m_face[m_grid.index(n)];
        return 0;
    };
    while (!cells.empty()) {
        std::vector<std::pair<std::size_t, int>> joins;
        std::vector<std::size_t> later;
        for (const std::size_t i : cells)
            if (const int face = faceBeside(i); face != 0)
                joins.emplace_back(i, face);
            else
                later.push_back(i);
        if (joins.empty()) joins.emplace_back(later.front(), ++m_count);
        for (const auto& [i, face] : joins) m_face[i] = face;
        later.erase(std::remove_if(later.begin(), later.end(), [&](std::size_t i) { return m_face[i] != 0; }),
                    later.end());
        cells.swap(later);
    }
}

std::vector<FaceMap::Piece> FaceMap::piecesOf(const CandidateCut& cut) const
{
    const LineDirection& d = cut.direction;
    const auto [first, last] = std::minmax({d.step(cut.cells.front()), d.step(cut.cells.back())});
    const auto faceBeside = [&](int step, int sense) { return at(d, step, cut.row + sense); };
    std::vector<Piece> pieces;
    for (int t = first; t <= last; ++t) {
        const int below = faceBeside(t, -1), above = faceBeside(t, 1);
        if (below == 0 || above == 0 || below == above) continue;
        if (!pieces.empty() && pieces.back().end == t && pieces.back().below == below &&
            pieces.back().above == above)
            pieces.back().end = t + 1;
        else
            pieces.push_back({t, t + 1, below, above});
    }
    return pieces;
}

std::vector<FaceMap::Stretch> FaceMap::along(const LineDirection& direction, int row, int begin, int end,
                                             int reach) const
{
    std::vector<Stretch> stretches;
    for (int t = begin - 1; begin - t <= reach; --t) {
        const int face = at(direction, t, row);
        if (face == 0) break;
        if (!stretches.empty() && stretches.back().face == face)
            stretches.back().begin = t;
        else
            stretches.push_back({t, t + 1, face});
    }
    std::reverse(stretches.begin(), stretches.end());
    for (int t = begin; t < end + reach; ++t) {
        const int face = at(direction, t, row);
        if (t >= end && face == 0) break;
        if (!stretches.empty() && stretches.back().face == face)
            stretches.back().end = t + 1;
        else
            stretches.push_back({t, t + 1, face});
    }
    return stretches;
}
}  // namespace gr2to
