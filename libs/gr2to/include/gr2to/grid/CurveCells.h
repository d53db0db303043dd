#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "gr2to/grid/Circles.h"
#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/VoronoiGraph.h"

namespace gr2to
{
/** The Voronoi diagram's cells with their side neighbours; a cell is named by its index in
 * VoronoiGraph::cells. */
class CurveCells
{
 public:
    explicit CurveCells(const VoronoiGraph& voronoi);

    static constexpr int none() { return -1; }
    std::size_t size() const { return m_voronoi.cells.size(); }
    Cell cell(std::size_t i) const
    {
        const auto width = static_cast<std::uint32_t>(m_voronoi.width);
        return {static_cast<int>(m_voronoi.cells[i] % width), static_cast<int>(m_voronoi.cells[i] / width)};
    }
    /** Right, upper, left and lower neighbour, none() where there is none. */
    const std::array<int, 4>& neighbours(std::size_t i) const { return m_neighbours[i]; }
    /** Index of a cell of the diagram, none() for others. */
    int find(Cell c) const;

    /** Numbers the parts of the diagram that are connected without the blocked cells, from 0; -1 on blocked
     * cells. */
    std::vector<int> parts(const std::vector<bool>& blocked, int* count) const;

    /** For each cell the circle that reaches it first along the diagram, none() where none does.
     *
     * Circles grow at the same speed from their rims: a cell's cost is the length of the way to it less the
     * radius.
     * \param circles  centred on cells of the diagram
     * \param partOf  as from parts(); no circle leaves its part, nor are the cells of -1 entered
     */
    std::vector<int> growCircles(const std::vector<Circle>& circles, const std::vector<int>& partOf) const;

    /** For each cell the circle whose way to it stays widest, none() where none reaches it.
     *
     * Circles flood the diagram from wide to narrow, so that two of them meet at the narrowest cell between
     * them. Parameters as for growCircles().
     */
    std::vector<int> floodCircles(const std::vector<Circle>& circles, const std::vector<int>& partOf,
                                  const DistanceMap& distances) const;

 private:
    struct Start
    {
        std::size_t cell;
        int circle;
    };
    /** The circles' centres, part by part, in the circles' order inside each. */
    std::vector<Start> startsByPart(const std::vector<Circle>& circles, const std::vector<int>& partOf) const;
    /** Grows the circles of one part after the other: small parts stay in the processor's cache. */
    template <class GrowPart>
    std::vector<int> growByPart(const std::vector<Circle>& circles, const std::vector<int>& partOf,
                                const GrowPart& growPart) const;

    const VoronoiGraph& m_voronoi;
    std::vector<std::array<int, 4>> m_neighbours;
};
}  // namespace gr2to
