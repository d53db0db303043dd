#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to
{
/** Heights above the floor that a 3D map shows over the cells of its grid; empty for a 2D map.
 *
 * Heights are stored in voxels, as they were seen; 0 stands for none.
 */
struct HeightMap
{
    double voxel_m = 0;  //!< height of a voxel
    double floor_m = 0;  //!< z of the floor in the map frame
    int width = 0;       //!< of the grid [cells]
    std::vector<std::uint16_t>
        top;  //!< of an occupied column: up to the upper side of its highest occupied voxel
    std::vector<std::uint16_t> lintel;  //!< of a passage: up to the lower side of what hangs over it

    bool empty() const { return top.empty(); }
    /** Of the lower or upper side of the voxels [m]; nothing when none was seen. */
    std::optional<double> top_m(Cell c) const { return metres(top, c); }
    std::optional<double> lintel_m(Cell c) const { return metres(lintel, c); }

 private:
    std::optional<double> metres(const std::vector<std::uint16_t>& voxels, Cell c) const
    {
        if (empty()) return {};
        const std::uint16_t count = voxels[static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) +
                                           static_cast<std::size_t>(c.x)];
        if (count == 0) return {};
        return count * voxel_m;
    }
};
}  // namespace gr2to
