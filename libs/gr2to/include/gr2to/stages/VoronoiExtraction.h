#pragma once

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/VoronoiGraph.h"

namespace gr2to
{
struct TVoronoiOptions : OptionTable
{
    double min_separation = 0.5;

    std::string section() const override { return "voronoi"; }
    std::vector<OptionField> fields() override;
};

/** Third stage: traces the generalised Voronoi diagram of the free space, one cell wide.
 *
 * The diagram passes between obstacles that are at least `min_separation` apart, and wherever the free space
 * needs it to stay connected as it is: it has the same components and holes. Source: Gr2To paper, section 4,
 * third stage; Lau et al., IROS 2010 (cells next to which the nearest obstacle jumps).
 */
class VoronoiExtractor
{
 public:
    /** \throws std::invalid_argument  an option is out of range */
    explicit VoronoiExtractor(TVoronoiOptions options);

    /** Measures the distance map and, in the same pass, the cells on which the diagram must pass.
     * \param distances  receives the distance map
     * \return separating cells for trace()
     */
    std::vector<Cell> measure(const ClassifiedGrid& grid, Obstacles obstacles, DistanceMap& distances) const;

    /** Thins the free space to the diagram and follows its curves. Cost: linear in the number of cells. */
    VoronoiGraph trace(const ClassifiedGrid& grid, const DistanceMap& distances,
                       const std::vector<Cell>& separating) const;

 private:
    TVoronoiOptions m_options;
};
}  // namespace gr2to
