#include "gr2to/grid/HeightHistogram.h"

#include <algorithm>
#include <cmath>

namespace gr2to
{
namespace
{
constexpr double kNeighbourhood_m = 0.3;  // thinner than any room, thicker than any slab's noise
constexpr double kShareOfFullest = 0.5;
constexpr double kTimesMedian = 1.5;
constexpr double kLowestRoom_m = 1.8;  // a person has to fit in
constexpr double kShareOfPeak = 0.1;
constexpr double kThickestSurface_m = 0.2;
constexpr int kBitsOfNibble[16] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};

int layersIn(double length_m, double resolution_m)
{
    return std::max(1, static_cast<int>(std::lround(length_m / resolution_m)));
}

/** Of the layers that have an occupied voxel. */
std::int64_t medianOf(std::vector<std::int64_t> counts)
{
    counts.erase(std::remove(counts.begin(), counts.end(), 0), counts.end());
    const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
    std::nth_element(counts.begin(), middle, counts.end());
    return *middle;
}

std::vector<int> peaksOf(const std::vector<std::int64_t>& counts, int reach)
{
    const std::int64_t fullest = *std::max_element(counts.begin(), counts.end());
    const double least = std::max(kShareOfFullest * static_cast<double>(fullest),
                                  kTimesMedian * static_cast<double>(medianOf(counts)));
    std::vector<int> peaks;
    const int layers = static_cast<int>(counts.size());
    for (int z = 0; z < layers; ++z) {
        const auto from = counts.begin() + std::max(0, z - reach);
        const auto to = counts.begin() + std::min(layers, z + reach + 1);
        const std::int64_t count = counts[static_cast<std::size_t>(z)];
        if (static_cast<double>(count) >= least && count == *std::max_element(from, to)) peaks.push_back(z);
    }
    return peaks;
}

/** The first layer beyond a peak, in steps of +1 or -1. */
int beyondPeak(const std::vector<std::int64_t>& counts, int peak, int step, int thickest)
{
    const auto usual = static_cast<double>(medianOf(counts));
    const double least =
        usual + kShareOfPeak * (static_cast<double>(counts[static_cast<std::size_t>(peak)]) - usual);
    int z = peak;
    const int layers = static_cast<int>(counts.size());
    while (z >= 0 && z < layers && std::abs(z - peak) < thickest &&
           static_cast<double>(counts[static_cast<std::size_t>(z)]) > least)
        z += step;
    return z;
}
}  // namespace

HeightHistogram heightHistogram(const VoxelBoxes& voxels, const VoxelBounds& bounds)
{
    // Cubes add their base to the layers from their lowest to their highest: summed up from the differences
    // at both ends.
    const auto layerOf = [&](int z) { return static_cast<std::size_t>(z - bounds.firstZ); };
    std::vector<std::int64_t> change(layerOf(bounds.lastZ) + 1, 0);
    std::vector<std::int64_t> single(layerOf(bounds.lastZ) + 1, 0);
    constexpr unsigned lowerHalf = 0x0F;
    for (const VoxelBlock& block : voxels.blocks) {
        single[layerOf(block.z)] += kBitsOfNibble[block.occupied & lowerHalf];
        single[layerOf(block.z + 1)] += kBitsOfNibble[block.occupied >> 4];
    }
    for (const VoxelBox& box : voxels.boxes) {
        if (!box.occupied) continue;
        const std::int64_t base = std::int64_t{1} << (2 * box.log2Side);
        change[layerOf(box.z)] += base;
        change[layerOf(box.z + box.side())] -= base;
    }
    HeightHistogram histogram;
    histogram.firstLayer = bounds.firstZ;
    std::int64_t count = 0;
    for (std::size_t layer = 0; layer < layerOf(bounds.lastZ); ++layer)
        histogram.occupied.push_back((count += change[layer]) + single[layer]);
    return histogram;
}

RoomHeight findRoomHeight(const HeightHistogram& histogram, double resolution_m)
{
    const std::vector<std::int64_t>& counts = histogram.occupied;
    const auto isOccupied = [](std::int64_t count) { return count > 0; };
    const auto lowest = std::find_if(counts.begin(), counts.end(), isOccupied);
    if (lowest == counts.end()) return {};
    const auto highest = std::find_if(counts.rbegin(), counts.rend(), isOccupied).base() - 1;
    const std::vector<int> peaks = peaksOf(counts, layersIn(kNeighbourhood_m, resolution_m));
    if (peaks.empty()) return {};
    std::optional<int> floor = peaks.front(), ceiling = peaks.back();
    if (*ceiling - *floor < layersIn(kLowestRoom_m, resolution_m)) {
        const auto middle = ((lowest - counts.begin()) + (highest - counts.begin())) / 2;
        if (*floor <= middle)
            ceiling.reset();
        else
            floor.reset();
    }
    const int thickest = layersIn(kThickestSurface_m, resolution_m);
    RoomHeight room;
    if (floor) room.floor = histogram.firstLayer + beyondPeak(counts, *floor, 1, thickest);
    if (ceiling) room.ceiling = histogram.firstLayer + beyondPeak(counts, *ceiling, -1, thickest) + 1;
    return room;
}
}  // namespace gr2to
