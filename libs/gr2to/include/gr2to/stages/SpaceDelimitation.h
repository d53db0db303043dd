#pragma once

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/HeightMap.h"
#include "gr2to/grid/PlaceImage.h"
#include "gr2to/grid/VoronoiGraph.h"
#include "gr2to/topology/PlaceGraph.h"
#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
struct TDelimitationOptions : OptionTable
{
    double real_wall_ratio = 0.8;
    double corridor_radius_tolerance = 0.2;
    double corridor_angle_tolerance = 15;
    double corridor_elongation = 4;
    double outline_tolerance = 0.075;

    std::string section() const override { return "delimitation"; }
    std::vector<OptionField> fields() override;
};

/** What the fifth stage makes. */
struct DelimitedSpace
{
    PlaceImage places;              //!< every free cell with its place
    TopologicalMap map;             //!< the augmented map; its frame and source are left to the caller
    std::size_t mergedCircles = 0;  //!< circles that corridors were merged from
};

/** Fifth stage: closes the doors, gives every place its walls, merges corridors, fills the augmented map.
 *
 * Each circle gets an octagon whose vertices move to the farthest occupied cell seen in their beam, at most
 * to the distance of eq. (10); an octagon's side on occupied cells is a real wall, else a virtual one. Three
 * or more circles of the same radius in a row are one corridor, bounded by the convex hull of their octagons.
 * With an outline tolerance the outlines follow the places' cells instead, neighbours share their vertices,
 * and walls are their straight runs; see outlinePlaces(). Source: Gr2To paper, section 4, fifth stage.
 */
class SpaceDelimiter
{
 public:
    /** \throws std::invalid_argument  an option is out of range */
    explicit SpaceDelimiter(TDelimitationOptions options);

    /** \param heights  of a 3D map: walls are as high as their columns, doors as their lintels, and z is that
     * of the floor or, of what has a height, of its middle \throws OutputError  there are more places than
     * PlaceId can number */
    DelimitedSpace delimit(const ClassifiedGrid& grid, const DistanceMap& distances,
                           const VoronoiGraph& voronoi, const PlaceGraph& graph,
                           const HeightMap& heights = {}) const;

 private:
    TDelimitationOptions m_options;
};
}  // namespace gr2to
