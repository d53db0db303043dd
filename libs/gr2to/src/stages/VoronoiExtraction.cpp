#include "gr2to/stages/VoronoiExtraction.h"

#include "gr2to/grid/Thinning.h"

namespace gr2to
{
std::vector<OptionField> TVoronoiOptions::fields()
{
    return {
        {"min_separation", &min_separation, "m",
         "Obstacles closer together than this are one obstacle to the diagram: no branch runs between them.",
         0.05, 10}};
}

VoronoiExtractor::VoronoiExtractor(TVoronoiOptions options) : m_options(std::move(options))
{
    m_options.check();
}

VoronoiGraph VoronoiExtractor::extract(const ClassifiedGrid& grid, const DistanceMap& distances,
                                       const NearestObstacles& nearest) const
{
    const double separation = m_options.min_separation / grid.resolution_m();
    return traceGraph(thin(grid, distances, separatingCells(grid, distances, nearest, separation)));
}
}  // namespace gr2to
