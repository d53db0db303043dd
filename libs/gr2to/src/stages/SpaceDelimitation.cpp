#include "gr2to/stages/SpaceDelimitation.h"

#include <algorithm>
#include <cmath>

#include "gr2to/base/errors.h"
#include "gr2to/grid/Partition.h"
#include "gr2to/topology/CorridorMerging.h"
#include "gr2to/topology/DoorwayMaker.h"
#include "gr2to/topology/Octagon.h"
#include "gr2to/topology/PlaceOutlines.h"
#include "gr2to/topology/WallMaker.h"

namespace gr2to
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

constexpr double kSteps_cells = 1.5;  // as far apart as the corners of a digital line's steps may be

/** Circles that were merged to one place, and what the map says of it. */
struct PlaceDraft
{
    std::vector<std::size_t> circles;  //!< the largest first
    PlaceId id = 0;
};

/** Fills an augmented map from the topology that the fourth stage found. */
class MapMaker
{
 public:
    MapMaker(const ClassifiedGrid& grid, const DistanceMap& distances, const VoronoiGraph& voronoi,
             const PlaceGraph& graph, const HeightMap& heights, const TDelimitationOptions& options)
        : m_grid(grid),
          m_heights(heights),
          m_voronoi(voronoi),
          m_graph(graph),
          m_options(options),
          m_closedGrid(grid),
          m_grower(m_closedGrid, distances, widestDoor_cells(graph)),
          m_walls(m_closedGrid, heights, options.real_wall_ratio),
          m_neighbours(graph.circles.size())
    {
        for (const ValidatedDoor& door : graph.doors)
            for (const Cell c : door.line) {
                m_borders.push_back(c);
                m_closedGrid.set(c, CellState::Occupied);
            }
    }

    DelimitedSpace make()
    {
        for (const PlaceLink& link : m_graph.links) {
            m_neighbours[link.from].push_back(m_graph.circles[link.to]);
            m_neighbours[link.to].push_back(m_graph.circles[link.from]);
        }
        draftPlaces();
        partitionCells();
        if (m_options.outline_tolerance > 0)
            m_outlines = outlinePlaces(m_result.places, m_drafts.size(), tolerance_cells());
        m_result.map.resolution_m = m_grid.resolution_m();
        for (const PlaceDraft& draft : m_drafts) m_result.map.addPlace(describe(draft));
        addConnections();
        return std::move(m_result);
    }

 private:
    void draftPlaces()
    {
        std::vector<std::size_t> groupOf(m_graph.circles.size());
        for (std::size_t c = 0; c < groupOf.size(); ++c) groupOf[c] = c;
        if (m_graph.regions.ids.empty())
            groupOf = mergeCorridors(m_graph, m_options.corridor_radius_tolerance,
                                     m_options.corridor_angle_tolerance * kPi / 180);
        std::vector<std::vector<std::size_t>> members(m_graph.circles.size());
        for (std::size_t c = 0; c < groupOf.size(); ++c) members[groupOf[c]].push_back(c);
        for (auto& circles : members) {
            if (circles.empty()) continue;
            std::stable_sort(circles.begin(), circles.end(), [&](std::size_t a, std::size_t b) {
                return m_graph.circles[a].radius_cells > m_graph.circles[b].radius_cells;
            });
            m_drafts.push_back({circles, 0});
        }
        if (m_drafts.size() >= 0xFFFF)
            throw OutputError("the map has " + std::to_string(m_drafts.size()) +
                              " places; at most 65534 can be numbered: cut the map");
        // Circles are in raster order: sorted by the index of their largest circle, so are the places.
        std::sort(m_drafts.begin(), m_drafts.end(), [](const PlaceDraft& a, const PlaceDraft& b) {
            return a.circles.front() < b.circles.front();
        });
        m_idOfCircle.resize(m_graph.circles.size());
        for (std::size_t k = 0; k < m_drafts.size(); ++k) {
            m_drafts[k].id = static_cast<PlaceId>(k + 1);
            for (const std::size_t c : m_drafts[k].circles) m_idOfCircle[c] = m_drafts[k].id;
            if (m_drafts[k].circles.size() > 1) m_result.mergedCircles += m_drafts[k].circles.size();
        }
    }

    void partitionCells()
    {
        m_result.places = m_graph.regions.ids.empty() ? alongDiagram() : fromRegions();
        countCells();
    }

    PlaceImage fromRegions() const
    {
        PlaceImage places = m_graph.regions;
        for (PlaceId& id : places.ids)
            if (id != 0) id = m_idOfCircle[static_cast<std::size_t>(id) - 1];
        fillUnlabelled(m_grid, places);
        return places;
    }

    PlaceImage alongDiagram()
    {
        std::vector<PlaceId> placeOfCell(m_voronoi.cells.size(), 0);
        for (std::size_t k = 0; k < placeOfCell.size(); ++k)
            if (const int circle = m_graph.circleOfCell[k]; circle >= 0)
                placeOfCell[k] = m_idOfCircle[static_cast<std::size_t>(circle)];
        for (const PlaceBorder& border : m_graph.borders)
            if (m_idOfCircle[border.from] != m_idOfCircle[border.to])
                m_borders.insert(m_borders.end(), border.line.begin(), border.line.end());
        return partition(m_grid, m_voronoi, placeOfCell, m_borders);
    }

    void countCells()
    {
        m_cellsOfPlace.assign(m_drafts.size() + 1, 0);
        const std::vector<PlaceId>& ids = m_result.places.ids;
        for (auto begin = ids.begin(); begin != ids.end();) {
            const auto end = std::find_if(begin, ids.end(), [&](PlaceId id) { return id != *begin; });
            m_cellsOfPlace[*begin] += static_cast<std::size_t>(end - begin);
            begin = end;
        }
    }

    Place describe(const PlaceDraft& draft)
    {
        Place place;
        place.id = draft.id;
        const double cellArea = m_grid.resolution_m() * m_grid.resolution_m();
        place.area_m2 = static_cast<double>(m_cellsOfPlace[draft.id]) * cellArea;
        place.kind =
            draft.circles.size() > 1 || isElongated(place.area_m2, m_graph.circles[draft.circles.front()])
                ? PlaceKind::Corridor
                : PlaceKind::Room;
        const Eigen::Vector2d center = m_grid.frame().toMap(m_graph.circles[draft.circles.front()].center);
        place.center = {center.x(), center.y(), m_heights.floor_m};
        const bool traced = !m_outlines.empty() && !m_outlines[draft.id].empty();
        const std::vector<Eigen::Vector2d> outline = traced ? m_outlines[draft.id] : octagonsOf(draft);
        for (const auto& vertex : outline) {
            const Eigen::Vector2d p = m_grid.frame().toMap(vertex.x(), vertex.y());
            place.boundary.emplace_back(p.x(), p.y());
        }
        place.walls = traced ? m_walls.fromRuns(outline, tolerance_cells(), m_result.places, draft.id)
                             : m_walls.fromSides(outline);
        return place;
    }

    /** Whether a strip as wide as the place's largest circle would have to be that much longer to fill its
     * area. */
    bool isElongated(double area_m2, const Circle& largest) const
    {
        const double width_m = 2 * largest.radius_cells * m_grid.resolution_m();
        return m_options.corridor_elongation > 0 &&
               area_m2 >= m_options.corridor_elongation * width_m * width_m;
    }

    double tolerance_cells() const
    {
        return std::max(m_options.outline_tolerance / m_grid.resolution_m(), kSteps_cells);
    }

    /** An octagon, or the hull of several. */
    std::vector<Eigen::Vector2d> octagonsOf(const PlaceDraft& draft) const
    {
        std::vector<Eigen::Vector2d> vertices;
        for (const std::size_t c : draft.circles) {
            const Octagon octagon = m_grower.grow(m_graph.circles[c], m_neighbours[c]);
            vertices.insert(vertices.end(), octagon.begin(), octagon.end());
        }
        return draft.circles.size() > 1 ? convexHull(std::move(vertices)) : vertices;
    }

    void addConnections()
    {
        for (const PlaceLink& link : m_graph.links) {
            Connection connection;
            connection.from = m_idOfCircle[link.from];
            connection.to = m_idOfCircle[link.to];
            if (connection.from == connection.to) continue;
            connection.id = static_cast<std::uint32_t>(m_result.map.graph().edgeCount() + 1);
            connection.doorway =
                link.door >= 0
                    ? doorwayOf(m_graph.doors[static_cast<std::size_t>(link.door)], m_grid, m_heights)
                    : openingOf(link, m_grid, m_heights);
            m_result.map.addConnection(connection);
        }
    }

    const ClassifiedGrid& m_grid;
    const HeightMap& m_heights;
    const VoronoiGraph& m_voronoi;
    const PlaceGraph& m_graph;
    const TDelimitationOptions& m_options;
    ClassifiedGrid m_closedGrid;
    OctagonGrower m_grower;
    WallMaker m_walls;
    std::vector<std::vector<Circle>> m_neighbours;  //!< circles joined to each circle
    std::vector<Cell> m_borders;  //!< cells of closed doors, then of openings between places
    std::vector<PlaceDraft> m_drafts;
    std::vector<PlaceId> m_idOfCircle;
    std::vector<std::size_t> m_cellsOfPlace;
    std::vector<std::vector<Eigen::Vector2d>> m_outlines;  //!< by place id; empty for octagons
    DelimitedSpace m_result;
};
}  // namespace

std::vector<OptionField> TDelimitationOptions::fields()
{
    return {
        {"real_wall_ratio", &real_wall_ratio, "ratio",
         "A side of a place is a real wall when more than this part of it lies on occupied cells.", 0, 1},
        {"corridor_radius_tolerance", &corridor_radius_tolerance, "ratio",
         "Largest relative difference of circle radii that count as the same when corridors are merged.", 0,
         1},
        {"corridor_angle_tolerance", &corridor_angle_tolerance, "deg",
         "Largest turn among three circles in a row that count as collinear when corridors are merged.", 0,
         90},
        {"corridor_elongation", &corridor_elongation, "ratio",
         "A place is a corridor when its area is at least this many squares of its largest circle's "
         "diameter; 0: only merged circles are.",
         0, 100},
        {"outline_tolerance", &outline_tolerance, "m",
         "Largest distance of a place's cells from the sides of its outline, at least a cell and a half; 0: "
         "outlines are octagons.",
         0, 1}};
}

SpaceDelimiter::SpaceDelimiter(TDelimitationOptions options) : m_options(std::move(options))
{
    m_options.check();
}

DelimitedSpace SpaceDelimiter::delimit(const ClassifiedGrid& grid, const DistanceMap& distances,
                                       const VoronoiGraph& voronoi, const PlaceGraph& graph,
                                       const HeightMap& heights) const
{
    return MapMaker(grid, distances, voronoi, graph, heights, m_options).make();
}
}  // namespace gr2to
