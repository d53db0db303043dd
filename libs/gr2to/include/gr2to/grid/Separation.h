#pragma once

#include <cstdint>
#include <vector>

#include "gr2to/grid/DistanceMap.h"

namespace gr2to
{
/** Finds the cells on which the Voronoi diagram must pass: next to them the nearest obstacle jumps by a
 * separation.
 *
 * Of two neighbouring cells the one with the larger clearance is taken, of equals the first in raster order.
 * It is fed row by row, while the distances are measured, so that the nearest obstacles need not be kept.
 */
class SeparationFinder
{
 public:
    /** \param minSeparation_cells  of the two nearest obstacles */
    SeparationFinder(const ClassifiedGrid& grid, double minSeparation_cells);

    /** Takes the next row, from the bottom. \param squared  row of the distance map \param nearest  its
     * obstacles */
    void addRow(int y, const std::int32_t* squared, const std::uint32_t* nearest);
    /** The cells, in raster order; they are two thick at most, see thin(). */
    std::vector<Cell> take();

 private:
    void finishRow(int y);

    const ClassifiedGrid& m_grid;
    std::int32_t m_minSquared;
    std::vector<std::uint32_t> m_nearestBelow;
    std::vector<std::int32_t> m_squaredBelow;
    std::vector<std::uint8_t> m_below, m_current;  //!< marks of the last row and of this one
    std::vector<std::uint8_t> m_jumps;             //!< where the nearest obstacle jumps
    std::vector<Cell> m_cells;
};

/** Measures the distances and finds the separating cells in one go. */
std::vector<Cell> measureSeparation(const ClassifiedGrid& grid, Obstacles obstacles,
                                    double minSeparation_cells, DistanceMap& distances);
}  // namespace gr2to
