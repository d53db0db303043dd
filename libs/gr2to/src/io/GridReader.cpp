#include "gr2to/io/GridReader.h"

#include <mrpt/obs/CRawlog.h>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "io/Gridmap.h"
#include "io/PgmReader.h"
#include "io/PngReader.h"
#include "io/RosYaml.h"
#include "io/SimplemapReader.h"
#include "io/errorText.h"
#include "io/formats.h"

namespace gr2to
{
namespace fs = std::filesystem;

namespace
{
constexpr double kRosFree = 0.196;
constexpr double kRosOccupied = 0.65;
constexpr double kFreeByOneRay = 0.4;
constexpr double kScanResolution = 0.05;

std::optional<bool> negateOf(const TGridReaderOptions& options)
{
    if (options.negate == "auto") return {};
    return options.negate == "yes";
}

std::optional<io::ImageMode> modeOf(const TGridReaderOptions& options)
{
    if (options.mode == "auto") return {};
    return io::imageModeOf(options.mode);
}

void requireOrder(double free, double occupied, const std::string& name)
{
    if (free > occupied)
        throw InputError(name + ": the free threshold " + io::numberText(free) +
                         " exceeds the occupied threshold " + io::numberText(occupied) +
                         "; it must not (in the file: free_thresh, occupied_thresh)");
}

ClassifiedGrid readImage(io::Format format, std::string_view bytes, const std::string& name,
                         const io::ImageRule& rule, const GridFrame& frame)
{
    return format == io::Format::Png ? io::readPng(bytes, name, rule, frame)
                                     : io::readPgm(bytes, name, rule, frame);
}

const char* formatName(io::Format format)
{
    switch (format) {
        case io::Format::Png:
            return "PNG image";
        case io::Format::Pgm:
            return "PGM image";
        case io::Format::Gridmap:
            return "MRPT grid map";
        case io::Format::Simplemap:
            return "MRPT simplemap";
        default:
            return "ROS map_server YAML";
    }
}

ClassifiedGrid readBareImage(io::Format format, const std::string& bytes, const std::string& name,
                             const TGridReaderOptions& options, GridSource& source)
{
    if (!options.resolution)
        throw InputError(name +
                         " is a bare image, which does not state its resolution; give it in metres per cell "
                         "(--resolution 0.05) or name its ROS .yaml file");
    io::ImageRule rule;
    rule.occupied_threshold = source.occupied_threshold = options.occupied_threshold.value_or(kRosOccupied);
    rule.free_threshold = source.free_threshold = options.free_threshold.value_or(kRosFree);
    rule.negate = negateOf(options).value_or(false);
    rule.mode = modeOf(options).value_or(io::ImageMode::Trinary);
    rule.unknown_grey = options.unknown_grey;
    requireOrder(rule.free_threshold, rule.occupied_threshold, name);
    return readImage(format, bytes, name, rule, GridFrame{*options.resolution, 0.0, 0.0, 0.0});
}

/** What the user gave, else what the file states; ROS requires the key, and so does this reader. */
template <class T>
T givenOrStated(const std::optional<T>& given, const std::optional<T>& stated, const char* key,
                const char* example, const std::string& name)
{
    if (given) return *given;
    if (stated) return *stated;
    throw InputError(name + " lacks the key '" + key + "'; add a line such as '" + key + ": " + example +
                     "'");
}

ClassifiedGrid readYaml(const std::string& text, const fs::path& path, const TGridReaderOptions& options,
                        GridSource& source)
{
    const std::string name = io::pathInQuotes(path);
    const auto yaml = io::parseRosYaml(text, path);
    GridFrame frame{0.0, yaml.origin_x_m, yaml.origin_y_m, yaml.yaw_rad};
    frame.resolution_m = givenOrStated(options.resolution, yaml.resolution_m, "resolution", "0.05", name);
    io::ImageRule rule;
    rule.occupied_threshold =
        givenOrStated(options.occupied_threshold, yaml.occupied_threshold, "occupied_thresh", "0.65", name);
    rule.free_threshold =
        givenOrStated(options.free_threshold, yaml.free_threshold, "free_thresh", "0.196", name);
    rule.negate = givenOrStated(negateOf(options), yaml.negate, "negate", "0", name);
    rule.mode = modeOf(options).value_or(yaml.mode.value_or(io::ImageMode::Trinary));
    rule.unknown_grey = options.unknown_grey;
    requireOrder(rule.free_threshold, rule.occupied_threshold, name);
    source.image = yaml.image;
    source.occupied_threshold = rule.occupied_threshold;
    source.free_threshold = rule.free_threshold;
    try {
        const std::string bytes = readFile(yaml.image);
        const auto format = io::formatOf(bytes, yaml.image);
        if (format != io::Format::Png && format != io::Format::Pgm)
            throw InputError(io::pathInQuotes(yaml.image) + " is no PNG or PGM image");
        return readImage(format, bytes, io::pathInQuotes(yaml.image), rule, frame);
    } catch (const InputError& e) {
        throw InputError(name + ": its image " + e.what());
    }
}

/** What the options say, else the defaults; of options for images none may be given. */
OccupancyThresholds thresholdsOf(const TGridReaderOptions& options, OccupancyThresholds thresholds,
                                 const std::string& name, GridSource& source)
{
    const auto refuse = [&](const std::string& option) {
        throw InputError(name + " is an " + source.format + ", to which input." + option +
                         " does not apply; remove the option");
    };
    if (options.negate != "auto") refuse("negate");
    if (options.mode != "auto") refuse("mode");
    thresholds.occupied = source.occupied_threshold =
        options.occupied_threshold.value_or(thresholds.occupied);
    thresholds.free = source.free_threshold = options.free_threshold.value_or(thresholds.free);
    requireOrder(thresholds.free, thresholds.occupied, name);
    return thresholds;
}

ClassifiedGrid readScans(const std::string& bytes, const fs::path& path, const TGridReaderOptions& options,
                         GridSource& source)
{
    const std::string name = io::pathInQuotes(path);
    const OccupancyThresholds thresholds =
        thresholdsOf(options, {OccupancyThresholds().occupied, kFreeByOneRay}, name, source);
    options.scans.loadPlugins();
    const auto map = io::readSimplemap(bytes, name);
    ClassifiedGrid grid = io::gridOfSimplemap(map, name, options.resolution.value_or(kScanResolution),
                                              options.scans, thresholds, source.scans.emplace());
    const fs::path images =
        options.scans.imagesFolder.empty() ? imagesFolderOf(path) : options.scans.imagesFolder;
    if (options.scans.views) source.views = viewsOf(map, images, source.scans->missingImages);
    return grid;
}

ClassifiedGrid readArchive(const std::string& bytes, const std::string& name,
                           const TGridReaderOptions& options, GridSource& source)
{
    const OccupancyThresholds thresholds = thresholdsOf(options, {}, name, source);
    auto grid = io::readGridmap(bytes, name, thresholds);
    if (options.resolution && *options.resolution != grid.resolution_m())
        throw InputError(name + " states its own resolution, " + io::numberText(grid.resolution_m()) +
                         " m, but input.resolution is " + io::numberText(*options.resolution) +
                         " m; remove the option");
    return grid;
}
}  // namespace

std::vector<OptionField> TGridReaderOptions::fields()
{
    return {
        {"resolution", &resolution, "m",
         "Side of a cell; auto: what the file states, 0.05 for a simplemap. A bare image needs it.", 1e-4,
         100},
        {"occupied_threshold", &occupied_threshold, "ratio",
         "A cell is occupied when its occupancy probability exceeds this; auto: what the YAML file states, "
         "else 0.65.",
         0, 1},
        {"free_threshold", &free_threshold, "ratio",
         "A cell is free when its occupancy probability is below this; auto: what the YAML file states, else "
         "0.196 "
         "for images, 0.35 for MRPT grids and 0.4 for simplemaps.",
         0, 1},
        {"negate",
         &negate,
         "",
         "Whether white is occupied; auto: what the YAML file states, else no.",
         0,
         0,
         {"auto", "yes", "no"}},
        {"mode",
         &mode,
         "",
         "How greys become occupancy, as in ROS; auto: what the YAML file states, else trinary.",
         0,
         0,
         {"auto", "trinary", "scale", "raw"}},
        {"unknown_grey", &unknown_grey, "",
         "Grey that is unknown in trinary images whatever the thresholds, as map savers write it; -1: none.",
         -1, 255}};
}

void TGridReaderOptions::checkRules() const
{
    if (occupied_threshold && free_threshold && *free_threshold > *occupied_threshold)
        throw std::invalid_argument(
            "input.free_threshold = " + io::numberText(*free_threshold) +
            " must not exceed input.occupied_threshold = " + io::numberText(*occupied_threshold));
}

ClassifiedGrid readGrid(const fs::path& path, const TGridReaderOptions& options, GridSource* source)
{
    options.check();
    options.scans.check();
    GridSource ignored;
    GridSource& told = source != nullptr ? *source : ignored;
    told = GridSource{};
    const std::string bytes = readFile(path);
    const auto format = io::formatOf(bytes, path);
    told.format = formatName(format);
    switch (format) {
        case io::Format::Yaml:
            return readYaml(bytes, path, options, told);
        case io::Format::Gridmap:
            return readArchive(bytes, io::pathInQuotes(path), options, told);
        case io::Format::Simplemap:
            return readScans(bytes, path, options, told);
        default:
            return readBareImage(format, bytes, io::pathInQuotes(path), options, told);
    }
}

fs::path imagesFolderOf(const fs::path& file)
{
    const fs::path folder = mrpt::obs::CRawlog::detectImagesDirectory(file.string());
    std::error_code ignored;
    return fs::is_directory(folder, ignored) ? folder : file.parent_path();
}

bool isRawlog(const fs::path& path)
{
    return io::archiveKind(readFile(path), io::pathInQuotes(path)) == "a rawlog";
}

void requireUsable(const ClassifiedGrid& grid, const std::string& name)
{
    const std::string quotedName = io::inQuotes(name);
    if (grid.width() < 2 || grid.height() < 2)
        throw InputError(quotedName + " has " + std::to_string(grid.width()) + " x " +
                         std::to_string(grid.height()) +
                         " cells; a map needs at least 2 x 2: check that it is the right file");
    const bool anyFree = grid.count(CellState::Free) > 0;
    const bool anyOccupied = grid.count(CellState::Occupied) > 0;
    const char* remedy = "check input.negate, input.occupied_threshold and input.free_threshold";
    if (!anyFree && !anyOccupied)
        throw InputError(quotedName + " has only unknown cells; places need free cells and walls: " + remedy);
    if (!anyFree)
        throw InputError(quotedName +
                         " has no free cell (all are occupied or unknown), hence no place: " + remedy);
    if (!anyOccupied)
        throw InputError(quotedName +
                         " has no occupied cell (all are free or unknown), hence no wall: " + remedy);
}
}  // namespace gr2to
