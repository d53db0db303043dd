#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "gr2to/stages/GridCompression.h"

using namespace gr2to;

namespace
{
constexpr int kO = VoxelBoxes::kOrigin;
constexpr double kFree = 0.45, kOccupied = 0.55;  // P_Max and P_Min

octomap::OcTreeKey keyOf(int x, int y, int z)
{
    return {static_cast<octomap::key_type>(kO + x), static_cast<octomap::key_type>(kO + y),
            static_cast<octomap::key_type>(kO + z)};
}
}  // namespace

TEST(OctreeLeaves, takesProbabilitiesAtThePMaxAndPMinAsFreeAndOccupied)
{
    octomap::OcTree tree(0.1);
    const auto set = [&](int x, double p) { tree.setNodeValue(keyOf(x, 0, 0), octomap::logodds(p)); };
    set(0, 0.3);
    set(1, 0.31);
    set(2, 0.69);
    set(3, 0.7);
    const VoxelBoxes voxels = voxelsOf(tree, 0.3, 0.7);
    EXPECT_EQ(voxels.count(), 2u);
    voxels.forEach([&](const VoxelBox& box) { EXPECT_EQ(box.occupied, box.x == kO + 3); });
}

TEST(OctreeLeaves, aNodeWhoseChildrenWereDeletedIsALeaf)
{
    for (const int log2Side : {1, 2}) {
        octomap::OcTree tree(0.1);
        const int side = 1 << log2Side;
        for (int k = 0; k < side * side * side; ++k)
            tree.setNodeValue(keyOf(k % side, k / side % side, k / side / side), 2.0F, true);
        tree.updateInnerOccupancy();
        tree.prune();
        octomap::OcTreeNode* leaf = tree.search(keyOf(0, 0, 0));
        tree.expandNode(leaf);
        for (unsigned k = 0; k < 8; ++k) tree.deleteNodeChild(leaf, k);
        ASSERT_FALSE(tree.nodeHasChildren(leaf));
        const VoxelBoxes voxels = voxelsOf(tree, kFree, kOccupied);
        ASSERT_EQ(voxels.count(), 1u);
        EXPECT_EQ(voxels.boxes.at(0).log2Side, log2Side);
        EXPECT_TRUE(voxels.boxes.at(0).occupied);
    }
}
