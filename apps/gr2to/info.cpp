#include <iostream>

#include "Command.h"
#include "TableOptions.h"
#include "describe.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/mrpt/archive.h"
#include "parse.h"

namespace gr2to::cli
{
namespace
{
class Info : public Command
{
 public:
    std::string name() const override { return "info"; }
    std::string arguments() const override { return "FILE [options]"; }
    std::string summary() const override { return "tell what a grid or a topological map holds"; }
    std::string description() const override
    {
        return "Tells what FILE holds. Of a grid (ROS .yaml, PNG or PGM image, MRPT .gridmap or .simplemap): "
               "its format, "
               "size, "
               "resolution, origin, extent, and how much of it is free, occupied and unknown. Of an OctoMap "
               "(.bt, .ot): the same of its voxels, and where its floor and ceiling are. Of a topological "
               "map "
               "(topomap.xml or .gr2to): a table of its places, and its connections and walls. Of a folder "
               "that "
               "'gr2to extract' wrote: the same of the map in it.\n\n"
               "The options say how a grid is read; they do not apply to a topological map.";
    }
    void declare(CLI::App& app) override
    {
        addOption(app, "FILE", m_file, "", "The file, told by its content.")->required();
        app.add_flag("--json", m_json, "Print JSON instead of text.");
        m_tables.declare(app);
    }
    int run() override
    {
        m_tables.apply();
        const auto file = mapFileIn(m_file);
        std::cout << (isTopologicalMap(readFile(file), "'" + file.string() + "'") ? ofMap(file)
                                                                                  : ofGrid(file));
        return kDone;
    }

 private:
    std::string ofMap(const std::filesystem::path& file) const
    {
        if (m_tables.given())
            throw InputError("'" + file.string() +
                             "' is a topological map, to which options for grids do not apply; remove them");
        const TopologicalMap map = loadTopologicalMap(file);
        return m_json ? mapJson(file, map) : mapText(file, map);
    }
    std::string ofGrid(const std::filesystem::path& file) const
    {
        if (isOctreeFile(file)) return ofOctree(file);
        GridSource source;
        const ClassifiedGrid grid = readGrid(file, m_reader, &source);
        return m_json ? gridJson(file, grid, source) : gridText(file, grid, source);
    }

    std::string ofOctree(const std::filesystem::path& file) const
    {
        if (m_tables.given())
            throw InputError(
                "'" + file.string() +
                "' is an OctoMap octree, to which options for 2D grids do not apply; remove them");
        const OctreeFile octree = readOctree(file);
        return m_json ? octreeJson(file, octree) : octreeText(file, octree);
    }

    std::string m_file;
    bool m_json = false;
    TGridReaderOptions m_reader;
    TableOptions m_tables{{&m_reader, &m_reader.scans}};
};
}  // namespace

std::unique_ptr<Command> makeInfo()
{
    return std::make_unique<Info>();
}
}  // namespace gr2to::cli
