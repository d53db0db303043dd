#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "Command.h"
#include "TableOptions.h"
#include "describe.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/io/OctreeReader.h"
#include "gr2to/mrpt/archive.h"
#include "gr2to/stages/GridCompression.h"
#include "gr2to/view/Scene3D.h"
#include "parse.h"

namespace gr2to::cli
{
namespace
{
namespace fs = std::filesystem;

class Render : public Command
{
 public:
    std::string name() const override { return "render"; }
    std::string arguments() const override { return "MAP --to png|3Dscene [-o FILE] [options]"; }
    std::string summary() const override { return "draw a topological map in three dimensions"; }
    std::string description() const override
    {
        return "Draws a topological map in three dimensions: the places' floors in the colours of the "
               "overlay, "
               "real walls and doors as high as they were measured, virtual walls as lines on the floor, and "
               "the "
               "graph of places and connections above them. With --octree the 3D map that it was made from "
               "stands "
               "among them, without its floor and its ceiling.\n\n"
               "A png is drawn off screen and needs no display; a 3Dscene is for MRPT's SceneViewer3D.";
    }
    void declare(CLI::App& app) override
    {
        addOption(app, "MAP", m_map, "", "The map, or a folder that 'gr2to extract' wrote.")->required();
        addOption(app, "--to", m_format, "png|3Dscene", "What to write.")->required();
        addOption(app, "-o,--output", m_output, "FILE",
                  "File to write. (default: MAP's folder, as topomap.png or topomap.3Dscene)");
        addOption(app, "--octree", m_octree, "FILE",
                  "An OctoMap .bt or .ot in the map's frame, whose occupied voxels are drawn too.");
        m_tables.declare(app);
    }
    int run() override
    {
        m_tables.apply();
        if (m_format != "png" && m_format != "3Dscene")
            throw std::invalid_argument("--to '" + m_format + "' is not known; it is one of png, 3Dscene");
        const fs::path file = mapFileIn(m_map);
        const fs::path output =
            m_output.empty() ? file.parent_path() / ("topomap." + m_format) : fs::path(m_output);
        OutputTransaction files;
        const fs::path temporary = files.stage(output);
        const auto scene = makeScene(loadTopologicalMap(file), m_options);
        if (!m_octree.empty()) scene->insert(voxelsIn(m_octree));
        if (m_format == "png")
            writeFile(temporary, renderPng(*scene, m_options));
        else if (!scene->saveToFile(temporary.string()))
            throw OutputError("cannot write '" + output.string() + "'");
        files.commit();
        std::cout << output.string() << '\n';
        return kDone;
    }

 private:
    static mrpt::opengl::CRenderizable::Ptr voxelsIn(const fs::path& file)
    {
        const OctreeFile octree = readOctree(file);
        const TCompressionOptions usual;  // what is occupied
        try {
            return drawVoxels(voxelsOf(*octree.tree, usual.p_max, usual.p_min));
        } catch (const InputError& error) {
            throw InputError("'" + file.string() + "': " + error.what());
        }
    }

    std::string m_map;
    std::string m_format;
    std::string m_output;
    std::string m_octree;
    TSceneOptions m_options;
    TableOptions m_tables{{&m_options}};
};
}  // namespace

std::unique_ptr<Command> makeRender()
{
    return std::make_unique<Render>();
}
}  // namespace gr2to::cli
