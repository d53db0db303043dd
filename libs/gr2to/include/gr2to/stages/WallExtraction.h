#pragma once

#include <vector>

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/WallSegments.h"

namespace gr2to
{
struct TWallOptions : OptionTable
{
    double window = 0.15;
    double min_length = 0.5;
    double max_gap = 0.3;
    double max_angle = 15;

    std::string section() const override { return "wall"; }
    std::vector<OptionField> fields() override;
};

/** Straight walls and the directions that they run in. */
struct WallLines
{
    std::vector<LineDirection> directions;  //!< the strongest first
    std::vector<WallSegment> segments;      //!< by direction

    /** Forgets the walls that are no longer occupied in a grid. */
    void dropRemoved(const ClassifiedGrid& grid);
};

/** Part of the first stage: finds straight walls along the few directions in which most of a building runs.
 *
 * Source: structure tensor, Bigun and Granlund, ICCV 1987; dominant directions as in Luperto et al. (ROSE2).
 */
class WallExtractor
{
 public:
    /** \throws std::invalid_argument  an option is out of range */
    explicit WallExtractor(TWallOptions options);

    /** Cost: linear in the number of cells. */
    WallLines extract(const ClassifiedGrid& grid) const;

 private:
    TWallOptions m_options;
};
}  // namespace gr2to
