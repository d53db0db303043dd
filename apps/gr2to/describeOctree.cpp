#include <algorithm>

#include "TextTable.h"
#include "describe.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/text.h"
#include "gr2to/grid/HeightHistogram.h"
#include "gr2to/stages/GridCompression.h"
#include "json.h"

namespace gr2to::cli
{
namespace
{
/** What is told of an octree. */
struct OctreeFacts
{
    VoxelBounds bounds;
    std::size_t freeLeaves = 0, occupiedLeaves = 0;
    std::int64_t freeVoxels = 0, occupiedVoxels = 0;
    std::optional<double> floor_m, ceiling_m;
    mrpt::math::TPoint3D low, high;  //!< corners of the extent
};

OctreeFacts factsOf(const OctreeFile& file, const std::string& name)
{
    const TCompressionOptions options;
    const VoxelBoxes voxels = voxelsOf(*file.tree, options.p_max, options.p_min);
    if (voxels.empty())
        throw InputError(
            name +
            " is an OctoMap octree without any free or occupied voxel; check that it is the right file");
    OctreeFacts facts;
    voxels.forEach([&](const VoxelBox& box) {
        ++(box.occupied ? facts.occupiedLeaves : facts.freeLeaves);
        (box.occupied ? facts.occupiedVoxels : facts.freeVoxels) += std::int64_t{1} << (3 * box.log2Side);
    });
    facts.bounds = boundsOf(voxels);
    const auto at = [&](int key) { return voxels.lowerSide_m(key); };
    facts.low = {at(facts.bounds.firstX), at(facts.bounds.firstY), at(facts.bounds.firstZ)};
    facts.high = {at(facts.bounds.lastX), at(facts.bounds.lastY), at(facts.bounds.lastZ)};
    const RoomHeight room = findRoomHeight(heightHistogram(voxels, facts.bounds), voxels.resolution_m);
    if (room.floor) facts.floor_m = at(*room.floor);
    if (room.ceiling) facts.ceiling_m = at(*room.ceiling);
    return facts;
}

std::string line(const std::string& name, const std::string& text)
{
    constexpr std::size_t WIDTH = 12;
    return "  " + name + std::string(WIDTH - name.size(), ' ') + text + "\n";
}

std::string span(double low, double high)
{
    return fixedText(low, 3) + " to " + fixedText(high, 3);
}

std::string leavesText(std::size_t leaves, std::int64_t voxels)
{
    return std::to_string(voxels) + " voxels in " + std::to_string(leaves) + " leaves";
}
}  // namespace

std::string octreeText(const std::filesystem::path& file, const OctreeFile& octree)
{
    const OctreeFacts facts = factsOf(octree, "'" + file.string() + "'");
    const VoxelBounds& b = facts.bounds;
    const auto surface = [](const std::optional<double>& z) {
        return z ? "z = " + fixedText(*z, 3) + " m" : std::string("none found");
    };
    return file.string() + ": 3D occupancy map\n" + line("format", octree.format) +
           line("size", std::to_string(b.lastX - b.firstX) + " x " + std::to_string(b.lastY - b.firstY) +
                            " x " + std::to_string(b.lastZ - b.firstZ) + " voxels, " +
                            std::to_string(octree.nodes) + " nodes") +
           line("resolution", numberText(octree.resolution_m) + " m a voxel") +
           line("extent", "x " + span(facts.low.x, facts.high.x) + " m, y " +
                              span(facts.low.y, facts.high.y) + " m, z " + span(facts.low.z, facts.high.z) +
                              " m") +
           line("free", leavesText(facts.freeLeaves, facts.freeVoxels)) +
           line("occupied", leavesText(facts.occupiedLeaves, facts.occupiedVoxels)) +
           line("floor", surface(facts.floor_m)) + line("ceiling", surface(facts.ceiling_m));
}

std::string octreeJson(const std::filesystem::path& file, const OctreeFile& octree)
{
    const OctreeFacts facts = factsOf(octree, "'" + file.string() + "'");
    const VoxelBounds& b = facts.bounds;
    Json json = {{"file", file.string()},
                 {"kind", "octree"},
                 {"format", octree.format},
                 {"resolution_m", octree.resolution_m},
                 {"nodes", octree.nodes},
                 {"voxels", {b.lastX - b.firstX, b.lastY - b.firstY, b.lastZ - b.firstZ}},
                 {"low_m", {facts.low.x, facts.low.y, facts.low.z}},
                 {"high_m", {facts.high.x, facts.high.y, facts.high.z}},
                 {"free", {{"leaves", facts.freeLeaves}, {"voxels", facts.freeVoxels}}},
                 {"occupied", {{"leaves", facts.occupiedLeaves}, {"voxels", facts.occupiedVoxels}}}};
    if (facts.floor_m) json["floor_m"] = *facts.floor_m;
    if (facts.ceiling_m) json["ceiling_m"] = *facts.ceiling_m;
    return jsonText(json);
}
}  // namespace gr2to::cli
