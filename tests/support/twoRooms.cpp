#include "support/twoRooms.h"

namespace gr2to::test
{
namespace
{
mrpt::math::TPoint3D at(const GridFrame& frame, double column, double row)
{
    const auto p = frame.toMap(column, row);
    return {p.x(), p.y(), 0};
}

Wall wall(const GridFrame& frame, std::uint32_t id, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
          bool real)
{
    const Eigen::Vector2d middle = (from + to) / 2, along = (to - from).normalized();
    const auto normal = frame.directionToMap({along.y(), -along.x()});
    Wall result;
    result.id = id;
    result.position.mean = at(frame, middle.x(), middle.y());
    result.normal.mean = {normal.x(), normal.y(), 0};
    result.size.length_m = (to - from).norm() * frame.resolution_m;
    result.real = real;
    return result;
}

Place place(const GridFrame& frame, PlaceId id, double column, double row, const Wall& itsWall)
{
    Place result;
    result.id = id;
    result.center = at(frame, column, row);
    result.area_m2 = 3.6;
    result.walls = {itsWall};
    return result;
}

Connection connection(const GridFrame& frame, std::uint32_t id, double column, double row, int cells,
                      bool real)
{
    Connection result;
    result.id = id;
    result.from = 1;
    result.to = 2;
    result.doorway.position.mean = at(frame, column, row);
    result.doorway.size.length_m = cells * frame.resolution_m;
    result.doorway.real = real;
    return result;
}
}  // namespace

TwoRooms::TwoRooms(const GridFrame& frame) : grid(41, 21, frame, CellState::Free)
{
    for (int y = 0; y < 21; ++y)
        for (int x = 0; x < 41; ++x) {
            const bool open = (y >= 8 && y <= 12) || (y >= 15 && y <= 18);
            const bool isWall = x == 0 || y == 0 || x == 40 || y == 20 || (x == 20 && !open);
            if (isWall) grid.set({x, y}, CellState::Occupied);
            if (!isWall && x != 20) places.ids[places.index({x, y})] = x < 20 ? PlaceId{1} : PlaceId{2};
        }
    grid.set({40, 20}, CellState::Unknown);
    VoronoiEdge edge;
    for (int x = 5; x <= 35; ++x) edge.cells.push_back({x, 10});
    voronoi.edges = {edge};
    criticalPoints = {{{20, 10}, 3.0}};
    addMap(20, 10);
}

void TwoRooms::addMap(double doorColumn, double doorRow)
{
    const GridFrame& frame = grid.frame();
    map = TopologicalMap();
    map.addPlace(place(frame, 1, 10, 10, wall(frame, 1, {1, 0}, {19, 0}, true)));
    map.addPlace(place(frame, 2, 30, 12, wall(frame, 2, {30, 2}, {30, 9}, false)));
    map.addConnection(connection(frame, 1, doorColumn, doorRow, 5, true));
    map.addConnection(connection(frame, 2, 20, 16.5, 4, false));
}

void TwoRooms::moveDoor(double column, double row)
{
    addMap(column, row);
}
}  // namespace gr2to::test
