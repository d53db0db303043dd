#pragma once

#include <optional>
#include <string>

#include "gr2to/compare/GraphScores.h"
#include "gr2to/compare/RoomScores.h"

namespace gr2to
{
/** How a topological map fares against an annotated one. */
struct ComparisonScores
{
    BormannScores bormann;
    MaorisScores maoris;
    MatchedScores matched;
    std::optional<DoorScores> doors;  //!< absent when the reference has no interfaces
    std::optional<EdgeScores> edges;  //!< absent when the reference has no interfaces
    bool doorsReliable = true;        //!< as the reference says
};

/** Scores a map of places against an annotated reference.
 *
 * An answer without places, or a reference without rooms, scores 0 throughout.
 * \param places     the answer's place of every cell
 * \param graph      the answer's doors and edges
 * \param reference  rooms, and interfaces when annotated; of the size of `places`
 * \param grid       the grid that the answer was made from, where it is known: scores on free cells need it
 * \throws InputError  the images, or the grid, differ in size; or the reference has interfaces but no
 * resolution Cost: one pass over the cells for each of at most two tables, and the pairing of places and
 * rooms (assignRows).
 */
ComparisonScores compareMaps(const PlaceImage& places, const PredictedGraph& graph,
                             const ReferenceAnnotation& reference, const ClassifiedGrid* grid = nullptr);

/** A table for people: a line a figure, with what it says. */
std::string toText(const ComparisonScores& scores);

/** One JSON object with an object for each group of scores; what is not available is left out. */
std::string toJson(const ComparisonScores& scores);
}  // namespace gr2to
