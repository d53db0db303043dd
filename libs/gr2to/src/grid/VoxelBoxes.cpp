#include "gr2to/grid/VoxelBoxes.h"

#include <algorithm>
#include <limits>

namespace gr2to
{
std::size_t VoxelBoxes::count() const
{
    constexpr std::uint8_t bitsOfNibble[16] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};
    std::size_t cubes = boxes.size();
    for (const VoxelBlock& block : blocks) {
        const unsigned known = block.free | block.occupied;
        cubes += std::size_t{bitsOfNibble[known & 15U]} + bitsOfNibble[known >> 4];
    }
    return cubes;
}

VoxelBounds boundsOf(const VoxelBoxes& voxels)
{
    constexpr std::uint16_t far = std::numeric_limits<std::uint16_t>::max();
    if (voxels.empty()) return {};
    std::uint16_t low[3] = {far, far, far}, high[3] = {0, 0, 0};  // of the lower corners of blocks
    for (const VoxelBlock& block : voxels.blocks) {
        low[0] = std::min(low[0], block.x);
        high[0] = std::max(high[0], block.x);
        low[1] = std::min(low[1], block.y);
        high[1] = std::max(high[1], block.y);
        low[2] = std::min(low[2], block.z);
        high[2] = std::max(high[2], block.z);
    }
    VoxelBounds b{low[0], high[0] + 2, low[1], high[1] + 2, low[2], high[2] + 2};
    for (const VoxelBox& box : voxels.boxes) {
        b.firstX = std::min<int>(b.firstX, box.x);
        b.lastX = std::max(b.lastX, box.x + box.side());
        b.firstY = std::min<int>(b.firstY, box.y);
        b.lastY = std::max(b.lastY, box.y + box.side());
        b.firstZ = std::min<int>(b.firstZ, box.z);
        b.lastZ = std::max(b.lastZ, box.z + box.side());
    }
    const auto even = [](int& first, int& last) {
        first -= first & 1;
        last += last & 1;
    };
    even(b.firstX, b.lastX);
    even(b.firstY, b.lastY);
    even(b.firstZ, b.lastZ);
    return b;
}
}  // namespace gr2to
