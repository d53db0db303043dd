#include "drawMap.h"

#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CSphere.h>
#include <mrpt/opengl/CText.h>

#include <cmath>

namespace gr2to
{
namespace
{
using mrpt::img::TColor;
using mrpt::math::TPoint3D;
using mrpt::math::TPoint3Df;

constexpr double kWallHeight_m = 2.5;
constexpr double kDoorHeight_m = 2.0;
constexpr double kGraphHeight_m = 3.0;
constexpr double kNode_m = 0.25;

/** Colours that neighbouring ids do not share. */
TColor colourOf(PlaceId id)
{
    constexpr double goldenAngle = 2.399963;
    const auto wave = [&](double shift) {
        return static_cast<std::uint8_t>(std::lround(140 + 100 * std::cos(id * goldenAngle + shift)));
    };
    return {wave(0), wave(2 * M_PI / 3), wave(4 * M_PI / 3)};
}

TPoint3D above(const TPoint3D& point, double height_m)
{
    return {point.x, point.y, point.z + height_m};
}

void addBoundary(mrpt::opengl::CSetOfObjects& objects, const Place& place)
{
    auto lines = mrpt::opengl::CSetOfLines::Create();
    lines->setColor_u8(colourOf(place.id));
    lines->setLineWidth(3);
    for (std::size_t i = 0; i < place.boundary.size(); ++i) {
        const auto &a = place.boundary[i], &b = place.boundary[(i + 1) % place.boundary.size()];
        lines->appendLine(a.x, a.y, place.center.z, b.x, b.y, place.center.z);
    }
    objects.insert(lines);
}

/** An upright rectangle around a line on the floor. */
void addPlane(mrpt::opengl::CSetOfTriangles& triangles, const TPoint3D& a, const TPoint3D& b, double height_m,
              const TColor& colour)
{
    const auto triangle = [&](const TPoint3D& p, const TPoint3D& q, const TPoint3D& r) {
        mrpt::opengl::TTriangle t{TPoint3Df(p), TPoint3Df(q), TPoint3Df(r)};
        t.computeNormals();
        t.setColor(colour);
        triangles.insertTriangle(t);
    };
    triangle(a, b, above(b, height_m));
    triangle(a, above(b, height_m), above(a, height_m));
}

void addWall(mrpt::opengl::CSetOfTriangles& triangles, const Wall& wall, const Place& place)
{
    if (!wall.real) return;
    const TPoint3D& middle = wall.position.mean;
    const TPoint3D half{-wall.normal.mean.y * wall.size.length_m / 2,
                        wall.normal.mean.x * wall.size.length_m / 2, 0};
    const TPoint3D foot{middle.x, middle.y, place.center.z};
    addPlane(triangles, foot - half, foot + half, wall.size.height_m.value_or(kWallHeight_m),
             TColor(120, 120, 120));
}

/** A door stands across the line between its places, because the model keeps no direction of it. */
void addConnection(mrpt::opengl::CSetOfObjects& objects, mrpt::opengl::CSetOfTriangles& triangles,
                   const Connection& connection, const TopologicalMap& map)
{
    const Doorway& door = connection.doorway;
    const TPoint3D &from = map.place(connection.from).center, &to = map.place(connection.to).center;
    auto lines = mrpt::opengl::CSetOfLines::Create();
    lines->setColor_u8(TColor(30, 30, 30));
    lines->appendLine(above(from, kGraphHeight_m), above(door.position.mean, kGraphHeight_m));
    lines->appendLine(above(door.position.mean, kGraphHeight_m), above(to, kGraphHeight_m));
    objects.insert(lines);
    const double dx = to.x - from.x, dy = to.y - from.y, distance = std::hypot(dx, dy);
    if (!door.real || distance == 0) return;
    const double scale = door.size.length_m / 2 / distance;
    const TPoint3D half{-dy * scale, dx * scale, 0};
    addPlane(triangles, door.position.mean - half, door.position.mean + half,
             door.size.height_m.value_or(kDoorHeight_m), TColor(0, 114, 178));
}

void addNode(mrpt::opengl::CSetOfObjects& objects, const Place& place)
{
    auto node = mrpt::opengl::CSphere::Create(static_cast<float>(kNode_m));
    node->setColor_u8(colourOf(place.id));
    node->setLocation(above(place.center, kGraphHeight_m));
    objects.insert(node);
    auto text =
        mrpt::opengl::CText::Create(place.words.empty() ? std::to_string(place.id) : place.words.front());
    text->setLocation(above(place.center, kGraphHeight_m + 2 * kNode_m));
    text->setColor_u8(TColor(0, 0, 0));
    objects.insert(text);
}
}  // namespace

mrpt::opengl::CSetOfObjects::Ptr drawMap(const TopologicalMap& map)
{
    auto objects = mrpt::opengl::CSetOfObjects::Create();
    objects->setName("gr2to::CTopologicalMap");
    auto triangles = mrpt::opengl::CSetOfTriangles::Create();
    for (const auto& [id, place] : map.places()) {
        addBoundary(*objects, place);
        for (const Wall& wall : place.walls) addWall(*triangles, wall, place);
        addNode(*objects, place);
    }
    for (const Connection& connection : map.connections())
        addConnection(*objects, *triangles, connection, map);
    objects->insert(triangles);
    return objects;
}
}  // namespace gr2to
