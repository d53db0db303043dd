#include "OverlayLayers.h"

#include <algorithm>
#include <cmath>

#include "doorDirection.h"

namespace gr2to::view
{
namespace
{
using Eigen::Vector2d;

constexpr double kVirtualShare = 0.6;  // width of a virtual wall or opening, of a real one's
constexpr double kCasing = 1.5;        // width of the light line under a door, of the door's
constexpr double kConnectionOpacity = 0.7;
constexpr double kStub_m = 0.5;        // of a connection whose place's centre is not in sight of the door
constexpr double kOutlineShare = 0.2;  // of a dot's diameter
constexpr std::ptrdiff_t kSmoothing_cells =
    2;                                    // on either side: turns the staircases of a cell path into slopes
constexpr double kShortestMove_px = 1.5;  // of a drawn polyline

/** What every layer needs at hand. */
struct Scene
{
    Canvas& canvas;
    const OverlayInput& input;
    const TOverlayOptions& options;
    const Layout& layout;

    double px(double nominal) const { return nominal * layout.unit; }
    Vector2d gridPoint(double x_m, double y_m) const { return input.grid.frame().toGrid(x_m, y_m); }
    Vector2d picture(double x_m, double y_m) const { return layout.toPicture(gridPoint(x_m, y_m)); }
};

Vector2d smoothed(const std::vector<Cell>& cells, std::ptrdiff_t i)
{
    const auto last = static_cast<std::ptrdiff_t>(cells.size()) - 1;
    const std::ptrdiff_t reach = std::min({kSmoothing_cells, i, last - i});  // ends stay where they are
    Vector2d sum(0, 0);
    for (std::ptrdiff_t k = i - reach; k <= i + reach; ++k)
        sum += Vector2d(cells[static_cast<std::size_t>(k)].x, cells[static_cast<std::size_t>(k)].y);
    return sum / static_cast<double>(2 * reach + 1);
}

void drawVoronoi(const Scene& scene)
{
    for (const auto& edge : scene.input.voronoi.edges) {
        if (edge.cells.empty()) continue;
        const auto count = static_cast<std::ptrdiff_t>(edge.cells.size());
        Vector2d last = scene.layout.toPicture(smoothed(edge.cells, 0));
        scene.canvas.moveTo(last);
        for (std::ptrdiff_t i = 1; i < count; ++i) {
            const Vector2d p = scene.layout.toPicture(smoothed(edge.cells, i));
            if (i + 1 < count && (p - last).norm() < kShortestMove_px) continue;
            scene.canvas.lineTo(p);
            last = p;
        }
    }
    scene.canvas.stroke(palette::voronoi, scene.px(scene.options.voronoi_width));
}

void drawWalls(const Scene& scene)
{
    for (const bool real : {false, true})
        for (const auto& [id, place] : scene.input.map.places())
            for (const auto& wall : place.walls) {
                if (wall.real != real) continue;
                const Vector2d middle(wall.position.mean.x, wall.position.mean.y);
                const Vector2d along(-wall.normal.mean.y, wall.normal.mean.x);
                const Vector2d a = middle - along * (wall.size.length_m / 2);
                const Vector2d b = middle + along * (wall.size.length_m / 2);
                drawWall(scene.canvas, scene.picture(a.x(), a.y()), scene.picture(b.x(), b.y()), real,
                         scene.px(scene.options.wall_width), scene.px(kDash));
            }
}

Vector2d centerOf(const Scene& scene, PlaceId id)
{
    const auto& center = scene.input.map.place(id).center;
    return scene.gridPoint(center.x, center.y);
}

/** Direction of a doorway along the grid's axes: from its jambs, or of an opening from where its places
 * touch, which its jambs may be far from; else square to the line between its places. */
Vector2d directionOf(const Scene& scene, const Connection& connection, const Vector2d& center)
{
    const double length_cells = connection.doorway.size.length_m / scene.input.grid.resolution_m();
    if (!connection.doorway.real)
        if (const auto found = contactDirection(scene.input.places, connection.from, connection.to, center,
                                                length_cells / 2 + 2))
            return *found;
    if (const auto found = doorDirection(scene.input.grid, center, length_cells + 2)) return *found;
    const Vector2d between = centerOf(scene, connection.to) - centerOf(scene, connection.from);
    return between.norm() > 0 ? Vector2d(-between.y(), between.x()).normalized() : Vector2d(1, 0);
}

/** Whether the straight line between two points of the grid crosses other places or obstacles, the doorway's
 * surroundings left out. */
bool leavesPlace(const Scene& scene, PlaceId id, const Vector2d& door, const Vector2d& center)
{
    const double length = (center - door).norm();
    for (int s = static_cast<int>(kStub_m / scene.input.grid.resolution_m()); s < length; ++s) {
        const Vector2d p = door + (center - door) * (s / length);
        const Cell c{static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))};
        if (!scene.input.grid.contains(c) || scene.input.places.at(c) != id) return true;
    }
    return false;
}

/** A line from a doorway to a place's centre, or into the place when the centre is not in sight. */
void drawLeg(const Scene& scene, const Connection& connection, PlaceId id)
{
    const auto& mean = connection.doorway.position.mean;
    const Vector2d door = scene.gridPoint(mean.x, mean.y), center = centerOf(scene, id);
    Vector2d end = center;
    if (leavesPlace(scene, id, door, center)) {
        const Vector2d along = directionOf(scene, connection, door);
        const Vector2d across = Vector2d(-along.y(), along.x()) * (kStub_m / scene.input.grid.resolution_m());
        const auto isThere = [&](const Vector2d& p) {
            const Cell c{static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))};
            return scene.input.grid.contains(c) && scene.input.places.at(c) == id;
        };
        end = isThere(door - across) && !isThere(door + across) ? Vector2d(door - across)
                                                                : Vector2d(door + across);
    }
    scene.canvas.moveTo(scene.layout.toPicture(door));
    scene.canvas.lineTo(scene.layout.toPicture(end));
}

void drawConnections(const Scene& scene, const std::vector<Connection>& connections)
{
    for (const auto& connection : connections)
        for (const PlaceId id : {connection.from, connection.to}) drawLeg(scene, connection, id);
    scene.canvas.stroke(palette::ink, scene.px(scene.options.connection_width), 0, kConnectionOpacity);
}

void drawDoors(const Scene& scene, const std::vector<Connection>& connections)
{
    const double width = scene.px(scene.options.door_width);
    for (const bool real : {false, true})
        for (const auto& connection : connections) {
            if (connection.doorway.real != real) continue;
            const auto& mean = connection.doorway.position.mean;
            const Vector2d center = scene.gridPoint(mean.x, mean.y);
            const Vector2d along = directionOf(scene, connection, center);
            const double length_px = connection.doorway.size.length_m / scene.input.grid.resolution_m() *
                                     scene.layout.pixelsPerCell();
            // On a much reduced map a door would vanish; a square is the least that can be seen.
            const Vector2d half = Vector2d(along.x(), -along.y()) * (std::max(length_px, width) / 2);
            const Vector2d p = scene.layout.toPicture(center);
            if (real)
                drawRealDoor(scene.canvas, p - half, p + half, width);
            else
                drawVirtualOpening(scene.canvas, p - half, p + half, width, scene.px(kDash));
        }
}
}  // namespace

void drawRealDoor(Canvas& canvas, const Vector2d& a, const Vector2d& b, double width_px)
{
    canvas.line(a, b, palette::halo, width_px * kCasing);
    canvas.line(a, b, palette::door, width_px);
}

void drawVirtualOpening(Canvas& canvas, const Vector2d& a, const Vector2d& b, double width_px, double dash_px)
{
    canvas.line(a, b, palette::door, width_px * kVirtualShare, dash_px);
}

void drawWall(Canvas& canvas, const Vector2d& a, const Vector2d& b, bool real, double width_px,
              double dash_px)
{
    if (real)
        canvas.line(a, b, palette::ink, width_px);
    else
        canvas.line(a, b, palette::ink, width_px * kVirtualShare, dash_px);
}

void drawCriticalPoint(Canvas& canvas, const Vector2d& p, double size_px)
{
    canvas.dot(p, size_px, palette::criticalPoint, palette::ink, size_px * kOutlineShare);
}

void drawVertex(Canvas& canvas, const Vector2d& p, double size_px)
{
    canvas.dot(p, size_px, palette::vertex, palette::halo, size_px * kOutlineShare);
}

void drawLines(Canvas& canvas, const OverlayInput& input, const TOverlayOptions& options,
               const Layout& layout)
{
    const Scene scene{canvas, input, options, layout};
    const auto connections = input.map.connections();
    if (options.voronoi) drawVoronoi(scene);
    if (options.walls) drawWalls(scene);
    if (options.connections) drawConnections(scene, connections);
    if (options.doors) drawDoors(scene, connections);
    if (options.critical_points)
        for (const auto& point : input.criticalPoints)
            drawCriticalPoint(canvas, layout.toPicture(point.cell.x, point.cell.y),
                              scene.px(options.point_size));
    if (options.connections)
        for (const auto& [id, place] : input.map.places())
            drawVertex(canvas, scene.picture(place.center.x, place.center.y),
                       scene.px(options.point_size * kVertexShare));
}
}  // namespace gr2to::view
