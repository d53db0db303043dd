#pragma once

#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "gr2to/grid/CurveCells.h"
#include "gr2to/grid/DistanceMap.h"
#include "gr2to/topology/PlaceGraph.h"

namespace gr2to
{
/** Where two circles meet along the Voronoi diagram when no door parts them. */
enum class MeetingRule : std::uint8_t
{
    HalfWay,   //!< at equal distances from their rims, as eq. (10) limits the octagons
    Narrowest  //!< at the narrowest cell between them
};

/** Parts the Voronoi diagram at its doors and among circles, until every door parts two places.
 *
 * Circles are those of the diagram's cells, thinned out by overlap and eq. (9); those inside a doorway are
 * left out. Every part of the diagram between doors that is wide enough has one. A door that does not part
 * two places is dropped.
 */
class DiagramDivider
{
 public:
    /** \param obstacles  what the distances were measured to  \param minRadius_cells  of a circle that makes
     * a place */
    DiagramDivider(std::vector<ValidatedDoor> doors, const VoronoiGraph& voronoi, const ClassifiedGrid& grid,
                   Obstacles obstacles, const DistanceMap& distances, double minRadius_cells,
                   MeetingRule meeting);

    PlaceGraph divide();

 private:
    std::vector<int> depthInLevel() const;
    std::vector<Circle> circlesBySize() const;
    std::vector<Circle> findCircles() const;
    void blockDoors();
    std::vector<int> addMissingCircles();
    std::set<int> sidesOf(const ValidatedDoor& door) const;
    bool dropDoors(const std::function<bool(const std::set<int>& sides)>& useless);
    void linkAtOpenings();
    void addOpening(int a, int b, Cell at);
    void addBorder(int a, int b, Cell at);
    void linkAtDoors();
    void sortLinks();

    CurveCells m_curves;
    const ClassifiedGrid& m_grid;
    Obstacles m_obstacles;
    const DistanceMap& m_distances;
    double m_minRadius;
    MeetingRule m_meeting;
    std::vector<bool> m_blocked;  //!< cells of the diagram on doors
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> m_linksOf;
    PlaceGraph m_graph;
};
}  // namespace gr2to
