#include "readInput.h"

#include <chrono>

#include "gr2to/base/errors.h"
#include "gr2to/io/OctreeReader.h"

namespace gr2to::cli
{
namespace
{
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

InputMap readOctreeInput(const std::filesystem::path& path, const Gr2ToOptions& stages)
{
    const auto start = Clock::now();
    const OctreeFile file = readOctree(path);
    InputMap input;
    input.format = file.format;
    input.stages.push_back({"reading", {{"nodes", file.nodes}}, secondsSince(start), file.bytes});
    StageReport compression;
    try {
        input.map = Gr2To(stages).compress(*file.tree, &compression);
    } catch (const InputError& error) {
        throw InputError("'" + path.string() + "': " + error.what());
    }
    input.range = input.map.range;
    input.stages.push_back(compression);
    return input;
}
}  // namespace

void requireUnused(OptionTable& given, OptionTable& standard, const std::string& input)
{
    const std::vector<OptionField> fields = given.fields(), defaults = standard.fields();
    for (std::size_t k = 0; k < fields.size(); ++k)
        if (fields[k].valueText() != defaults[k].valueText())
            throw InputError(input + ", to which " + given.section() + "." + fields[k].name +
                             " does not apply; remove the option");
}

InputMap readInput(const std::filesystem::path& path, TGridReaderOptions& reader, Gr2ToOptions& stages,
                   const std::string& preset)
{
    const std::string name = "'" + path.string() + "'";
    if (isOctreeFile(path)) {
        TGridReaderOptions standard;
        requireUnused(reader, standard, name + " is an OctoMap octree");
        requireUnused(reader.scans, standard.scans, name + " is an OctoMap octree");
        return readOctreeInput(path, stages);
    }
    const auto start = Clock::now();
    InputMap input;
    GridSource source;
    input.map.grid = readGrid(path, reader, &source);
    requireUsable(input.map.grid, path.string());
    Gr2ToOptions standard = Gr2ToOptions::preset(preset);
    requireUnused(stages.compression, standard.compression, name + " is a 2D grid");
    input.format = source.format;
    input.image = source.image;
    input.views = std::move(source.views);
    const std::size_t cells = input.map.grid.size();
    input.stages.push_back({"reading", {{"cells", cells}}, secondsSince(start), cells});
    return input;
}
}  // namespace gr2to::cli
