#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/HeightMap.h"
#include "gr2to/grid/PlaceImage.h"
#include "gr2to/topology/types.h"

namespace gr2to
{
/** Makes the sides of outlines to walls, numbered from 1 in the order in which they are made.
 *
 * A side is real when more than a part of it has an occupied cell within a cell, else virtual. The line of a
 * real wall is fitted to these cells, see fitLine(), that of a virtual one goes through its ends.
 */
class WallMaker
{
 public:
    /** \param closedDoors  the grid with closed doors as occupied cells; it and the heights live on as long
     * as this \param realRatio  part of a real side that is occupied */
    WallMaker(const ClassifiedGrid& closedDoors, const HeightMap& heights, double realRatio)
        : m_grid(closedDoors), m_heights(heights), m_realRatio(realRatio)
    {
    }

    /** A wall for each side of at least half a cell. \param outline  counter-clockwise, in continuous grid
     * coordinates [cells] */
    std::vector<Wall> fromSides(const std::vector<Eigen::Vector2d>& outline);

    /** A wall for each run of sides that are all real or all virtual and straight but for a tolerance.
     *
     * A wall whose fitted line runs askew to its side, as where the side is as short as the wall is thick,
     * has the line through the side's ends. A virtual one with the place on both sides, as along a slit to a
     * hole, delimits nothing and is left out. \param outline  a simple polygon \param tolerance_cells largest
     * distance of a vertex from the line between the run's ends \param places  of the cells \param id  the
     * outline's place
     */
    std::vector<Wall> fromRuns(const std::vector<Eigen::Vector2d>& outline, double tolerance_cells,
                               const PlaceImage& places, PlaceId id);

 private:
    /** A straight piece of an outline with the occupied cells beside it. */
    struct Side
    {
        Eigen::Vector2d from, to;
        std::vector<Cell> support;  //!< in raster order
        bool real = false;
    };

    Side sideBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
    Wall wallAlong(const Side& side, double leastCosine);

    const ClassifiedGrid& m_grid;
    const HeightMap& m_heights;
    double m_realRatio;
    std::uint32_t m_count = 0;
};
}  // namespace gr2to
