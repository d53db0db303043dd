#include "stages/octreeLeaves.h"

#include <octomap/OcTree.h>

#include <cstdint>
#include <limits>

#include "gr2to/base/ZeroedMemory.h"

namespace gr2to
{
namespace
{
using Children = octomap::AbstractOcTreeNode* const*;

/** Reads a node's children at once: the library's own access looks for the array and for the child each time.
 */
struct Node : octomap::OcTreeNode
{
    /** Eight of them, null where there is none; null itself for a leaf. */
    static Children childrenOf(const octomap::OcTreeNode& node) { return node.*(&Node::children); }
};

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
        const Children children = Node::childrenOf(node);
        if (children == nullptr) return addBox(node, x, y, z, log2Side);
        if (!hasAny(children)) return addBox(node, x, y, z, log2Side);  // an array may outlive its nodes
        if (log2Side == 1) return addBlock(children, x, y, z);
        const int below = log2Side - 1;
        for (int k = 0; k < 8; ++k)
            if (children[k] != nullptr)
                visit(*static_cast<const octomap::OcTreeNode*>(children[k]), x | ((k & 1) << below),
                      y | (((k >> 1) & 1) << below), z | ((k >> 2) << below), below);
    }

    static bool hasAny(Children children)
    {
        std::uintptr_t any = 0;
        for (int k = 0; k < 8; ++k) any |= reinterpret_cast<std::uintptr_t>(children[k]);
        return any != 0;
    }

    /** Without a branch for each child: which ones there are follows no pattern that a processor could guess.
     */
    void addBlock(Children children, int x, int y, int z)
    {
        unsigned free = 0, occupied = 0;
        for (unsigned k = 0; k < 8; ++k) {
            const auto* child = static_cast<const octomap::OcTreeNode*>(children[k]);
            const float logOdds = (child != nullptr ? child : &m_unknown)->getLogOdds();
            occupied |= (logOdds >= m_occupied ? 1U : 0U) << k;
            free |= (logOdds <= m_free ? 1U : 0U) << k;
        }
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
