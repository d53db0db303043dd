#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "gr2to/grid/Circles.h"

namespace gr2to
{
/** Eight vertices around a circle, counter-clockwise from the right, in continuous grid coordinates [cells].
 */
using Octagon = std::array<Eigen::Vector2d, 8>;

/** Widens circles' octagons to the farthest occupied cells that are seen from their centres. */
class OctagonGrower
{
 public:
    /** \param closedDoors  grid in which the doors are drawn as occupied cells
     *  \param distances  of the grid without those doors, to occupied cells at least; where they do not count
     * unknown cells, a ray may pass over some \param widestDoor_cells  length of the longest closed door
     */
    OctagonGrower(const ClassifiedGrid& closedDoors, const DistanceMap& distances, double widestDoor_cells);

    /** Moves each vertex to the farthest occupied cell that is seen from the centre inside its beam.
     *
     * A vertex goes no farther than r_i / (r_i + r_j) times the distance to the closest neighbour j inside
     * its beam, eq. (10). Where no occupied cell is seen, it goes as far as the free space is seen, under the
     * same limit. \param neighbours  circles joined to this one along the Voronoi diagram
     */
    Octagon grow(const Circle& circle, const std::vector<Circle>& neighbours) const;

 private:
    struct Ray
    {
        double length = 0;  //!< to the last free cell, or to the occupied one [cells]
        bool hits = false;  //!< an occupied cell, not the unknown
    };
    Ray castRay(Cell from, const Eigen::Vector2d& direction) const;
    Eigen::Vector2d growVertex(const Circle& circle, double axis_rad, double limit) const;

    const ClassifiedGrid& m_grid;
    const DistanceMap& m_distances;
    double m_squaredHalfDoor;
};

/** Convex hull, counter-clockwise, without collinear vertices. Source: Andrew's monotone chain. */
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);
}  // namespace gr2to
