#include <mrpt/config/CConfigFileBase.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "gr2to/pipeline/Gr2To.h"

namespace gr2to
{
std::vector<OptionField> TDistanceOptions::fields()
{
    return {{"unknown_is_obstacle", &unknown_is_obstacle, "",
             "Whether clearance is measured to unknown cells too, not to occupied ones alone."}};
}

std::vector<std::string> Gr2ToOptions::presets()
{
    return {"default", "paper"};
}

Gr2ToOptions Gr2ToOptions::preset(const std::string& name)
{
    Gr2ToOptions options;
    if (name == "paper") {
        options.compression.furniture_height = 0;
        options.cut.along_walls = false;
        options.filter.max_blob_area = 0;
        options.distance.unknown_is_obstacle =
            false;  // "the euclidean distance to the nearest occupied cell"
        options.place.meet_at_narrowest = false;
        options.place.min_depth = 1;
        options.place.narrow_opening = 0;
        options.place.lintel_width = 0;
        options.delimitation.corridor_elongation = 0;
        options.delimitation.outline_tolerance = 0;
        options.place.one_door_per_candidate = true;
    } else if (name != "default")
        throw std::invalid_argument("unknown preset '" + name + "'; did you mean '" +
                                    nearestWord(name, presets()) + "'?");
    return options;
}

std::vector<OptionTable*> Gr2ToOptions::tables()
{
    return {&compression, &wall, &filter, &distance, &door, &voronoi, &place, &cut, &delimitation};
}

void Gr2ToOptions::set(const std::string& key, const std::string& value)
{
    const auto dot = key.find('.');
    std::vector<std::string> known;
    for (OptionTable* table : tables())
        for (const OptionField& field : table->fields()) {
            known.push_back(table->section() + "." + field.name);
            if (known.back() == key) return table->set(key.substr(dot + 1), value);
        }
    throw std::invalid_argument("unknown option '" + key + "'; did you mean '" + nearestWord(key, known) +
                                "'?");
}

void Gr2ToOptions::loadFrom(const mrpt::config::CConfigFileBase& source)
{
    std::vector<std::string> sections;
    source.getAllSections(sections);
    for (const std::string& section : sections) {
        std::vector<std::string> keys;
        source.getAllKeys(section, keys);
        const std::string prefix = section + ".";
        for (const std::string& key : keys) set(prefix + key, source.read_string(section, key, ""));
    }
    check();
}

bool Gr2ToOptions::isIdle(const std::string& key) const
{
    static const std::set<std::string> onCircles{"place.door_support",
                                                 "place.one_door_per_candidate",
                                                 "place.min_radius",
                                                 "place.meet_at_narrowest",
                                                 "place.min_depth",
                                                 "place.narrow_opening",
                                                 "delimitation.corridor_radius_tolerance",
                                                 "delimitation.corridor_angle_tolerance"};
    static const std::set<std::string> onWalls{"filter.min_wall", "filter.min_aligned_wall",
                                               "filter.max_wall_thickness", "filter.max_lone_thickness"};
    if (cut.along_walls) return onCircles.count(key) > 0;
    const std::string section = key.substr(0, key.find('.'));
    return onWalls.count(key) > 0 || section == "wall" || (section == "cut" && key != "cut.along_walls");
}

void Gr2ToOptions::check()
{
    for (const OptionTable* table : tables()) table->check();
}
}  // namespace gr2to
