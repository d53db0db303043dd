/** From where a robot stands to a place that a person names, door by door, each leg planned on the grid by
 * MRPT: `go_to_word GRID TOPOMAP X Y WORD [RADIUS_M]`, WORD being one of the place's words or its id. */
#include <gr2to/grid/DistanceMap.h>
#include <gr2to/io/GridReader.h>
#include <gr2to/io/LabelImageReader.h>
#include <gr2to/io/OccupancyGrid.h>
#include <gr2to/mrpt/archive.h>
#include <mrpt/graphs/dijkstra.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/nav/planners/PlannerSimple2D.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <set>

namespace
{
using gr2to::Connection;
using gr2to::PlaceId;
using gr2to::TopologicalMap;
using mrpt::math::TPoint3D;

/** MRPT's planner widens obstacles by squares, so that a slanted passage has to be wider by this much. */
double spaceOf(double radius_m)
{
    return std::sqrt(2.0) * radius_m;
}

PlaceId placeNamed(const TopologicalMap& map, const std::string& word)
{
    for (const auto& [id, place] : map.places())
        if (std::count(place.words.begin(), place.words.end(), word) || std::to_string(id) == word) return id;
    throw std::invalid_argument("no place is called '" + word + "'");
}

gr2to::Cell cellAt(const gr2to::ClassifiedGrid& grid, double x, double y)
{
    const Eigen::Vector2d p = grid.frame().toGrid(x, y);
    return {static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))};
}

PlaceId placeAt(const gr2to::ClassifiedGrid& grid, const gr2to::PlaceImage& places, double x, double y)
{
    const gr2to::Cell cell = cellAt(grid, x, y);
    if (!grid.contains(cell) || places.at(cell) == 0)
        throw std::invalid_argument("the robot stands in no place");
    return places.at(cell);
}

/** Where in a place a robot that comes from a point can stand, as near as can be to the place's centre: a
 * table may stand there. */
TPoint3D standingPoint(const gr2to::ClassifiedGrid& grid, const gr2to::PlaceImage& places,
                       const gr2to::Place& place, const TPoint3D& from, double radius_m)
{
    const gr2to::DistanceMap distances = measureDistances(grid, gr2to::Obstacles::OccupiedOrUnknown);
    const double needed_cells = spaceOf(radius_m) / grid.resolution_m() + 1;
    std::vector<bool> seen(grid.size(), false);
    std::vector<gr2to::Cell> queue{cellAt(grid, from.x, from.y)};
    TPoint3D best;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < queue.size(); ++k) {
        const auto [x, y] = queue[k];
        const Eigen::Vector2d p = grid.frame().toMap(queue[k]);
        const double distance = std::hypot(p.x() - place.center.x, p.y() - place.center.y);
        if (places.at(queue[k]) == place.id && distance < nearest) {
            nearest = distance;
            best = {p.x(), p.y(), 0};
        }
        for (const gr2to::Cell n : {gr2to::Cell{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}}) {
            if (!grid.isFree(n) || seen[grid.index(n)] || distances.clearance_cells(n) < needed_cells)
                continue;
            seen[grid.index(n)] = true;
            queue.push_back(n);
        }
    }
    if (std::isinf(nearest)) throw std::runtime_error("no part of the place can be reached");
    return best;
}

/** The connections that a robot fits through, those that it can reach from a place, for MRPT's algorithms. */
TopologicalMap::Graph passableGraph(const TopologicalMap& map, PlaceId from, double radius_m)
{
    TopologicalMap::Graph graph;
    // The robot's cell lies up to half a cell's diagonal off the doorway's middle, and needs a cell more than
    // its space.
    const double rounding_cells = 1 + std::sqrt(2.0);
    const double needed = 2 * spaceOf(radius_m) + rounding_cells * map.resolution_m;
    std::vector<PlaceId> reached{from};
    std::set<std::uint32_t> taken;
    for (std::size_t k = 0; k < reached.size(); ++k)
        for (const Connection& c : map.connectionsOf(reached[k])) {
            if (c.doorway.size.length_m < needed || !taken.insert(c.id).second) continue;
            graph.insertEdge(c.from, c.to, c);
            reached.push_back(c.from == reached[k] ? c.to : c.from);
        }
    return graph;
}

/** Doorways to pass, in order. */
std::vector<TPoint3D> doorwaysBetween(const TopologicalMap& map, PlaceId from, PlaceId to, double radius_m)
{
    if (from == to) return {};
    const TopologicalMap::Graph graph = passableGraph(map, from, radius_m);
    if (!graph.getAllNodes().count(to)) throw std::runtime_error("no way that is wide enough leads there");
    const auto length = [&](const TopologicalMap::Graph&, mrpt::graphs::TNodeID, mrpt::graphs::TNodeID,
                            const Connection& c) {
        const TPoint3D& door = c.doorway.position.mean;
        return (map.place(c.from).center - door).norm() + (map.place(c.to).center - door).norm();
    };
    const mrpt::graphs::CDijkstra<TopologicalMap::Graph> ways(graph, from, length);
    std::vector<TPoint3D> doors;
    PlaceId here = from;
    for (const auto& [a, b] : ways.getShortestPathTo(to)) {
        const auto next = static_cast<PlaceId>(a == here ? b : a);
        const auto [first, last] = graph.getEdges(std::min(here, next), std::max(here, next));
        const auto widest = std::max_element(first, last, [](const auto& p, const auto& q) {
            return p.second.doorway.size.length_m < q.second.doorway.size.length_m;
        });
        doors.push_back(widest->second.doorway.position.mean);
        here = next;
    }
    return doors;
}
}  // namespace

int main(int argc, char** argv)
try {
    if (argc < 6 || argc > 7)
        throw std::invalid_argument("usage: go_to_word GRID TOPOMAP X Y WORD [RADIUS_M]");
    const gr2to::ClassifiedGrid grid = gr2to::readGrid(argv[1], {});
    const TopologicalMap map = gr2to::loadTopologicalMap(argv[2]);
    const auto folder = std::filesystem::path(argv[2]).parent_path();
    const gr2to::PlaceImage places = gr2to::readLabelImage(folder / "places.png").labels;
    const double x = std::stod(argv[3]), y = std::stod(argv[4]);

    mrpt::nav::PlannerSimple2D planner;
    planner.robotRadius = argc == 7 ? std::stof(argv[6]) : 0.25F;
    const PlaceId from = placeAt(grid, places, x, y), to = placeNamed(map, argv[5]);
    std::vector<TPoint3D> stops = doorwaysBetween(map, from, to, planner.robotRadius);
    stops.push_back(standingPoint(grid, places, map.place(to), {x, y, 0}, planner.robotRadius));

    const mrpt::maps::COccupancyGridMap2D obstacles = gr2to::toOccupancyGrid(grid);
    mrpt::poses::CPose2D here(x, y, 0);
    for (const TPoint3D& stop : stops) {
        const mrpt::poses::CPose2D target(stop.x, stop.y, 0);
        std::deque<mrpt::math::TPoint2D> path;
        bool notFound = true;
        planner.computePath(obstacles, here, target, path, notFound);
        if (notFound)
            throw std::runtime_error("the planner finds no way to (" + std::to_string(stop.x) + ", " +
                                     std::to_string(stop.y) + ")");
        std::cout << "drive to (" << stop.x << ", " << stop.y << ") by " << path.size() << " points\n";
        here = target;
    }
    std::cout << "arrived at '" << argv[5] << "'\n";
    return 0;
} catch (const std::exception& error) {
    std::cerr << "go_to_word: " << error.what() << "\n";
    return 2;
}
