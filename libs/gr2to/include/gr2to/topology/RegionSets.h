#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/LineDirection.h"
#include "gr2to/topology/FaceMap.h"

namespace gr2to
{
/** Faces merged to regions, and the size and shape of each. A region is named by one of its faces. */
class RegionSets
{
 public:
    /** \param directions  that the building's walls run in: rectangles lie along them
     * Cost: linear in the number of cells. */
    RegionSets(const FaceMap& faces, const DistanceMap& distances,
               const std::vector<LineDirection>& directions);

    /** One more than the number of faces. */
    int size() const { return static_cast<int>(m_parent.size()); }
    int find(int face);
    bool isRegion(int face) const { return m_parent[static_cast<std::size_t>(face)] == face; }
    /** The second region becomes part of the first. */
    void join(int region, int other);

    std::int64_t cells(int region) const { return m_cells[static_cast<std::size_t>(region)]; }
    /** Of the largest circle. */
    double radius_cells(int region) const;
    /** Part of the smallest rectangle around a region that it fills, along the direction in which that is
     * most. */
    double rectangularity(int region) const { return rectangularity(region, region); }
    /** The same of the union of two regions. */
    double rectangularity(int region, int other) const;

 private:
    static constexpr std::size_t kMostFrames = 4;
    struct Frame
    {
        double cos = 1, sin = 0;
    };
    /** Least and greatest coordinate along and across each frame. */
    struct Extent
    {
        std::array<double, kMostFrames> minAlong, maxAlong, minAcross, maxAcross;
        Extent();
        void include(const Extent& other);
    };

    static std::vector<Frame> framesOf(const std::vector<LineDirection>& directions);
    void include(std::size_t face, double x, double y);

    std::vector<Frame> m_frames;
    std::vector<int> m_parent;
    std::vector<std::int64_t> m_cells;
    std::vector<std::int32_t> m_squaredRadius;
    std::vector<Extent> m_extents;
};
}  // namespace gr2to
