#include <limits>
#include <set>
#include <utility>

#include "StrictXml.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/base/text.h"
#include "gr2to/io/XmlMap.h"

namespace gr2to
{
namespace
{
constexpr std::uint32_t LARGEST_PLACE_ID = std::numeric_limits<PlaceId>::max();
constexpr std::uint32_t LARGEST_ID = std::numeric_limits<std::uint32_t>::max();

/** From the upper triangle row by row; zero when absent. */
template <class Matrix>
Matrix readCovariance(const StrictElement& element)
{
    Matrix matrix;
    const auto size = static_cast<std::size_t>(matrix.rows());
    const auto entries = element.optionalNumbers("cov", size * (size + 1) / 2);
    if (entries.empty()) return matrix;
    auto entry = entries.begin();
    for (int row = 0; row < matrix.rows(); ++row)
        for (int column = row; column < matrix.cols(); ++column, ++entry)
            matrix(row, column) = matrix(column, row) = *entry;
    return matrix;
}

mrpt::math::TPoint3D readPoint(const StrictElement& element)
{
    element.sequence({});
    return {element.number("x"), element.number("y"), element.number("z")};
}

/** For UncertainPoint and UncertainNormal. */
template <class Uncertain>
Uncertain readUncertain(const StrictElement& element)
{
    element.expectAttributes({"x", "y", "z"}, {"cov"});
    return {readPoint(element), readCovariance<mrpt::math::CMatrixDouble33>(element)};
}

PlaneSize readSize(const StrictElement& element)
{
    element.expectAttributes({"length"}, {"height", "cov"});
    element.sequence({});
    return {element.number("length"), element.optionalNumber("height"),
            readCovariance<mrpt::math::CMatrixDouble22>(element)};
}

std::vector<std::string> readWords(const StrictElement& element)
{
    std::vector<std::string> words;
    for (const auto& word : element.list("word")) words.push_back(word.content());
    return words;
}

std::vector<mrpt::math::TPoint2D> readBoundary(const StrictElement& element)
{
    std::vector<mrpt::math::TPoint2D> boundary;
    const std::string content = element.content();
    for (const auto piece : splitAtBlanks(content)) {
        const std::size_t comma = piece.find(',');
        const auto x = parseFiniteNumber(piece.substr(0, comma));
        const auto y = comma == piece.npos ? std::nullopt : parseFiniteNumber(piece.substr(comma + 1));
        if (!x || !y)
            element.fail(excerpt(piece) + " is not a vertex; write x,y in metres, blanks between vertices");
        boundary.emplace_back(*x, *y);
    }
    return boundary;
}

Wall readWall(const StrictElement& element, std::set<std::uint32_t>& ids)
{
    element.expectAttributes({"id", "real"});
    const auto parts = element.sequence({"position", "normal", "size", "curvature"});
    Wall wall;
    wall.id = element.id("id", LARGEST_ID);
    if (!ids.insert(wall.id).second)
        element.fail("id = " + std::to_string(wall.id) +
                     " is taken; the ids of walls must be unique in the map");
    wall.real = element.flag("real");
    wall.position = readUncertain<UncertainPoint>(parts[0]);
    wall.normal = readUncertain<UncertainNormal>(parts[1]);
    wall.size = readSize(parts[2]);
    parts[3].expectAttributes({"length", "height"});
    parts[3].sequence({});
    wall.curvatureLength = parts[3].number("length");
    wall.curvatureHeight = parts[3].number("height");
    return wall;
}

View readView(const StrictElement& element)
{
    element.expectAttributes({"image"}, {"time"});
    const auto parts = element.sequence({"position", "aperture"});
    parts[1].expectAttributes({"x", "y"});
    parts[1].sequence({});
    return {element.text("image"), readUncertain<UncertainPoint>(parts[0]), parts[1].number("x"),
            parts[1].number("y"), element.optionalNumber("time").value_or(0)};
}

Place readPlace(const StrictElement& element, std::set<std::uint32_t>& wallIds)
{
    element.expectAttributes({"id", "kind", "area"});
    const auto parts = element.sequence({"words", "center", "boundary", "walls", "views"});
    Place place;
    place.id = static_cast<PlaceId>(element.id("id", LARGEST_PLACE_ID));
    place.kind = element.choice("kind", {"room", "corridor"}) == 0 ? PlaceKind::Room : PlaceKind::Corridor;
    place.area_m2 = element.number("area");
    place.words = readWords(parts[0]);
    parts[1].expectAttributes({"x", "y", "z"});
    place.center = readPoint(parts[1]);
    place.boundary = readBoundary(parts[2]);
    for (const auto& wall : parts[3].list("wall")) place.walls.push_back(readWall(wall, wallIds));
    for (const auto& view : parts[4].list("view")) place.views.push_back(readView(view));
    return place;
}

Doorway readDoorway(const StrictElement& element)
{
    element.expectAttributes({"real", "state"});
    const bool hasView = element.hasChild("view");
    const auto parts =
        hasView ? element.sequence({"position", "size", "view"}) : element.sequence({"position", "size"});
    constexpr DoorState STATES[] = {DoorState::Open, DoorState::Closed, DoorState::Unknown};
    Doorway doorway;
    doorway.real = element.flag("real");
    doorway.state = STATES[element.choice("state", {"open", "closed", "unknown"})];
    doorway.position = readUncertain<UncertainPoint>(parts[0]);
    doorway.size = readSize(parts[1]);
    if (hasView) doorway.view = readView(parts[2]);
    return doorway;
}

Connection readConnection(const StrictElement& element, const std::map<PlaceId, Place>& places,
                          std::set<std::uint32_t>& ids)
{
    element.expectAttributes({"id", "from", "to"});
    const auto parts = element.sequence({"words", "doorway"});
    Connection connection;
    connection.id = element.id("id", LARGEST_ID);
    if (!ids.insert(connection.id).second)
        element.fail("id = " + std::to_string(connection.id) +
                     " is taken; the ids of connections must be unique");
    connection.from = static_cast<PlaceId>(element.id("from", LARGEST_PLACE_ID));
    connection.to = static_cast<PlaceId>(element.id("to", LARGEST_PLACE_ID));
    for (const char* end : {"from", "to"})
        if (places.count(static_cast<PlaceId>(element.id(end, LARGEST_PLACE_ID))) == 0)
            element.fail("attribute " + std::string(end) + ": there is no place with id " +
                         element.text(end));
    if (connection.from == connection.to)
        element.fail("from and to are both " + element.text("from") +
                     "; a connection joins two different places");
    connection.words = readWords(parts[0]);
    connection.doorway = readDoorway(parts[1]);
    return connection;
}
}  // namespace

TopologicalMap fromXml(std::string_view text, const std::string& name)
{
    pugi::xml_document document;
    const StrictElement root(name, parseStrictXml(document, text, name));
    if (root.name() != "topological_map") root.fail("the root element must be topological_map");
    if (root.text("version") != "1.0")
        root.fail("attribute version = " + excerpt(root.text("version")) +
                  " must be 1.0, the version that can be read");
    root.expectAttributes({"version", "frame", "resolution", "source"});
    const auto parts = root.sequence({"places", "connections"});

    TopologicalMap map;
    map.frame = root.text("frame");
    map.resolution_m = root.number("resolution");
    map.source = root.text("source");
    std::set<std::uint32_t> wallIds;
    for (const auto& element : parts[0].list("place")) {
        Place place = readPlace(element, wallIds);
        if (map.places().count(place.id) != 0)
            element.fail("id = " + std::to_string(place.id) + " is taken; the ids of places must be unique");
        map.addPlace(std::move(place));
    }
    std::set<std::uint32_t> connectionIds;
    for (const auto& element : parts[1].list("connection"))
        map.addConnection(readConnection(element, map.places(), connectionIds));
    return map;
}

TopologicalMap readXml(const std::filesystem::path& path)
{
    return fromXml(readFile(path), path.string());
}
}  // namespace gr2to
