#pragma once

#include <cstdint>
#include <vector>

namespace gr2to
{
/** A cube of voxels in one state: a leaf of an octree. A leaf above the lowest level stands for all voxels
 * that it covers. */
struct VoxelBox
{
    std::uint16_t x = 0;  //!< key of its lowest voxel, as in OctoMap
    std::uint16_t y = 0;
    std::uint16_t z = 0;
    std::uint8_t log2Side = 0;  //!< its side is 2^log2Side voxels
    bool occupied = false;      //!< else free; what is unknown has no box

    int side() const { return 1 << log2Side; }
};

/** The voxels of a 3D map that are known to be free or occupied, in disjoint cubes. */
struct VoxelBoxes
{
    /** Key of the voxel whose lower corner is the map frame's origin, as in OctoMap. */
    static constexpr int kOrigin = 1 << 15;

    double resolution_m = 0.05;  //!< side of a voxel
    std::vector<VoxelBox> boxes;

    /** Coordinate [m] of a voxel's lower side, along any axis of the map frame. */
    double lowerSide_m(int key) const { return (key - kOrigin) * resolution_m; }
};

/** Keys that boxes cover: [first, last) along each axis. */
struct VoxelBounds
{
    int firstX = 0, lastX = 0;
    int firstY = 0, lastY = 0;
    int firstZ = 0, lastZ = 0;
};

/** Bounds of the boxes that reach into layers [firstZ, lastZ), cut to these layers; all zero when none does.
 */
VoxelBounds boundsOf(const VoxelBoxes& voxels, int firstZ = 0, int lastZ = 2 * VoxelBoxes::kOrigin);
}  // namespace gr2to
