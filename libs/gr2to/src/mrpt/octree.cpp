#include "gr2to/mrpt/octree.h"

#include <octomap/OcTree.h>

// MRPT 2.5 hides its octree behind a type that it defines in its own sources only; getOctomap() needs to see
// it.
template <class OCTREE, class OCTREE_NODE>
struct mrpt::maps::COctoMapBase<OCTREE, OCTREE_NODE>::Impl
{
    OCTREE m_octomap;
};

namespace gr2to
{
const octomap::OcTree& octreeOf(const mrpt::maps::COctoMap& map)
{
    // getOctomap() changes nothing, but is not declared const
    return const_cast<mrpt::maps::COctoMap&>(map).getOctomap<octomap::OcTree>();
}
}  // namespace gr2to
