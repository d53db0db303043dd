#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gr2to/grid/Padded.h"

namespace gr2to
{
/** An end or a junction of the Voronoi diagram, or one cell of a cycle that has neither. */
struct VoronoiNode
{
    Cell cell;
    int degree = 0;  //!< edge ends that meet here; 1 at a dead end, 0 for a lone cell
};

/** A run of cells between two nodes; both nodes' cells are included, consecutive cells share a side. */
struct VoronoiEdge
{
    std::size_t from = 0;  //!< index of the node at cells.front()
    std::size_t to = 0;    //!< index of the node at cells.back(); equal to `from` on a cycle
    std::vector<Cell> cells;
};

/** Where clearance is least along a stretch of the Voronoi diagram (Thrun; the paper's [14]). */
struct CriticalPoint
{
    Cell cell;
    double clearance_cells = 0.0;  //!< distance to the nearest obstacle's cell centre [cells]
};

/** The generalised Voronoi diagram of the free space, one cell wide, as cells and as a graph.
 *
 * Cells are connected over their sides (4-connected): a wall one cell thick that runs diagonally separates.
 * The diagram has one component for each component of the free space and one cycle for each hole in it.
 */
struct VoronoiGraph
{
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> cells;  //!< indices (y * width + x) of the diagram's cells, ascending
    std::vector<VoronoiNode> nodes;    //!< in raster order
    std::vector<VoronoiEdge> edges;  //!< in order of their first node, then of their direction of leaving it
};

/** Follows thinned curves (as from thin()) from node to node. Cost: linear in the number of cells of the
 * mask. */
VoronoiGraph traceGraph(Mask curves);
}  // namespace gr2to
