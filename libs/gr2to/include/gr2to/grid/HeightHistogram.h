#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gr2to/grid/VoxelBoxes.h"

namespace gr2to
{
/** How many voxels are occupied at each height. */
struct HeightHistogram
{
    int firstLayer = 0;  //!< key of the lowest layer
    std::vector<std::int64_t>
        occupied;  //!< of each layer from the lowest that has a known voxel to the highest
};
/** \param bounds  of all voxels */
HeightHistogram heightHistogram(const VoxelBoxes& voxels, const VoxelBounds& bounds);

/** Between which layers the room lies that a 3D map shows. */
struct RoomHeight
{
    std::optional<int> floor;    //!< key of the lowest layer above the floor
    std::optional<int> ceiling;  //!< key of the lowest layer of the ceiling
};

/** Finds floor and ceiling as the outermost peaks of the histogram.
 *
 * A peak is the fullest layer within 0.3 m to both sides, has at least half as many occupied voxels as the
 * fullest layer of all, and at least one and a half times as many as the median layer: a horizontal surface
 * that goes through the whole map, not the tops of desks. The lowest peak is the floor and the highest one
 * the ceiling when they are at least 1.8 m apart; a single one is the floor when it lies in the lower half of
 * the occupied layers, else the ceiling. A peak is cut off with all layers inwards of it that have more than
 * a tenth of what it has over the median layer, at most 0.2 m.
 */
RoomHeight findRoomHeight(const HeightHistogram& histogram, double resolution_m);
}  // namespace gr2to
