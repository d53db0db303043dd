#include "ExtractReport.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "TextTable.h"
#include "gr2to/base/text.h"
#include "json.h"

namespace gr2to::cli
{
namespace
{
constexpr double MEGA = 1e6;

std::string countsText(const StageReport& stage)
{
    std::string text;
    for (const auto& [name, count] : stage.counts)
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + name;
    return text;
}

double secondsOf(const std::vector<StageReport>& stages)
{
    return std::accumulate(stages.begin(), stages.end(), 0.0,
                           [](double sum, const StageReport& stage) { return sum + stage.seconds; });
}

/** Most memory that the process has held so far, program and libraries included [bytes]. */
std::size_t peakMemory()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

std::string rangeText(const CompressedRange& range)
{
    const auto origin = [](bool found, const char* surface) {
        return std::string(found ? " (" : " (no ") + surface + (found ? " found)" : " used)");
    };
    return "compressed from z = " + fixedText(range.z_min_m, 3) + " m" + origin(range.floorFound, "floor") +
           " to " + fixedText(range.z_max_m, 3) + " m" + origin(range.ceilingFound, "ceiling") + "\n";
}

Json rangeJson(const CompressedRange& range)
{
    return {{"z_min_m", range.z_min_m},
            {"z_max_m", range.z_max_m},
            {"floor_found", range.floorFound},
            {"ceiling_found", range.ceilingFound}};
}

Json optionsJson(const std::vector<OptionTable*>& tables)
{
    Json json;
    for (OptionTable* table : tables)
        for (const OptionField& field : table->fields())
            json[table->section()][field.name] = valueJson(field);
    return json;
}

Json stagesJson(const std::vector<StageReport>& stages)
{
    Json json = Json::array();
    for (const StageReport& stage : stages) {
        Json counts = Json::object();
        for (const auto& [name, count] : stage.counts) counts[name] = count;
        json.push_back({{"stage", stage.stage},
                        {"counts", counts},
                        {"milliseconds", stage.seconds * 1e3},
                        {"bytes", stage.bytes}});
    }
    return json;
}
}  // namespace

MapCounts::MapCounts(const TopologicalMap& map) : places(map.places().size())
{
    for (const auto& [id, place] : map.places()) ++(place.kind == PlaceKind::Corridor ? corridors : rooms);
    for (const Connection& connection : map.connections()) ++(connection.doorway.real ? doors : openings);
}

void ExtractReport::noteProgramMemory()
{
    m_programBytes = peakMemory();
}

void ExtractReport::noteStagesMemory()
{
    m_stagesBytes = peakMemory();
}

double ExtractReport::bytesPerCell() const
{
    const auto cells = static_cast<double>(m_width) * m_height;
    return static_cast<double>(m_stagesBytes - m_programBytes) / cells;
}

void ExtractReport::describe(const ClassifiedGrid& grid, const TopologicalMap& map)
{
    m_width = grid.width();
    m_height = grid.height();
    m_frame = grid.frame();
    m_counts = MapCounts(map);
}

std::string ExtractReport::text() const
{
    TextTable table({{"stage", false}, {"found", false}, {"ms", true}, {"MB", true}});
    for (const StageReport& stage : stages)
        table.row({stage.stage, countsText(stage), fixedText(stage.seconds * 1e3, 1),
                   fixedText(static_cast<double>(stage.bytes) / MEGA, 2)});
    table.row({"total", "", fixedText(secondsOf(stages) * 1e3, 1), ""});
    const auto megabytes = [](std::size_t bytes) {
        return fixedText(static_cast<double>(bytes) / MEGA, 0) + " MB";
    };
    std::string text = format + ", " + std::to_string(m_width) + " x " + std::to_string(m_height) +
                       " cells of " + numberText(m_frame.resolution_m) + " m, preset " + preset + "\n" +
                       (range ? rangeText(*range) : "") + "\n" + table.text() + "peak memory " +
                       megabytes(peakMemory()) + "; " + megabytes(m_stagesBytes) + " before drawing, " +
                       megabytes(m_programBytes) + " before reading: " + fixedText(bytesPerCell(), 1) +
                       " bytes a cell\n\n";
    text += countText(m_counts.rooms, "room") + ", " + countText(m_counts.corridors, "corridor") + ", " +
            countText(m_counts.doors, "door") + ", " + countText(m_counts.openings, "opening") + "\n";
    text += "Written to '" + folder.string() + "':";
    for (const auto& file : files) text += " " + file.filename().string();
    return text + "\nOpen '" + (folder / "overlay.svg").string() + "' in a browser to see them.\n";
}

std::string ExtractReport::json() const
{
    Json json;
    json["input"] = input;
    json["grid"] = frameJson(format, m_width, m_height, m_frame);
    json["preset"] = preset;
    if (range) json["compression"] = rangeJson(*range);
    json["options"] = optionsJson(options);
    json["stages"] = stagesJson(stages);
    json["milliseconds"] = secondsOf(stages) * 1e3;
    json["memory"] = {{"peak_bytes", peakMemory()},
                      {"before_drawing_bytes", m_stagesBytes},
                      {"before_reading_bytes", m_programBytes},
                      {"bytes_per_cell", bytesPerCell()}};
    json["places"] = m_counts.places;
    json["rooms"] = m_counts.rooms;
    json["corridors"] = m_counts.corridors;
    json["doors"] = m_counts.doors;
    json["openings"] = m_counts.openings;
    json["files"] = Json::array();
    for (const auto& file : files) json["files"].push_back(file.string());
    return jsonText(json);
}
}  // namespace gr2to::cli
