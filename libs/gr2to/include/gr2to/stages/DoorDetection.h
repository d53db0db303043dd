#pragma once

#include <vector>

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/DistanceMap.h"
#include "gr2to/topology/PlaceGraph.h"

namespace gr2to
{
struct TDoorOptions : OptionTable
{
    double min_width = 0.5;
    double max_width = 1.5;

    std::string section() const override { return "door"; }
    std::vector<OptionField> fields() override;

 protected:
    void checkRules() const override;
};

/** Second stage: finds where doors are likely, eq. (8).
 *
 * A cell is a likely door when its clearance lies between half the narrowest and half the widest door and two
 * of eight samples on a circle around it, neither next to each other nor next but one, are farther from
 * obstacles than it is. Likely cells closer together than half the narrowest door are one candidate.
 */
class DoorDetector
{
 public:
    /** \throws std::invalid_argument  an option is out of range */
    explicit DoorDetector(TDoorOptions options);

    /** \return candidates in raster order of their first cell; empty when there are none
     * Cost: one pass over the free cells. Source: Gr2To paper, section 4, second stage.
     */
    std::vector<DoorCandidate> detect(const ClassifiedGrid& grid, const DistanceMap& distances) const;

 private:
    TDoorOptions m_options;
};
}  // namespace gr2to
