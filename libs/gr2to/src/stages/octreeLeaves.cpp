#include "stages/octreeLeaves.h"

#include <octomap/OcTree.h>

#include <limits>

#include "gr2to/base/ZeroedMemory.h"

namespace gr2to
{
namespace
{
/** Walks the tree itself: the library's leaf iterator keeps a stack and computes a key for every inner node
 * too. */
class LeafCollector
{
 public:
    LeafCollector(const octomap::OcTree& tree, double p_max, double p_min)
        : m_tree(tree), m_free(octomap::logodds(p_max)), m_occupied(octomap::logodds(p_min))
    {
        m_unknown.setLogOdds(std::numeric_limits<float>::quiet_NaN());
        m_voxels.resolution_m = tree.getResolution();
        reserve(m_voxels.blocks, tree.size() / 4);
        reserve(m_voxels.boxes, tree.size() / 4);
    }

    VoxelBoxes collect()
    {
        if (m_tree.getRoot() != nullptr)
            visit(*m_tree.getRoot(), 0, 0, 0, static_cast<int>(m_tree.getTreeDepth()));
        return std::move(m_voxels);
    }

 private:
    /** Of what is not used, no page is ever touched. */
    template <class T>
    static void reserve(std::vector<T>& list, std::size_t count)
    {
        list.reserve(count);
        wishLargePages(list.data(), count * sizeof(T));
    }

    void visit(const octomap::OcTreeNode& node, int x, int y, int z, int log2Side)
    {
        if (log2Side == 1) return addBlock(node, x, y, z);
        bool isLeaf = true;
        const int below = log2Side - 1;
        for (unsigned k = 0; k < 8; ++k)
            if (m_tree.nodeChildExists(&node, k)) {
                isLeaf = false;
                const int i = static_cast<int>(k);
                visit(*m_tree.getNodeChild(&node, k), x | ((i & 1) << below), y | (((i >> 1) & 1) << below),
                      z | ((i >> 2) << below), below);
            }
        if (isLeaf) addBox(node, x, y, z, log2Side);
    }

    /** Without a branch for each child: which ones there are follows no pattern that a processor could guess.
     */
    void addBlock(const octomap::OcTreeNode& node, int x, int y, int z)
    {
        unsigned free = 0, occupied = 0, known = 0;
        for (unsigned k = 0; k < 8; ++k) {
            const bool exists = m_tree.nodeChildExists(&node, k);
            const octomap::OcTreeNode* const nodes[2] = {&m_unknown,
                                                         exists ? m_tree.getNodeChild(&node, k) : nullptr};
            const float logOdds = nodes[exists ? 1 : 0]->getLogOdds();
            known |= exists ? 1U : 0U;
            occupied |= (logOdds >= m_occupied ? 1U : 0U) << k;
            free |= (logOdds <= m_free ? 1U : 0U) << k;
        }
        if (known == 0) return addBox(node, x, y, z, 1);
        if ((free | occupied) != 0)
            m_voxels.blocks.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                       static_cast<std::uint16_t>(z), static_cast<std::uint8_t>(free),
                                       static_cast<std::uint8_t>(occupied)});
    }

    void addBox(const octomap::OcTreeNode& node, int x, int y, int z, int log2Side)
    {
        const float logOdds = node.getLogOdds();
        const bool occupied = logOdds >= m_occupied;
        if (!occupied && logOdds > m_free) return;
        m_voxels.boxes.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                  static_cast<std::uint16_t>(z), static_cast<std::uint8_t>(log2Side),
                                  occupied});
    }

    const octomap::OcTree& m_tree;
    float m_free;
    float m_occupied;
    octomap::OcTreeNode m_unknown;  //!< stands for children that are not there: neither free nor occupied
    VoxelBoxes m_voxels;
};
}  // namespace

VoxelBoxes leavesOf(const octomap::OcTree& tree, double p_max, double p_min)
{
    return LeafCollector(tree, p_max, p_min).collect();
}
}  // namespace gr2to
