#include <cmath>
#include <set>

#include "crossingSides.h"
#include "findings.h"
#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
namespace
{
void checkWords(Findings& findings, const std::string& where, const std::vector<std::string>& words)
{
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string what = "word " + std::to_string(i + 1);
        findings.requireName(where, what, words[i]);
    }
}

void checkSize(Findings& findings, const std::string& where, const PlaneSize& size)
{
    findings.requirePositive(where, "length", size.length_m, " m");
    findings.requireCovariance(where, "size", size.covariance);
    if (size.height_m)
        findings.requirePositive(where, "height", *size.height_m, " m");
    else if (size.covariance(0, 1) != 0 || size.covariance(1, 0) != 0 || size.covariance(1, 1) != 0)
        findings.add(where, "the covariance of size has entries of the absent height, which must be 0");
}

void checkView(Findings& findings, const std::string& where, const View& view)
{
    findings.requireName(where, "image", view.image);
    findings.requireFinite(where, "position", view.position.mean);
    findings.requireCovariance(where, "position", view.position.covariance);
    findings.requireAperture(where, "aperture x", view.apertureX_rad);
    findings.requireAperture(where, "aperture y", view.apertureY_rad);
    findings.requireFinite(where, "time", view.time_s);
}

void checkWall(Findings& findings, const std::string& where, const Wall& wall)
{
    constexpr double UNIT_TOLERANCE = 1e-6;
    findings.requireFinite(where, "position", wall.position.mean);
    findings.requireCovariance(where, "position", wall.position.covariance);
    if (findings.requireFinite(where, "normal", wall.normal.mean)) {
        const double norm = wall.normal.mean.norm();
        if (std::abs(norm - 1) > UNIT_TOLERANCE)
            findings.add(where, "normal", norm, "", "must have length 1");
    }
    findings.requireCovariance(where, "normal", wall.normal.covariance);
    checkSize(findings, where, wall.size);
    findings.requireFinite(where, "curvature length", wall.curvatureLength);
    findings.requireFinite(where, "curvature height", wall.curvatureHeight);
}

void checkBoundary(Findings& findings, const std::string& where,
                   const std::vector<mrpt::math::TPoint2D>& boundary)
{
    if (!boundary.empty() && boundary.size() < 3)
        findings.add(where, "boundary has " + std::to_string(boundary.size()) +
                                " vertices; it must have none or at least 3");
    bool finite = true;
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        const mrpt::math::TPoint3D vertex(boundary[i].x, boundary[i].y, 0);
        finite = findings.requireFinite(where, "boundary vertex " + std::to_string(i + 1), vertex) && finite;
    }
    if (!finite) return;
    if (const auto sides = crossingSides(boundary))
        findings.add(where, "boundary crosses itself: the sides from vertex " +
                                std::to_string(sides->first + 1) + " and from vertex " +
                                std::to_string(sides->second + 1) + "; it must be simple");
}

void checkPlace(Findings& findings, PlaceId key, const Place& place, std::set<std::uint32_t>& wallIds)
{
    const std::string where = "place " + std::to_string(key);
    if (place.id != key)
        findings.add(where, "id = " + std::to_string(place.id) + " must stay the number it was added under");
    if (place.kind != PlaceKind::Room && place.kind != PlaceKind::Corridor)
        findings.add(where, "kind = " + std::to_string(static_cast<int>(place.kind)) +
                                " must be 0 (room) or 1 (corridor)");
    findings.requirePositive(where, "area", place.area_m2, " m2");
    findings.requireFinite(where, "center", place.center);
    checkWords(findings, where, place.words);
    checkBoundary(findings, where, place.boundary);
    for (const Wall& wall : place.walls) {
        const std::string wallName = where + ", wall " + std::to_string(wall.id);
        findings.requireFreshId(wallName, wall.id, wallIds);
        checkWall(findings, wallName, wall);
    }
    for (std::size_t i = 0; i < place.views.size(); ++i)
        checkView(findings, where + ", view " + std::to_string(i + 1), place.views[i]);
}

void checkConnection(Findings& findings, const std::map<PlaceId, Place>& places, const Connection& connection)
{
    const std::string where = "connection " + std::to_string(connection.id);
    for (const PlaceId end : {connection.from, connection.to})
        if (places.count(end) == 0)
            findings.add(where, "place " + std::to_string(end) + " does not exist; both ends must be places");
    if (connection.from >= connection.to)
        findings.add(where, "from = " + std::to_string(connection.from) +
                                " must be smaller than to = " + std::to_string(connection.to));
    checkWords(findings, where, connection.words);

    const Doorway& doorway = connection.doorway;
    const std::string doorwayName = where + ", doorway";
    if (doorway.state != DoorState::Unknown && doorway.state != DoorState::Open &&
        doorway.state != DoorState::Closed)
        findings.add(doorwayName, "state = " + std::to_string(static_cast<int>(doorway.state)) +
                                      " must be 0 (unknown), 1 (open) or 2 (closed)");
    findings.requireFinite(doorwayName, "position", doorway.position.mean);
    findings.requireCovariance(doorwayName, "position", doorway.position.covariance);
    checkSize(findings, doorwayName, doorway.size);
    if (doorway.view) checkView(findings, doorwayName + ", view", *doorway.view);
}
}  // namespace

std::vector<std::string> TopologicalMap::validate() const
{
    Findings findings;
    findings.requirePositive("map", "resolution", resolution_m, " m");
    findings.requireName("map", "frame", frame);
    if (!source.empty()) findings.requireName("map", "source", source);
    std::set<std::uint32_t> wallIds;
    for (const auto& [id, place] : m_places) checkPlace(findings, id, place, wallIds);
    std::set<std::uint32_t> connectionIds;
    for (const Connection& connection : connections()) {
        findings.requireFreshId("connection " + std::to_string(connection.id), connection.id, connectionIds);
        checkConnection(findings, m_places, connection);
    }
    return findings.take();
}
}  // namespace gr2to
