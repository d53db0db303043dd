#pragma once

#include <array>
#include <functional>
#include <vector>

#include "gr2to/topology/FaceMap.h"

namespace gr2to
{
/** How far beside a cut the width of the space is looked at. */
struct OpennessRules
{
    double step_cells = 3;     //!< distance of the first walk from the cut, and between walks
    double depth_cells = 36;   //!< distance of the last walk
    double reach_cells = 400;  //!< farthest end of a walk beyond the cut's ends
};

/** What the openness of borders on one cut is measured with: the faces along lines parallel to it, on both
 * sides.
 *
 * A border is open towards a side when the space on that side is not much wider *along the cut* than the
 * border is long. That is so within a room however shallow, and not at a door however small the room behind.
 */
class CutSurroundings
{
 public:
    CutSurroundings(const FaceMap& faces, const CandidateCut& cut, const OpennessRules& rules);

    /** Longest walk parallel to a stretch of the cut, beside it and inside a region [steps].
     * \param above  side of the cut  \param isInside  whether a face belongs to the region */
    int longestWalk(bool above, int begin, int end, const std::function<bool(int)>& isInside) const;

 private:
    struct Line
    {
        int shift = 0;  //!< steps by which feet of perpendiculars move
        std::vector<FaceMap::Stretch> stretches;
    };
    std::array<std::vector<Line>, 2> m_lines;  //!< below and above
};
}  // namespace gr2to
