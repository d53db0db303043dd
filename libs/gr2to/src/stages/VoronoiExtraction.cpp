#include "gr2to/stages/VoronoiExtraction.h"

#include "gr2to/grid/Separation.h"
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

std::vector<Cell> VoronoiExtractor::measure(const ClassifiedGrid& grid, Obstacles obstacles,
                                            DistanceMap& distances) const
{
    return measureSeparation(grid, obstacles, m_options.min_separation / grid.resolution_m(), distances);
}

VoronoiGraph VoronoiExtractor::trace(const ClassifiedGrid& grid, const DistanceMap& distances,
                                     const std::vector<Cell>& separating) const
{
    return traceGraph(thin(grid, distances, separating));
}
}  // namespace gr2to
