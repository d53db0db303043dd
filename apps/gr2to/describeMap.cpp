#include <set>

#include "ExtractReport.h"
#include "TextTable.h"
#include "describe.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/text.h"
#include "json.h"

namespace gr2to::cli
{
namespace
{
const char* nameOf(PlaceKind kind)
{
    return kind == PlaceKind::Corridor ? "corridor" : "room";
}

std::set<PlaceId> neighboursOf(const TopologicalMap& map, PlaceId id)
{
    std::set<PlaceId> ids;
    for (const Connection& c : map.connectionsOf(id)) ids.insert(c.from == id ? c.to : c.from);
    return ids;
}

std::string joined(const std::vector<std::string>& texts)
{
    std::string all;
    for (const auto& text : texts) all += (all.empty() ? "" : ", ") + text;
    return all;
}

struct Totals
{
    double area_m2 = 0;
    std::size_t realWalls = 0;
    std::size_t virtualWalls = 0;
    std::size_t words = 0;
};

Totals totalsOf(const TopologicalMap& map)
{
    Totals totals;
    for (const auto& [id, place] : map.places()) {
        totals.area_m2 += place.area_m2;
        totals.words += place.words.size();
        for (const Wall& wall : place.walls) ++(wall.real ? totals.realWalls : totals.virtualWalls);
    }
    return totals;
}

std::string placesTable(const TopologicalMap& map)
{
    TextTable table({{"id", true},
                     {"kind", false},
                     {"area m2", true},
                     {"x m", true},
                     {"y m", true},
                     {"words", false},
                     {"connected to", false}});
    for (const auto& [id, place] : map.places()) {
        std::vector<std::string> neighbours;
        for (const PlaceId other : neighboursOf(map, id)) neighbours.push_back(std::to_string(other));
        table.row({std::to_string(id), nameOf(place.kind), fixedText(place.area_m2, 2),
                   fixedText(place.center.x, 2), fixedText(place.center.y, 2), joined(place.words),
                   joined(neighbours)});
    }
    return table.text();
}

std::string connectionsTable(const TopologicalMap& map)
{
    TextTable table({{"id", true},
                     {"from", true},
                     {"to", true},
                     {"kind", false},
                     {"width m", true},
                     {"x m", true},
                     {"y m", true},
                     {"words", false}});
    for (const Connection& c : map.connections()) {
        const Doorway& door = c.doorway;
        table.row({std::to_string(c.id), std::to_string(c.from), std::to_string(c.to),
                   door.real ? "door" : "opening", fixedText(door.size.length_m, 2),
                   fixedText(door.position.mean.x, 2), fixedText(door.position.mean.y, 2), joined(c.words)});
    }
    return table.text();
}

Json placesJson(const TopologicalMap& map)
{
    Json places = Json::array();
    for (const auto& [id, place] : map.places()) {
        Json one = {{"id", id},
                    {"kind", nameOf(place.kind)},
                    {"area_m2", place.area_m2},
                    {"center_m", {place.center.x, place.center.y, place.center.z}},
                    {"words", place.words},
                    {"walls", place.walls.size()},
                    {"neighbours", neighboursOf(map, id)}};
        places.push_back(std::move(one));
    }
    return places;
}

Json connectionsJson(const TopologicalMap& map)
{
    Json connections = Json::array();
    for (const Connection& c : map.connections()) {
        const auto& door = c.doorway;
        connections.push_back(
            {{"id", c.id},
             {"from", c.from},
             {"to", c.to},
             {"real", door.real},
             {"width_m", door.size.length_m},
             {"position_m", {door.position.mean.x, door.position.mean.y, door.position.mean.z}},
             {"words", c.words}});
    }
    return connections;
}
}  // namespace

std::string mapText(const std::filesystem::path& file, const TopologicalMap& map)
{
    const MapCounts counts(map);
    const Totals totals = totalsOf(map);
    std::string text =
        file.string() + ": topological map\n" + "  made from   " +
        (map.source.empty() ? "unknown" : map.source) + ", " + numberText(map.resolution_m) + " m a cell\n" +
        "  frame       " + map.frame + "\n" + "  places      " + std::to_string(counts.places) + " of " +
        fixedText(totals.area_m2, 2) + " m2: " + countText(counts.rooms, "room") + ", " +
        countText(counts.corridors, "corridor") + "; words: " + std::to_string(totals.words) + "\n" +
        "  connections " + std::to_string(counts.doors + counts.openings) + ": " +
        countText(counts.doors, "door") + ", " + countText(counts.openings, "opening") + "\n" +
        "  walls       " + std::to_string(totals.realWalls + totals.virtualWalls) + ": " +
        std::to_string(totals.realWalls) + " real, " + std::to_string(totals.virtualWalls) + " virtual\n";
    if (counts.places > 0) text += "\nPlaces\n" + placesTable(map);
    if (counts.doors + counts.openings > 0) text += "\nConnections\n" + connectionsTable(map);
    return text;
}

std::string mapJson(const std::filesystem::path& file, const TopologicalMap& map)
{
    const MapCounts counts(map);
    const Totals totals = totalsOf(map);
    return jsonText({{"file", file.string()},
                     {"kind", "topological map"},
                     {"source", map.source},
                     {"frame", map.frame},
                     {"resolution_m", map.resolution_m},
                     {"rooms", counts.rooms},
                     {"corridors", counts.corridors},
                     {"area_m2", totals.area_m2},
                     {"doors", counts.doors},
                     {"openings", counts.openings},
                     {"real_walls", totals.realWalls},
                     {"virtual_walls", totals.virtualWalls},
                     {"places", placesJson(map)},
                     {"connections", connectionsJson(map)}});
}

std::filesystem::path mapFileIn(const std::filesystem::path& path)
{
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored)) return path;
    for (const char* name : {"topomap.xml", "topomap.gr2to"})
        if (std::filesystem::exists(path / name, ignored)) return path / name;
    throw InputError("'" + path.string() +
                     "' is a folder without topomap.xml; name a file, or a folder that "
                     "'gr2to extract' wrote");
}
}  // namespace gr2to::cli
