#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CSphere.h>
#include <mrpt/opengl/CText.h>

#include <cmath>
#include <limits>

#include "gr2to/view/Palette.h"
#include "gr2to/view/Scene3D.h"
#include "gr2to/view/triangulate.h"

namespace gr2to
{
namespace
{
using mrpt::img::TColor;
using mrpt::math::TPoint3D;
using mrpt::math::TPoint3Df;

constexpr double kNode_m = 0.25;
constexpr double kLift_m = 0.02;       // of lines above the floor that they lie on
constexpr double kDoorFront_m = 0.06;  // of a door's faces before the walls, which may lie in its plane

TColor colorOf(Rgb rgb)
{
    return {rgb.red, rgb.green, rgb.blue};
}

TPoint3D above(const TPoint3D& point, double height_m)
{
    return {point.x, point.y, point.z + height_m};
}

/** Collects what a map consists of. */
class MapDrawing
{
 public:
    MapDrawing(const TopologicalMap& map, const TSceneOptions& options) : m_map(map), m_options(options) {}

    mrpt::opengl::CSetOfObjects::Ptr draw()
    {
        m_objects->setName("gr2to::CTopologicalMap");
        for (const auto& [id, place] : m_map.places()) {
            addFloor(place);
            for (const Wall& wall : place.walls) addWall(wall, place);
            if (m_options.graph) addNode(place);
        }
        for (const Connection& connection : m_map.connections()) {
            if (connection.doorway.real) addDoor(connection);
            if (m_options.graph) addEdge(connection);
        }
        m_lines->setLineWidth(2);
        m_lines->setColor_u8(colorOf(palette::ink));
        m_walls->setName("walls");
        m_floors->setName("floors");
        // Objects as far away as one another are drawn from the last to the first, so that walls come last:
        // what is to be seen through them has to be there.
        m_objects->insert(m_walls);
        m_objects->insert(m_lines);
        m_objects->insert(m_floors);
        return m_objects;
    }

 private:
    static void addTriangle(mrpt::opengl::CSetOfTriangles& triangles, const TPoint3D& a, const TPoint3D& b,
                            const TPoint3D& c, const TColor& color)
    {
        mrpt::opengl::TTriangle triangle{TPoint3Df(a), TPoint3Df(b), TPoint3Df(c)};
        triangle.computeNormals();
        triangle.setColor(color);
        triangles.insertTriangle(triangle);
    }

    TColor seeThrough(Rgb rgb) const
    {
        return {rgb.red, rgb.green, rgb.blue,
                static_cast<std::uint8_t>(std::lround(255 * m_options.wall_opacity))};
    }

    void addFloor(const Place& place)
    {
        const TColor color = colorOf(placeColor(place.id));
        const auto vertex = [&](std::size_t i) {
            return TPoint3D{place.boundary[i].x, place.boundary[i].y, place.center.z};
        };
        for (const auto& [a, b, c] : triangulate(place.boundary))
            addTriangle(*m_floors, vertex(a), vertex(b), vertex(c), color);
    }

    void addPlane(const TPoint3D& a, const TPoint3D& b, double height_m, const TColor& color)
    {
        addTriangle(*m_walls, a, b, above(b, height_m), color);
        addTriangle(*m_walls, a, above(b, height_m), above(a, height_m), color);
    }

    void addWall(const Wall& wall, const Place& place)
    {
        const TPoint3D half{-wall.normal.mean.y * wall.size.length_m / 2,
                            wall.normal.mean.x * wall.size.length_m / 2, 0};
        const TPoint3D foot{wall.position.mean.x, wall.position.mean.y, place.center.z};
        if (wall.real)
            addPlane(foot - half, foot + half, wall.size.height_m.value_or(m_options.wall_height),
                     seeThrough(palette::occupied));
        else
            m_lines->appendLine(above(foot - half, kLift_m), above(foot + half, kLift_m));
    }

    /** Direction of the wall that a door is in: the model keeps none of the door itself. Without a wall it
     * stands across the line between its places. */
    TPoint3D directionOf(const Connection& connection) const
    {
        const TPoint3D& door = connection.doorway.position.mean;
        const TPoint3D between = m_map.place(connection.to).center - m_map.place(connection.from).center;
        TPoint3D best{-between.y, between.x, 0};
        double nearest = std::numeric_limits<double>::infinity();
        for (const PlaceId id : {connection.from, connection.to})
            for (const Wall& wall : m_map.place(id).walls) {
                const TPoint3D &normal = wall.normal.mean, offset = door - wall.position.mean;
                const double along = std::abs(normal.x * offset.y - normal.y * offset.x);
                const double beyond = std::max(0.0, along - wall.size.length_m / 2);
                const double distance = std::hypot(normal.x * offset.x + normal.y * offset.y, beyond);
                if (distance >= nearest) continue;
                nearest = distance;
                best = {-normal.y, normal.x, 0};
            }
        const double length = std::hypot(best.x, best.y);
        return length > 0 ? best * (1 / length) : TPoint3D{1, 0, 0};
    }

    void addDoor(const Connection& connection)
    {
        const Doorway& door = connection.doorway;
        const TPoint3D half = directionOf(connection) * (door.size.length_m / 2);
        const TPoint3D foot{door.position.mean.x, door.position.mean.y,
                            m_map.place(connection.from).center.z};
        const double length = half.norm();
        const TPoint3D front =
            length > 0 ? TPoint3D{-half.y, half.x, 0} * (kDoorFront_m / length) : TPoint3D{0, 0, 0};
        for (const TPoint3D& face : {foot - front, foot + front})
            addPlane(face - half, face + half, door.size.height_m.value_or(m_options.door_height),
                     colorOf(palette::door));
    }

    void addEdge(const Connection& connection)
    {
        const TPoint3D &from = m_map.place(connection.from).center, &to = m_map.place(connection.to).center;
        const TPoint3D door{connection.doorway.position.mean.x, connection.doorway.position.mean.y, from.z};
        m_lines->appendLine(above(from, m_options.graph_height), above(door, m_options.graph_height));
        m_lines->appendLine(above(door, m_options.graph_height), above(to, m_options.graph_height));
    }

    void addNode(const Place& place)
    {
        auto node = mrpt::opengl::CSphere::Create(static_cast<float>(kNode_m));
        node->setColor_u8(colorOf(palette::vertex));
        node->setLocation(above(place.center, m_options.graph_height));
        m_objects->insert(node);
        auto text =
            mrpt::opengl::CText::Create(place.words.empty() ? std::to_string(place.id) : place.words.front());
        text->setLocation(above(place.center, m_options.graph_height + 2 * kNode_m));
        text->setColor_u8(colorOf(palette::ink));
        text->setFont("sans", 12);
        m_objects->insert(text);
    }

    const TopologicalMap& m_map;
    const TSceneOptions& m_options;
    mrpt::opengl::CSetOfObjects::Ptr m_objects = mrpt::opengl::CSetOfObjects::Create();
    mrpt::opengl::CSetOfTriangles::Ptr m_floors = mrpt::opengl::CSetOfTriangles::Create();
    mrpt::opengl::CSetOfTriangles::Ptr m_walls = mrpt::opengl::CSetOfTriangles::Create();
    mrpt::opengl::CSetOfLines::Ptr m_lines = mrpt::opengl::CSetOfLines::Create();
};
}  // namespace

mrpt::opengl::CSetOfObjects::Ptr drawMap(const TopologicalMap& map, const TSceneOptions& options)
{
    options.check();
    return MapDrawing(map, options).draw();
}
}  // namespace gr2to
