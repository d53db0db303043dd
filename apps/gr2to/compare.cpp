#include <cmath>
#include <iostream>
#include <optional>

#include "Command.h"
#include "TableOptions.h"
#include "describe.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/base/text.h"
#include "gr2to/compare/Comparison.h"
#include "gr2to/io/GridReader.h"
#include "gr2to/io/LabelImageReader.h"
#include "gr2to/io/ReferenceReader.h"
#include "gr2to/mrpt/archive.h"
#include "parse.h"

namespace gr2to::cli
{
namespace
{
namespace fs = std::filesystem;

const char* const PLACES = "places.png";

bool isPng(const fs::path& file)
{
    return readFile(file).rfind("\x89PNG", 0) == 0;
}

class Compare : public Command
{
 public:
    std::string name() const override { return "compare"; }
    std::string arguments() const override { return "MAP REFERENCE [options]"; }
    std::string summary() const override { return "score a topological map against an annotated one"; }
    std::string description() const override
    {
        return "Scores MAP against REFERENCE: how well places match rooms, and doors and connections match "
               "the "
               "annotated ones. Shares go from 0 to 1, 1 is best; lengths are in metres.\n\n"
               "MAP is a folder that 'gr2to extract' wrote, a topomap.xml or .gr2to with places.png beside "
               "it, or a "
               "places.png alone, of which only the places are scored. REFERENCE is NAME.gt_labels.png, with "
               "NAME.gt.json beside it when doors are annotated.\n\n"
               "Scores on free cells need the grid that the map was made from: give it with --grid, and with "
               "--resolution when it is a bare image. It also tells where the map frame lies in the image; "
               "without "
               "it, the frame's origin is taken to be the image's bottom-left corner.";
    }
    void declare(CLI::App& app) override
    {
        addOption(app, "MAP", m_map, "", "The map to score.")->required();
        addOption(app, "REFERENCE", m_reference, "", "The annotated map.")->required();
        addOption(app, "--places", m_places, "FILE",
                  "Image of the places. (default: places.png in the folder of MAP)");
        addOption(app, "--grid", m_grid, "FILE", "The grid that the map was made from. (default: none)");
        app.add_flag("--json", m_json, "Print JSON instead of text.");
        m_tables.declare(app);
    }
    int run() override;

 private:
    std::optional<fs::path> mapFile() const;
    fs::path placesFile(const std::optional<fs::path>& file) const;
    std::optional<ClassifiedGrid> readFreeCells() const;
    GridFrame frameOf(const TopologicalMap& map, const std::optional<ClassifiedGrid>& grid,
                      const ReferenceAnnotation& reference) const;

    std::string m_map;
    std::string m_reference;
    std::string m_places;
    std::string m_grid;
    bool m_json = false;
    TGridReaderOptions m_reader;
    TableOptions m_tables{{&m_reader, &m_reader.scans}};
};

/** The file of the topological map; none when only places are there. */
std::optional<fs::path> Compare::mapFile() const
{
    const fs::path map = m_map;
    std::error_code ignored;
    if (fs::is_directory(map, ignored)) {
        const bool onlyPlaces = fs::exists(map / PLACES, ignored) &&
                                !fs::exists(map / "topomap.xml", ignored) &&
                                !fs::exists(map / "topomap.gr2to", ignored);
        return onlyPlaces ? std::nullopt : std::optional(mapFileIn(map));
    }
    return isPng(map) ? std::nullopt : std::optional(map);
}

std::optional<ClassifiedGrid> Compare::readFreeCells() const
{
    if (!m_grid.empty()) return readGrid(m_grid, m_reader);
    if (m_tables.given())
        throw InputError(
            "options for reading a grid are given without a grid; add --grid FILE or remove them");
    return {};
}

GridFrame Compare::frameOf(const TopologicalMap& map, const std::optional<ClassifiedGrid>& grid,
                           const ReferenceAnnotation& reference) const
{
    const auto requireSame = [&](double resolution, const std::string& file) {
        constexpr double TOLERANCE = 1e-6;
        if (std::abs(resolution - map.resolution_m) > TOLERANCE * map.resolution_m)
            throw InputError("the map was made at " + numberText(map.resolution_m) + " m a cell, but '" +
                             file + "' has " + numberText(resolution) + " m; they must agree");
    };
    if (reference.interfaces) requireSame(reference.resolution_m, m_reference);
    if (!grid) return GridFrame{map.resolution_m, 0, 0, 0};
    requireSame(grid->resolution_m(), m_grid);
    return grid->frame();
}

fs::path Compare::placesFile(const std::optional<fs::path>& file) const
{
    std::error_code ignored;
    fs::path map = m_map;
    const bool isImage = !file && !fs::is_directory(map, ignored);
    if (!m_places.empty() && isImage)
        throw InputError("'" + m_map + "' is an image of places already; remove --places");
    if (!m_places.empty()) return m_places;
    if (isImage) return map;
    fs::path beside = (file ? file->parent_path() : map) / PLACES;
    if (!fs::exists(beside, ignored))
        throw InputError("'" + m_map + "' has no places.png beside it; name the image with --places FILE");
    return beside;
}

int Compare::run()
{
    m_tables.apply();
    const auto file = mapFile();
    const PlaceImage places = readLabelImage(placesFile(file)).labels;
    ReferenceAnnotation reference = readReference(m_reference);
    const auto grid = readFreeCells();
    PredictedGraph graph;
    if (file) {
        const TopologicalMap map = loadTopologicalMap(*file);
        graph = predictedGraph(map, frameOf(map, grid, reference), places.height);
    } else
        reference.interfaces.reset();  // places alone say nothing about doors
    const ComparisonScores scores = compareMaps(places, graph, reference, grid ? &*grid : nullptr);
    std::cout << (m_json ? toJson(scores) : toText(scores));
    return kDone;
}
}  // namespace

std::unique_ptr<Command> makeCompare()
{
    return std::make_unique<Compare>();
}
}  // namespace gr2to::cli
