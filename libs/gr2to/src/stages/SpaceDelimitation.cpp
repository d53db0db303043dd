#include "gr2to/stages/SpaceDelimitation.h"

#include <algorithm>
#include <cmath>

#include "gr2to/base/errors.h"
#include "gr2to/grid/Partition.h"
#include "gr2to/topology/CorridorMerging.h"
#include "gr2to/topology/MeasuredHeight.h"
#include "gr2to/topology/Octagon.h"
#include "gr2to/topology/WallFit.h"
#include "gr2to/topology/WallSupport.h"

namespace gr2to
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

mrpt::math::CMatrixDouble33 inSpace(const Eigen::Matrix2d& plane)
{
    mrpt::math::CMatrixDouble33 m;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) m(i, j) = plane(i, j);
    return m;
}

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
        const std::vector<Eigen::Vector2d> outline = outlineOf(draft);
        for (const auto& vertex : outline) {
            const Eigen::Vector2d p = m_grid.frame().toMap(vertex.x(), vertex.y());
            place.boundary.emplace_back(p.x(), p.y());
        }
        for (std::size_t k = 0; k < outline.size(); ++k)
            if (const auto& next = outline[(k + 1) % outline.size()]; (next - outline[k]).norm() >= 0.5)
                place.walls.push_back(wallBetween(outline[k], next));
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

    std::vector<Eigen::Vector2d> outlineOf(const PlaceDraft& draft) const
    {
        std::vector<Eigen::Vector2d> vertices;
        for (const std::size_t c : draft.circles) {
            const Octagon octagon = m_grower.grow(m_graph.circles[c], m_neighbours[c]);
            vertices.insert(vertices.end(), octagon.begin(), octagon.end());
        }
        return draft.circles.size() > 1 ? convexHull(std::move(vertices)) : vertices;
    }

    Wall wallBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
    {
        double covered = 0;
        const std::vector<Cell> cells = wallSupport(m_closedGrid, from, to, &covered);
        std::vector<Eigen::Vector2d> support;
        support.reserve(cells.size());
        for (const Cell c : cells) support.push_back(m_grid.frame().toMap(c));
        Wall wall;
        wall.id = ++m_wallCount;
        wall.real = covered > m_options.real_wall_ratio;
        if (!wall.real || support.size() < 2)
            support = {m_grid.frame().toMap(from.x(), from.y()), m_grid.frame().toMap(to.x(), to.y())};
        const LineFit fit = fitLine(support, m_grid.resolution_m());
        wall.position.mean = {fit.center.x(), fit.center.y(), 0};
        wall.position.covariance = inSpace(fit.centerCovariance);
        const Eigen::Vector2d along = m_grid.frame().directionToMap(to - from);
        Eigen::Vector2d normal(fit.direction.y(), -fit.direction.x());
        if (normal.dot(Eigen::Vector2d(along.y(), -along.x())) < 0)
            normal = -normal;  // outwards: outlines turn left
        wall.normal.mean = {normal.x(), normal.y(), 0};
        wall.normal.covariance = inSpace(fit.normalCovariance);
        wall.size.length_m = wall.real ? fit.length_m : along.norm() * m_grid.resolution_m();
        wall.size.covariance(0, 0) = fit.lengthVariance;
        setHeight(m_heights, wall.real ? wallHeight(cells, m_heights) : std::nullopt, wall.position,
                  wall.size);
        return wall;
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
                link.door >= 0 ? doorway(m_graph.doors[static_cast<std::size_t>(link.door)]) : opening(link);
            m_result.map.addConnection(connection);
        }
    }

    /** A door spans the gap between its jambs; each jamb is a cell whose position is known to the cell's
     * size. */
    Doorway doorway(const ValidatedDoor& door) const
    {
        const LineFit fit = fitLine({m_grid.frame().toMap(door.jambA), m_grid.frame().toMap(door.jambB)},
                                    m_grid.resolution_m());
        Doorway result;
        result.position.mean = {fit.center.x(), fit.center.y(), 0};
        result.position.covariance = inSpace(fit.centerCovariance);
        result.size.length_m = fit.length_m - 2 * m_grid.resolution_m();  // from jamb face to jamb face
        result.size.covariance(0, 0) = fit.lengthVariance;
        result.real = true;
        result.state = DoorState::Open;  // the grid shows free cells between the jambs
        setHeight(m_heights, lintelHeight({m_grid, door.line, {door.jambA, door.jambB}}, m_heights),
                  result.position, result.size);
        return result;
    }

    Doorway opening(const PlaceLink& link) const
    {
        const Eigen::Vector2d at = m_grid.frame().toMap(link.at);
        const double variance = m_grid.resolution_m() * m_grid.resolution_m() / 12.0;
        Doorway result;
        result.position.mean = {at.x(), at.y(), 0};
        result.position.covariance = inSpace(Eigen::Matrix2d::Identity() * variance);
        result.size.length_m = (2 * link.clearance_cells - 1) * m_grid.resolution_m();
        result.size.covariance(0, 0) = 2 * variance;
        setHeight(m_heights, std::nullopt, result.position, result.size);
        return result;
    }

    const ClassifiedGrid& m_grid;
    const HeightMap& m_heights;
    const VoronoiGraph& m_voronoi;
    const PlaceGraph& m_graph;
    const TDelimitationOptions& m_options;
    ClassifiedGrid m_closedGrid;
    OctagonGrower m_grower;
    std::vector<std::vector<Circle>> m_neighbours;  //!< circles joined to each circle
    std::vector<Cell> m_borders;  //!< cells of closed doors, then of openings between places
    std::vector<PlaceDraft> m_drafts;
    std::vector<PlaceId> m_idOfCircle;
    std::vector<std::size_t> m_cellsOfPlace;
    std::uint32_t m_wallCount = 0;
    DelimitedSpace m_result;
};
}  // namespace

std::vector<OptionField> TDelimitationOptions::fields()
{
    return {{"real_wall_ratio", &real_wall_ratio, "ratio",
             "A side of a place is a real wall when more than this part of it lies on occupied cells.", 0, 1},
            {"corridor_radius_tolerance", &corridor_radius_tolerance, "ratio",
             "Largest relative difference of circle radii that count as the same when corridors are merged.",
             0, 1},
            {"corridor_angle_tolerance", &corridor_angle_tolerance, "deg",
             "Largest turn among three circles in a row that count as collinear when corridors are merged.",
             0, 90},
            {"corridor_elongation", &corridor_elongation, "ratio",
             "A place is a corridor when its area is at least this many squares of its largest circle's "
             "diameter; 0: only merged circles are.",
             0, 100}};
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
