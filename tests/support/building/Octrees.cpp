#include "support/building/Octrees.h"

#include <algorithm>
#include <cmath>

namespace gr2to::test
{
namespace
{
using Boxes = std::vector<VoxelBox>::iterator;

/** Writes a branch of an octree as OctoMap stores it: two bits a child, then the children's branches. */
class BranchWriter
{
 public:
    std::string data;
    std::size_t nodes = 1;  //!< the root

    /** \param log2Side  of the branch, that holds all of the boxes and is not one of them */
    void write(Boxes first, Boxes last, int log2Side)
    {
        const int below = log2Side - 1;
        const auto octant = [below](const VoxelBox& box) {
            return ((box.x >> below) & 1) | (((box.y >> below) & 1) << 1) | (((box.z >> below) & 1) << 2);
        };
        Boxes bounds[9] = {first};
        for (int k = 0; k < 8; ++k)
            bounds[k + 1] =
                std::partition(bounds[k], last, [&](const VoxelBox& box) { return octant(box) == k; });
        unsigned bits = 0;
        bool isBranch[8] = {};
        for (int k = 0; k < 8; ++k) {
            if (bounds[k] == bounds[k + 1]) continue;
            ++nodes;
            isBranch[k] = bounds[k]->log2Side != below;
            bits |= (isBranch[k] ? 3U : (bounds[k]->occupied ? 2U : 1U)) << (2 * k);
        }
        data += static_cast<char>(bits & 0xFF);
        data += static_cast<char>(bits >> 8);
        for (int k = 0; k < 8; ++k)
            if (isBranch[k]) write(bounds[k], bounds[k + 1], below);
    }
};

VoxelBox voxelAt(int x, int y, int z, bool occupied)
{
    return {static_cast<std::uint16_t>(VoxelBoxes::kOrigin + x),
            static_cast<std::uint16_t>(VoxelBoxes::kOrigin + y),
            static_cast<std::uint16_t>(VoxelBoxes::kOrigin + z), 0, occupied};
}
}  // namespace

std::string binaryOctree(const VoxelBoxes& voxels, const std::string& type)
{
    std::vector<VoxelBox> cubes;
    voxels.forEach([&](const VoxelBox& cube) { cubes.push_back(cube); });
    BranchWriter writer;
    writer.write(cubes.begin(), cubes.end(), 16);
    return "# Octomap OcTree binary file\nid " + type + "\nsize " + std::to_string(writer.nodes) + "\nres " +
           std::to_string(voxels.resolution_m) + "\ndata\n" + writer.data;
}

VoxelBoxes extruded(const ClassifiedGrid& plan, double height_m)
{
    VoxelBoxes voxels;
    voxels.resolution_m = plan.resolution_m();
    const int layers = static_cast<int>(std::lround(height_m / plan.resolution_m()));
    const int left = static_cast<int>(std::lround(plan.frame().origin_x_m / plan.resolution_m()));
    const int bottom = static_cast<int>(std::lround(plan.frame().origin_y_m / plan.resolution_m()));
    for (std::size_t i = 0; i < plan.size(); ++i) {
        if (plan[i] == CellState::Unknown) continue;
        const Cell c = plan.cell(i);
        for (int z = -1; z <= layers; ++z) {
            const bool slab = z < 0 || z == layers;
            voxels.boxes.push_back(
                voxelAt(left + c.x, bottom + c.y, z, slab || plan[i] == CellState::Occupied));
        }
    }
    return voxels;
}

VoxelBoxes tiled(const VoxelBoxes& voxels, int count)
{
    const VoxelBounds bounds = boundsOf(voxels);
    int largest = 1;
    voxels.forEach([&](const VoxelBox& cube) { largest = std::max(largest, cube.side()); });
    const auto stepOver = [&](int extent) { return (extent + largest - 1) / largest * largest; };
    const int stepX = stepOver(bounds.lastX - bounds.firstX), stepY = stepOver(bounds.lastY - bounds.firstY);
    VoxelBoxes tiles;
    tiles.resolution_m = voxels.resolution_m;
    for (int ty = 0; ty < count; ++ty)
        for (int tx = 0; tx < count; ++tx)
            voxels.forEach([&](VoxelBox cube) {
                cube.x = static_cast<std::uint16_t>(cube.x + tx * stepX);
                cube.y = static_cast<std::uint16_t>(cube.y + ty * stepY);
                tiles.boxes.push_back(cube);
            });
    return tiles;
}
}  // namespace gr2to::test
