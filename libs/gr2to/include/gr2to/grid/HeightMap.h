#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to
{
/** Heights above the floor that a 3D map shows over the cells of its grid; empty for a 2D map.
 *
 * Heights are kept in voxels, as they were seen. An occupied column has a top, a passage a lintel.
 */
class HeightMap
{
 public:
    double voxel_m = 0;  //!< height of a voxel
    double floor_m = 0;  //!< z of the floor in the map frame

    HeightMap() = default;
    HeightMap(int width, int height, double voxel)
        : voxel_m(voxel),
          m_width(width),
          m_heights(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    {
    }

    bool empty() const { return m_heights.empty(); }
    std::size_t size() const { return m_heights.size(); }

    /** \param voxels  above the floor; what is not above it is no height */
    void setTop(std::size_t cell, int voxels) { m_heights[cell] = kept(voxels); }
    void setLintel(std::size_t cell, int voxels)
    {
        m_heights[cell] = static_cast<std::int16_t>(-kept(voxels));
    }

    /** Up to the upper side of an occupied column's highest occupied voxel [m]; nothing when none was seen.
     */
    std::optional<double> top_m(Cell c) const { return metres(at(c)); }
    /** Up to the lower side of what hangs over a passage [m]; nothing when nothing does. */
    std::optional<double> lintel_m(Cell c) const { return metres(-at(c)); }

 private:
    static std::int16_t kept(int voxels) { return static_cast<std::int16_t>(std::clamp(voxels, 0, 0x7FFF)); }
    int at(Cell c) const
    {
        return empty() ? 0
                       : m_heights[static_cast<std::size_t>(c.y) * static_cast<std::size_t>(m_width) +
                                   static_cast<std::size_t>(c.x)];
    }
    std::optional<double> metres(int voxels) const
    {
        return voxels > 0 ? std::optional<double>(voxels * voxel_m) : std::nullopt;
    }

    int m_width = 0;
    std::vector<std::int16_t> m_heights;  //!< [voxels] of tops, of lintels with a minus, 0 for none
};
}  // namespace gr2to
