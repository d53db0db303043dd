#include "gr2to/grid/VoxelBoxes.h"

#include <algorithm>
#include <limits>

namespace gr2to
{
VoxelBounds boundsOf(const VoxelBoxes& voxels, int firstZ, int lastZ)
{
    constexpr int far = std::numeric_limits<int>::max();
    VoxelBounds b{far, 0, far, 0, far, 0};
    for (const VoxelBox& box : voxels.boxes) {
        const int side = box.side();
        if (box.z >= lastZ || box.z + side <= firstZ) continue;
        b.firstX = std::min<int>(b.firstX, box.x);
        b.lastX = std::max(b.lastX, box.x + side);
        b.firstY = std::min<int>(b.firstY, box.y);
        b.lastY = std::max(b.lastY, box.y + side);
        b.firstZ = std::min<int>(b.firstZ, box.z);
        b.lastZ = std::max(b.lastZ, box.z + side);
    }
    if (b.lastX == 0) return {};
    b.firstZ = std::max(b.firstZ, firstZ);
    b.lastZ = std::min(b.lastZ, lastZ);
    return b;
}
}  // namespace gr2to
