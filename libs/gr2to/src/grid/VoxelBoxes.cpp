#include "gr2to/grid/VoxelBoxes.h"

#include <algorithm>
#include <bitset>
#include <limits>

namespace gr2to
{
namespace
{
/** First and one after the last key of a block's voxels along one axis. \param lower  the bits of its lower
 * half */
struct Span
{
    Span(int key, unsigned known, unsigned lower)
        : first(key + ((known & lower) != 0 ? 0 : 1)), last(key + ((known & ~lower & 0xFFU) != 0 ? 2 : 1))
    {
    }
    int first;
    int last;
};
}  // namespace

std::size_t VoxelBoxes::count() const
{
    std::size_t cubes = boxes.size();
    for (const VoxelBlock& block : blocks) cubes += std::bitset<8>(block.free | block.occupied).count();
    return cubes;
}

VoxelBounds boundsOf(const VoxelBoxes& voxels)
{
    constexpr int far = std::numeric_limits<int>::max();
    VoxelBounds b{far, 0, far, 0, far, 0};
    const auto add = [](const Span& span, int& first, int& last) {
        first = std::min(first, span.first);
        last = std::max(last, span.last);
    };
    for (const VoxelBlock& block : voxels.blocks) {
        const unsigned known = block.free | block.occupied;
        add({block.x, known, 0x55}, b.firstX, b.lastX);
        add({block.y, known, 0x33}, b.firstY, b.lastY);
        add({block.z, known, 0x0F}, b.firstZ, b.lastZ);
    }
    for (const VoxelBox& box : voxels.boxes) {
        b.firstX = std::min<int>(b.firstX, box.x);
        b.lastX = std::max(b.lastX, box.x + box.side());
        b.firstY = std::min<int>(b.firstY, box.y);
        b.lastY = std::max(b.lastY, box.y + box.side());
        b.firstZ = std::min<int>(b.firstZ, box.z);
        b.lastZ = std::max(b.lastZ, box.z + box.side());
    }
    return b.lastX == 0 ? VoxelBounds{} : b;
}
}  // namespace gr2to
