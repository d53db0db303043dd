#include <chrono>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "Command.h"
#include "ExtractFiles.h"
#include "ExtractReport.h"
#include "MappedRawlog.h"
#include "Progress.h"
#include "TableOptions.h"
#include "ViewFiles.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/base/text.h"
#include "gr2to/io/PngWriter.h"
#include "gr2to/io/XmlMap.h"
#include "gr2to/mrpt/archive.h"
#include "gr2to/mrpt/simplemap.h"
#include "parse.h"
#include "readInput.h"

namespace gr2to::cli
{
namespace
{
namespace fs = std::filesystem;

/** `office` for `maps/office.gridmap.gz`. */
fs::path baseName(const fs::path& input)
{
    const fs::path name = input.filename();
    return name.extension() == ".gz" ? name.stem().stem() : name.stem();
}

/** A file's name as the map can store it: a byte that text cannot hold becomes '?'. */
std::string storableName(const fs::path& path)
{
    std::string name = path.filename().string();
    for (std::size_t good = textPrefix(name); good < name.size(); good = textPrefix(name)) name[good] = '?';
    if (hasControlCharacter(name))
        for (char& c : name)
            if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    return name;
}

/** Adds rows for what the application does around the pipeline. */
class Stopwatch
{
 public:
    /** \return seconds since the last call */
    double lap()
    {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double> passed = now - m_last;
        m_last = now;
        return passed.count();
    }

 private:
    std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

void requireValid(const TopologicalMap& map)
{
    const auto findings = map.validate();
    if (!findings.empty())
        throw std::logic_error("internal error, please report it: the map that was made is not valid: " +
                               findings.front());
}

class Extract : public Command
{
 public:
    std::string name() const override { return "extract"; }
    std::string arguments() const override { return "INPUT [options]"; }
    std::string summary() const override { return "make a topological map from an occupancy grid"; }
    std::string description() const override
    {
        return "Turns an occupancy grid into a topological map of places, doors and walls. INPUT is told by "
               "its content: a ROS map_server .yaml, a PNG or PGM image (with --resolution), an MRPT "
               ".gridmap "
               "or .simplemap, each also as .gz, an MRPT rawlog, which the program gr2to-rawlog maps first, "
               "or an "
               "OctoMap .bt or .ot, which is compressed to a grid first: between floor and ceiling, or "
               "--z-min and "
               "--z-max.\n\n"
               "Into DIR go topomap.xml (the map), topomap.gr2to (the same as an MRPT archive), "
               "topomap.simplemap (a keyframe with a scan for each place, for MRPT's tools), places.png "
               "(16 bits "
               "a pixel: 0 is no place, else a place's id; same size and orientation as the grid), "
               "overlay.png and "
               "overlay.svg (pictures). They appear together, when all are made, and replace older ones.\n\n"
               "Every option of the method has a default; a preset replaces the defaults, a configuration "
               "file "
               "the preset's values, and options on the command line win over both. All lengths are in "
               "metres.";
    }
    void declare(CLI::App& app) override;
    int run() override;

 private:
    void noteIdleOptions() const;
    InputMap read(const ExtractFiles& output, Progress& progress);
    InputMap readAfterMapping(Progress& progress);
    Extraction extract(const CompressedGrid& input, Progress& progress);
    void write(const ClassifiedGrid& grid, Extraction& extraction, ExtractFiles& output, Progress& progress);

    std::string m_input;
    std::string m_folder;
    std::string m_rawlogConfig;
    std::string m_preset = Gr2ToOptions::presets().front();
    bool m_json = false;
    bool m_quiet = false;
    TGridReaderOptions m_reader;
    Gr2ToOptions m_stages;
    TSimplemapOptions m_simplemap;
    TOverlayOptions m_overlay;
    std::unique_ptr<TableOptions> m_tables;
    ExtractReport m_report;
    Stopwatch m_watch;
    std::vector<CapturedView> m_views;
    std::vector<std::pair<std::string, std::string>> m_viewFiles;
};

void Extract::declare(CLI::App& app)
{
    addOption(app, "INPUT", m_input, "", "The grid, see above.")->required();
    addOption(app, "-o,--output", m_folder, "DIR",
              "Folder to write into; made when missing. (default: INPUT's name without folder and extension, "
              "in the current folder)");
    std::string names;
    for (const auto& preset : Gr2ToOptions::presets()) names += (names.empty() ? "" : "|") + preset;
    addOption(
        app, "--preset", m_preset, names,
        "Values of the options that are not given; paper follows the Gr2To paper to the letter. (default: " +
            m_preset + ")");
    addOption(app, "--rawlog-config", m_rawlogConfig, "FILE",
              "How gr2to-rawlog maps a rawlog: an ini file as MRPT's icp-slam reads it.");
    app.add_flag("--json", m_json, "Print a summary as JSON instead of the table.");
    app.add_flag("-q,--quiet", m_quiet, "Print neither table nor progress.");
    std::vector<OptionTable*> tables = m_stages.tables();
    tables.insert(tables.begin(), {&m_reader, &m_reader.scans});
    tables.insert(tables.end(), {&m_simplemap, &m_overlay});
    m_tables = std::make_unique<TableOptions>(tables);
    m_tables->declare(app);
    m_report.options = tables;
}

int Extract::run()
{
    m_stages = Gr2ToOptions::preset(m_preset);
    m_tables->apply();
    if (!m_quiet) noteIdleOptions();
    const fs::path folder = m_folder.empty() ? baseName(m_input) : fs::path(m_folder);
    if (m_folder.empty() && fs::exists(folder) && !fs::is_directory(folder))
        throw InputError("the default output folder '" + folder.string() +
                         "' is a file already; choose another folder with -o DIR");
    m_report.input = m_input;
    m_report.preset = m_preset;
    m_report.folder = folder;
    Progress progress(!m_quiet);
    ExtractFiles output(folder);
    const InputMap input = read(output, progress);
    const ClassifiedGrid& grid = input.map.grid;
    Extraction extraction = extract(input.map, progress);
    write(grid, extraction, output, progress);
    m_report.describe(grid, extraction.map);
    m_report.files = output.paths();
    if (m_json)
        std::cout << m_report.json();
    else if (!m_quiet)
        std::cout << m_report.text();
    return kDone;
}

/** Who gives an option that does nothing wants to know. */
void Extract::noteIdleOptions() const
{
    for (const std::string& name : m_tables->names())
        if (m_stages.isIdle(name))
            std::cerr << "gr2to: note: '" << name << "' has no effect while cut.along_walls is "
                      << (m_stages.cut.along_walls ? "yes" : "no") << '\n';
}

InputMap Extract::read(const ExtractFiles& output, Progress& progress)
{
    progress.step("reading " + baseName(m_input).string());
    m_report.noteProgramMemory();
    output.spare(m_input);
    InputMap input = readAfterMapping(progress);
    m_views = std::move(input.views);
    output.spare(input.image);
    m_report.format = input.format;
    m_report.range = input.range;
    m_report.stages = input.stages;
    return input;
}

/** Maps a rawlog first; then it is a simplemap. */
InputMap Extract::readAfterMapping(Progress& progress)
{
    if (!isRawlog(m_input)) {
        if (!m_rawlogConfig.empty())
            throw InputError("'" + m_input +
                             "' is no rawlog, to which --rawlog-config would apply; remove it");
        return readInput(m_input, m_reader, m_stages, m_preset);
    }
    progress.step("");
    m_reader.scans.imagesFolder = imagesFolderOf(m_input);
    const MappedRawlog mapped(m_input, {m_rawlogConfig, m_reader.scans.plugins, m_quiet});
    progress.step("reading " + baseName(m_input).string());
    InputMap input = readInput(mapped.simplemap(), m_reader, m_stages, m_preset);
    input.format = "MRPT rawlog, mapped by ICP";
    return input;
}

Extraction Extract::extract(const CompressedGrid& input, Progress& progress)
{
    progress.step("finding places and doors");
    Extraction extraction = Gr2To(m_stages).extract(input);
    extraction.map.source = storableName(m_input);
    m_viewFiles = addViews(extraction, std::move(m_views));
    requireValid(extraction.map);
    m_report.noteStagesMemory();
    m_report.stages.insert(m_report.stages.end(), extraction.reports.begin(), extraction.reports.end());
    return extraction;
}

void Extract::write(const ClassifiedGrid& grid, Extraction& extraction, ExtractFiles& output,
                    Progress& progress)
{
    progress.step("drawing");
    m_watch.lap();
    extraction.distances = DistanceMap();  // the pictures need its memory more
    const OverlayInput input{grid, extraction.places, extraction.voronoi, extraction.criticalPoints,
                             extraction.map};
    const std::string png = renderOverlayPng(input, m_overlay);
    const std::string svg = renderOverlaySvg(input, m_overlay);
    m_report.stages.push_back({"drawing", {{"pictures", 2}}, m_watch.lap(), png.size() + svg.size()});
    progress.step("casting scans");
    const auto keyframes = toSimplemap(extraction.map, extraction.grid, m_simplemap);
    const std::string simplemap = encodeSimplemap(keyframes);
    m_report.stages.push_back(
        {"scan casting", {{"keyframes", keyframes.size()}}, m_watch.lap(), simplemap.size()});
    progress.step("writing");
    output.write(0, toXml(extraction.map));
    output.write(1, toArchive(extraction.map));
    output.write(2, encodePng16(extraction.places));
    output.write(3, png);
    output.write(4, svg);
    output.write(5, simplemap);
    for (const auto& [name, bytes] : m_viewFiles) output.add(name, bytes);
    output.commit();
    m_report.stages.push_back(
        {"writing", {{"files", output.paths().size() + m_viewFiles.size()}}, m_watch.lap(), output.bytes()});
}
}  // namespace

std::unique_ptr<Command> makeExtract()
{
    return std::make_unique<Extract>();
}
}  // namespace gr2to::cli
