#include <cmath>

#include "TextTable.h"
#include "describe.h"
#include "gr2to/base/text.h"
#include "json.h"

namespace gr2to::cli
{
namespace
{
struct StateCount
{
    const char* name;
    std::size_t cells;
    double share;
    double area_m2;
};

std::vector<StateCount> statesOf(const ClassifiedGrid& grid)
{
    std::vector<StateCount> states = {{"free", grid.count(CellState::Free), 0, 0},
                                      {"occupied", grid.count(CellState::Occupied), 0, 0},
                                      {"unknown", grid.count(CellState::Unknown), 0, 0}};
    const double cellArea = grid.resolution_m() * grid.resolution_m();
    for (StateCount& state : states) {
        state.share = static_cast<double>(state.cells) / static_cast<double>(grid.size());
        state.area_m2 = static_cast<double>(state.cells) * cellArea;
    }
    return states;
}

std::string line(const std::string& name, const std::string& text)
{
    constexpr std::size_t WIDTH = 12;
    return "  " + name + std::string(WIDTH - name.size(), ' ') + text + "\n";
}

std::string scansText(const ScanCounts& scans)
{
    return std::to_string(scans.keyframes) + ", " + std::to_string(scans.inserted) + " of " +
           std::to_string(scans.observations) + " observations inserted";
}
}  // namespace

std::string gridText(const std::filesystem::path& file, const ClassifiedGrid& grid, const GridSource& source)
{
    const GridFrame& frame = grid.frame();
    std::string text =
        file.string() + ": occupancy grid\n" +
        line("format", source.format + (source.image.empty() ? "" : " of '" + source.image.string() + "'")) +
        (source.scans ? line("keyframes", scansText(*source.scans)) : "") +
        line("size", std::to_string(grid.width()) + " x " + std::to_string(grid.height()) + " cells") +
        line("resolution", numberText(frame.resolution_m) + " m a cell") +
        line("extent", fixedText(grid.width() * frame.resolution_m, 2) + " x " +
                           fixedText(grid.height() * frame.resolution_m, 2) + " m") +
        line("origin", "x " + numberText(frame.origin_x_m) + " m, y " + numberText(frame.origin_y_m) +
                           " m, yaw " + fixedText(frame.yaw_rad * 180 / M_PI, 2) +
                           " deg (corner of the bottom-left cell)");
    for (const StateCount& state : statesOf(grid))
        text += line(state.name, std::to_string(state.cells) + " cells, " + fixedText(100 * state.share, 1) +
                                     " %, " + fixedText(state.area_m2, 2) + " m2");
    return text + line("thresholds", "occupied above " + numberText(source.occupied_threshold) +
                                         ", free below " + numberText(source.free_threshold));
}

std::string gridJson(const std::filesystem::path& file, const ClassifiedGrid& grid, const GridSource& source)
{
    Json json = {{"file", file.string()}, {"kind", "grid"}};
    json.update(frameJson(source.format, grid.width(), grid.height(), grid.frame()));
    if (!source.image.empty()) json["image"] = source.image.string();
    if (source.scans)
        json["scans"] = {{"keyframes", source.scans->keyframes},
                         {"observations", source.scans->observations},
                         {"inserted", source.scans->inserted}};
    json["extent_m"] = {grid.width() * grid.resolution_m(), grid.height() * grid.resolution_m()};
    for (const StateCount& state : statesOf(grid))
        json[state.name] = {{"cells", state.cells}, {"share", state.share}, {"area_m2", state.area_m2}};
    json["occupied_threshold"] = source.occupied_threshold;
    json["free_threshold"] = source.free_threshold;
    return jsonText(json);
}
}  // namespace gr2to::cli
