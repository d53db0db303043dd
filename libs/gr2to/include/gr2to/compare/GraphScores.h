#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "gr2to/compare/ContingencyTable.h"
#include "gr2to/topology/ReferenceAnnotation.h"
#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
/** A door as an answer gives it, in the image coordinates of ReferenceAnnotation. */
struct PredictedDoor
{
    Eigen::Vector2d mid_px = Eigen::Vector2d::Zero();
    double width_m = 0;  //!< 0 when it was not measured
};

/** What a topological map says about passages. */
struct PredictedGraph
{
    std::vector<PredictedDoor> doors;
    std::vector<std::pair<PlaceId, PlaceId>> edges;  //!< connected places, in any order, repeated or not
};

/** Doors and edges of a map: its real doorways, and all of its connections.
 *
 * \param map     positions in the map frame [m]
 * \param frame   where the map's grid lies; its resolution is that of the grid
 * \param height  rows of that grid: image coordinates count from the top
 */
PredictedGraph predictedGraph(const TopologicalMap& map, const GridFrame& frame, int height);

/** How well doors are found; shares in [0, 1], 1 is best.
 *
 * Doors are paired one to one with annotated doors no farther than 0.75 m, as near as possible in sum.
 *     precision = pairs / predicted,  recall = pairs / annotated,  f1 = their harmonic mean
 */
struct DoorScores
{
    double precision = 0;
    double recall = 0;
    double f1 = 0;
    /** As precision, but an unpaired door within 0.75 m (or half the width) of an annotated opening or slit
     * is not counted. */
    double precisionLenient = 0;
    int annotated = 0;
    int predicted = 0;
    std::optional<double> widthError_m;  //!< mean absolute error over the pairs; absent without any
};

/** How well the rooms' neighbourhood is found; shares in [0, 1], 1 is best.
 *
 * Each segment stands for the room that it overlaps most (the one of the smaller label on a tie), so a cut
 * room does not count against the edges. Compared are sets of pairs of rooms: those joined by an annotated
 * door or opening against those of the edges; pairs joined by nothing but slits are left out.
 */
struct EdgeScores
{
    double precision = 0;
    double recall = 0;
    double f1 = 0;
    int annotated = 0;  //!< pairs of rooms
    int predicted = 0;  //!< pairs of rooms, or of a room and a segment that overlaps none
    int internal = 0;   //!< pairs of segments joined inside one room
};

/** \param resolution_m  side of a pixel [m] */
DoorScores doorScores(const std::vector<PredictedDoor>& doors,
                      const std::vector<ReferenceInterface>& interfaces, double resolution_m);

/** Edges to places that the image does not show are ignored. \param all  overlaps of the whole images */
EdgeScores edgeScores(const std::vector<std::pair<PlaceId, PlaceId>>& edges,
                      const std::vector<ReferenceInterface>& interfaces, const ContingencyTable& all);
}  // namespace gr2to
