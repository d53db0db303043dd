#include "gr2to/compare/Comparison.h"

#include <cmath>

#include "gr2to/base/errors.h"

namespace gr2to
{
ComparisonScores compareMaps(const PlaceImage& places, const PredictedGraph& graph,
                             const ReferenceAnnotation& reference, const ClassifiedGrid* grid)
{
    if (reference.interfaces && !(std::isfinite(reference.resolution_m) && reference.resolution_m > 0.0))
        throw InputError("the reference's resolution is " + std::to_string(reference.resolution_m) +
                         " m; doors are compared in metres and need a positive number");
    const ContingencyTable all(places, reference.labels);
    std::optional<ContingencyTable> onFree;
    if (grid) onFree.emplace(places, reference.labels, grid);
    ComparisonScores scores;
    scores.bormann = bormannScores(all, onFree ? &*onFree : nullptr);
    scores.maoris = maorisScores(all);
    scores.matched = matchedScores(onFree ? *onFree : all, onFree.has_value());
    scores.doorsReliable = reference.doorsReliable;
    if (reference.interfaces) {
        scores.doors = doorScores(graph.doors, *reference.interfaces, reference.resolution_m);
        scores.edges = edgeScores(graph.edges, *reference.interfaces, all);
    }
    return scores;
}
}  // namespace gr2to
