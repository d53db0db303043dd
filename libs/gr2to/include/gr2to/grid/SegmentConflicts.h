#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace gr2to
{
/** A straight side between two vertices that others may share. */
struct Segment
{
    Eigen::Vector2d from, to;        //!< [cells]
    std::size_t start = 0, end = 0;  //!< numbers of its vertices: equal where segments share one
};

/** Which segments come closer to others than a margin, other than at a vertex that they share.
 *
 * Segments that share a vertex conflict when the far end of one is near the other, so that a polygon
 * of segments without conflict does not fold back on itself.
 * \param margin  at least 0 [cells] \return for each segment whether it is in a conflict
 * Cost: linear in the segments' summed length when they are spread evenly.
 */
std::vector<bool> findConflicts(const std::vector<Segment>& segments, double margin);
}  // namespace gr2to
