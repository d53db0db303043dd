#include <gtest/gtest.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>

#include <sstream>

#include "gr2to/io/OctreeReader.h"
#include "support/building/Octrees.h"
#include "support/drawMap.h"
#include "support/inputFiles.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
octomap::OcTree someTree()
{
    octomap::OcTree tree(0.1);
    for (int k = 0; k < 40; ++k)
        tree.updateNode(
            octomap::point3d(0.1F * static_cast<float>(k % 7), 0.1F * static_cast<float>(k), 0.5F),
            k % 3 == 0);
    return tree;
}

std::string binaryBytes(const octomap::AbstractOccupancyOcTree& tree)
{
    std::ostringstream out;
    tree.writeBinaryConst(out);
    return out.str();
}

std::string fullBytes(const octomap::AbstractOcTree& tree)
{
    std::ostringstream out;
    tree.write(out);
    return out.str();
}

std::string complaintAbout(const std::string& name, const std::string& bytes)
{
    const TempFolder folder;
    const auto file = folder.write(name, bytes);
    std::string message = inputErrorOf([&] { readOctree(file); });
    EXPECT_NE(message.find(name), std::string::npos) << message;
    return message;
}

void expectWord(const std::string& message, const std::string& word)
{
    EXPECT_NE(message.find(word), std::string::npos) << message;
}
}  // namespace

TEST(OctreeReader, readsWhatOctoMapWrites)
{
    const TempFolder folder;
    const octomap::OcTree tree = someTree();
    const OctreeFile full = readOctree(folder.write("tree.ot", fullBytes(tree)));
    EXPECT_TRUE(*full.tree == tree);
    EXPECT_EQ(full.nodes, tree.size());
    EXPECT_EQ(full.resolution_m, 0.1);
    octomap::OcTree likely = tree;
    likely.toMaxLikelihood();
    const OctreeFile binary = readOctree(folder.write("tree.bt", binaryBytes(likely)));
    EXPECT_TRUE(*binary.tree == likely);
    EXPECT_EQ(binary.nodes, tree.size());
}

TEST(OctreeReader, readsTheTestsOwnOctrees)
{
    const TempFolder folder;
    const VoxelBoxes voxels = extruded(drawMap({"####", "#..#", "####"}, 0.1), 2);
    const OctreeFile file = readOctree(folder.write("tree.bt", binaryOctree(voxels)));
    EXPECT_EQ(file.tree->getNumLeafNodes(), voxels.count());
    EXPECT_EQ(file.nodes, file.tree->size());
}

TEST(OctreeReader, readsAnEmptyTree)
{
    const TempFolder folder;
    EXPECT_EQ(readOctree(folder.write("tree.bt", binaryBytes(octomap::OcTree(0.1)))).tree->size(), 0u);
}

TEST(OctreeReader, refusesEveryTruncationByName)
{
    const octomap::OcTree tree = someTree();
    for (const std::string& bytes : {binaryBytes(tree), fullBytes(tree)})
        for (std::size_t size = 40; size < bytes.size(); size += 7)
            expectWord(complaintAbout("cut.bt", bytes.substr(0, size)), "truncated");
}

TEST(OctreeReader, refusesOtherTypesOfTrees)
{
    octomap::ColorOcTree tree(0.1);
    tree.updateNode(octomap::point3d(0, 0, 0), true);
    expectWord(complaintAbout("colour.bt", binaryBytes(tree)), "'ColorOcTree'");
    expectWord(complaintAbout("colour.ot", fullBytes(tree)), "'ColorOcTree'");
}

TEST(OctreeReader, refusesWhatIsDamaged)
{
    const std::string good = binaryBytes(someTree());
    const std::size_t data = good.find("data\n") + 5;
    expectWord(complaintAbout("long.bt", good + "xx"), "2 bytes behind its last node");
    std::string empty = good;
    empty[data] = empty[data + 1] = 0;
    expectWord(complaintAbout("empty.bt", empty), "holds nothing");
    std::string deep = good.substr(0, data) + std::string(64, '\x03');
    expectWord(complaintAbout("deep.bt", deep), "damaged");
    std::string size = good;
    size.replace(size.find("size "), 6, "size 9");
    expectWord(complaintAbout("size.bt", size), "announces");
    std::string resolution = good;
    resolution.replace(resolution.find("res "), 5, "res -");
    expectWord(complaintAbout("res.bt", resolution), "resolution");
    expectWord(complaintAbout("text.bt", "hello\n"), "no OctoMap");
    std::string full = fullBytes(someTree());
    full.replace(full.find("data\n") + 5, 4, "\xff\xff\xff\x7f");
    expectWord(complaintAbout("nan.ot", full), "not a number");
}
