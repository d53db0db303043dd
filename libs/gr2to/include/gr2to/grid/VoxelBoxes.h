#pragma once

#include <cstddef>
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

/** Two by two by two voxels, the lowest leaves of one branch of an octree: most leaves are among these. */
struct VoxelBlock
{
    std::uint16_t x = 0;  //!< key of its lowest voxel; even, as y and z
    std::uint16_t y = 0;
    std::uint16_t z = 0;
    /** A bit a voxel that is known: number dx + 2 dy + 4 dz, as OctoMap counts children. */
    std::uint8_t free = 0;
    std::uint8_t occupied = 0;
};

/** The voxels of a 3D map that are known to be free or occupied: single ones in blocks, larger cubes in
 * boxes. */
struct VoxelBoxes
{
    /** Key of the voxel whose lower corner is the map frame's origin, as in OctoMap. */
    static constexpr int kOrigin = 1 << 15;

    double resolution_m = 0.05;  //!< side of a voxel
    std::vector<VoxelBlock> blocks;
    std::vector<VoxelBox> boxes;

    bool empty() const { return blocks.empty() && boxes.empty(); }
    /** Coordinate [m] of a voxel's lower side, along any axis of the map frame. */
    double lowerSide_m(int key) const { return (key - kOrigin) * resolution_m; }

    /** How many cubes there are, single voxels among them. */
    std::size_t count() const;
    /** Calls `action` with every cube, single voxels among them. */
    template <class Action>
    void forEach(const Action& action) const
    {
        for (const VoxelBlock& block : blocks)
            for (int k = 0; k < 8; ++k)
                if (((block.free | block.occupied) >> k) & 1)
                    action(VoxelBox{static_cast<std::uint16_t>(block.x + (k & 1)),
                                    static_cast<std::uint16_t>(block.y + ((k >> 1) & 1)),
                                    static_cast<std::uint16_t>(block.z + (k >> 2)), 0,
                                    ((block.occupied >> k) & 1) != 0});
        for (const VoxelBox& box : boxes) action(box);
    }
};

/** Keys that boxes cover: [first, last) along each axis. */
struct VoxelBounds
{
    int firstX = 0, lastX = 0;
    int firstY = 0, lastY = 0;
    int firstZ = 0, lastZ = 0;
};

/** Bounds of all voxels, in whole blocks: firsts and lasts are even; all zero when there is none. */
VoxelBounds boundsOf(const VoxelBoxes& voxels);
}  // namespace gr2to
