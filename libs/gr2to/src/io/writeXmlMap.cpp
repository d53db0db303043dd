#include <cmath>
#include <pugixml.hpp>
#include <stdexcept>

#include "gr2to/base/text.h"
#include "gr2to/io/XmlMap.h"
#include "xmlPath.h"

namespace gr2to
{
namespace
{
[[noreturn]] void refuse(pugi::xml_node node, const std::string& complaint)
{
    throw std::invalid_argument("the map cannot be written as XML: " + xmlPath(node) + ": " + complaint);
}

std::string finiteText(pugi::xml_node node, const std::string& quantity, double value)
{
    if (!std::isfinite(value)) refuse(node, quantity + " = " + numberText(value) + " must be finite");
    return numberText(value);
}

void setNumber(pugi::xml_node node, const char* name, double value)
{
    node.append_attribute(name) = finiteText(node, name, value).c_str();
}

void setFlag(pugi::xml_node node, const char* name, bool value)
{
    node.append_attribute(name) = value ? "1" : "0";
}

void setText(pugi::xml_node node, const char* name, const std::string& text)
{
    if (!isText(text))
        refuse(node, std::string(name) + " = " + excerpt(text) + " must be UTF-8 without controls");
    node.append_attribute(name) = text.c_str();
}

/** The upper triangle row by row; nothing when all entries are zero. */
template <class Matrix>
void setCovariance(pugi::xml_node node, const Matrix& matrix)
{
    std::string text;
    bool zero = true;
    for (int row = 0; row < matrix.rows(); ++row)
        for (int column = row; column < matrix.cols(); ++column) {
            const double entry = matrix(row, column);
            text += (text.empty() ? "" : " ") + finiteText(node, "cov", entry);
            if (entry != matrix(column, row))
                refuse(node, "cov is not symmetric: " + numberText(entry) +
                                 " differs from its mirror image " + numberText(matrix(column, row)));
            zero = zero && entry == 0;
        }
    if (!zero) node.append_attribute("cov") = text.c_str();
}

void setPoint(pugi::xml_node node, const mrpt::math::TPoint3D& point)
{
    setNumber(node, "x", point.x);
    setNumber(node, "y", point.y);
    setNumber(node, "z", point.z);
}

/** For UncertainPoint and UncertainNormal. */
template <class Uncertain>
void addUncertain(pugi::xml_node parent, const char* name, const Uncertain& value)
{
    const pugi::xml_node node = parent.append_child(name);
    setPoint(node, value.mean);
    setCovariance(node, value.covariance);
}

void addSize(pugi::xml_node parent, const PlaneSize& size)
{
    const pugi::xml_node node = parent.append_child("size");
    setNumber(node, "length", size.length_m);
    if (size.height_m) setNumber(node, "height", *size.height_m);
    setCovariance(node, size.covariance);
}

void addWords(pugi::xml_node parent, const std::vector<std::string>& words)
{
    pugi::xml_node list = parent.append_child("words");
    for (const std::string& word : words) {
        pugi::xml_node node = list.append_child("word");
        // A carriage return would be read back as a line feed: XML folds line ends in text.
        if (!isText(word) || word.find('\r') != std::string::npos)
            refuse(node, excerpt(word) + " must be UTF-8 without control characters");
        node.text() = word.c_str();
    }
}

void addBoundary(pugi::xml_node parent, const std::vector<mrpt::math::TPoint2D>& boundary)
{
    pugi::xml_node node = parent.append_child("boundary");
    std::string text;
    for (const auto& vertex : boundary)
        text += (text.empty() ? "" : " ") + finiteText(node, "x", vertex.x) + "," +
                finiteText(node, "y", vertex.y);
    if (!text.empty()) node.text() = text.c_str();
}

void addWall(pugi::xml_node parent, const Wall& wall)
{
    pugi::xml_node node = parent.append_child("wall");
    node.append_attribute("id") = wall.id;
    setFlag(node, "real", wall.real);
    addUncertain(node, "position", wall.position);
    addUncertain(node, "normal", wall.normal);
    addSize(node, wall.size);
    const pugi::xml_node curvature = node.append_child("curvature");
    setNumber(curvature, "length", wall.curvatureLength);
    setNumber(curvature, "height", wall.curvatureHeight);
}

void addView(pugi::xml_node parent, const View& view)
{
    pugi::xml_node node = parent.append_child("view");
    setText(node, "image", view.image);
    if (view.time_s != 0) setNumber(node, "time", view.time_s);
    addUncertain(node, "position", view.position);
    const pugi::xml_node aperture = node.append_child("aperture");
    setNumber(aperture, "x", view.apertureX_rad);
    setNumber(aperture, "y", view.apertureY_rad);
}

const char* kindName(pugi::xml_node node, PlaceKind kind)
{
    if (kind == PlaceKind::Room) return "room";
    if (kind == PlaceKind::Corridor) return "corridor";
    refuse(node, "kind = " + std::to_string(static_cast<int>(kind)) + " has no name");
}

const char* stateName(pugi::xml_node node, DoorState state)
{
    if (state == DoorState::Unknown) return "unknown";
    if (state == DoorState::Open) return "open";
    if (state == DoorState::Closed) return "closed";
    refuse(node, "state = " + std::to_string(static_cast<int>(state)) + " has no name");
}

void addPlace(pugi::xml_node parent, const Place& place)
{
    pugi::xml_node node = parent.append_child("place");
    node.append_attribute("id") = static_cast<unsigned>(place.id);
    node.append_attribute("kind") = kindName(node, place.kind);
    setNumber(node, "area", place.area_m2);
    addWords(node, place.words);
    setPoint(node.append_child("center"), place.center);
    addBoundary(node, place.boundary);
    const pugi::xml_node walls = node.append_child("walls");
    for (const Wall& wall : place.walls) addWall(walls, wall);
    const pugi::xml_node views = node.append_child("views");
    for (const View& view : place.views) addView(views, view);
}

void addConnection(pugi::xml_node parent, const Connection& connection)
{
    pugi::xml_node node = parent.append_child("connection");
    node.append_attribute("id") = connection.id;
    node.append_attribute("from") = static_cast<unsigned>(connection.from);
    node.append_attribute("to") = static_cast<unsigned>(connection.to);
    addWords(node, connection.words);
    pugi::xml_node doorway = node.append_child("doorway");
    setFlag(doorway, "real", connection.doorway.real);
    doorway.append_attribute("state") = stateName(doorway, connection.doorway.state);
    addUncertain(doorway, "position", connection.doorway.position);
    addSize(doorway, connection.doorway.size);
    if (connection.doorway.view) addView(doorway, *connection.doorway.view);
}

struct StringWriter : pugi::xml_writer
{
    std::string text;
    void write(const void* data, std::size_t size) override
    {
        text.append(static_cast<const char*>(data), size);
    }
};

std::string textOf(const pugi::xml_document& document)
{
    StringWriter writer;
    document.save(writer, "  ", pugi::format_indent | pugi::format_no_declaration, pugi::encoding_utf8);
    return writer.text;
}
}  // namespace

std::string toXml(const TopologicalMap& map)
{
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node root = document.append_child("topological_map");
    root.append_attribute("version") = "1.0";
    setText(root, "frame", map.frame);
    setNumber(root, "resolution", map.resolution_m);
    setText(root, "source", map.source);
    const pugi::xml_node places = root.append_child("places");
    for (const auto& [id, place] : map.places()) addPlace(places, place);
    const pugi::xml_node connections = root.append_child("connections");
    for (const Connection& connection : map.connections()) addConnection(connections, connection);
    return textOf(document);
}

std::string toXml(const Place& place)
{
    pugi::xml_document document;
    addPlace(document, place);
    return textOf(document);
}
}  // namespace gr2to
