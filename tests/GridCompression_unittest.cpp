#include <gtest/gtest.h>
#include <mrpt/maps/COctoMap.h>
#include <octomap/OcTree.h>

#include <random>

#include "gr2to/base/errors.h"
#include "gr2to/grid/HeightHistogram.h"
#include "gr2to/grid/VoxelColumns.h"
#include "gr2to/mrpt/octree.h"
#include "gr2to/stages/GridCompression.h"
#include "support/building/Octrees.h"
#include "support/drawMap.h"
#include "support/inputFiles.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
constexpr int kO = VoxelBoxes::kOrigin;

VoxelBox cube(int x, int y, int z, int log2Side, bool occupied)
{
    return {static_cast<std::uint16_t>(kO + x), static_cast<std::uint16_t>(kO + y),
            static_cast<std::uint16_t>(kO + z), static_cast<std::uint8_t>(log2Side), occupied};
}

/** Columns of voxels of 0.1 m along x, each drawn from the bottom up: '#' occupied, '.' free, ' ' unknown. */
VoxelBoxes columnsOf(const std::vector<std::string>& columns)
{
    VoxelBoxes voxels;
    voxels.resolution_m = 0.1;
    for (std::size_t x = 0; x < columns.size(); ++x)
        for (std::size_t z = 0; z < columns[x].size(); ++z)
            if (columns[x][z] != ' ')
                voxels.boxes.push_back(
                    cube(static_cast<int>(x), 0, static_cast<int>(z), 0, columns[x][z] == '#'));
    return voxels;
}

/** All layers of columnsOf(), no filter. */
TCompressionOptions literal(double no_min, double nf_max, double top_m)
{
    TCompressionOptions options;
    options.z_min = 0;
    options.z_max = top_m;
    options.no_min = no_min;
    options.nf_max = nf_max;
    options.furniture_height = 0;
    return options;
}

std::string statesOf(const CompressedGrid& compressed, int cells)
{
    std::string states;
    for (int x = 0; x < cells; ++x) {
        const CellState state = compressed.grid.at({x, 0});
        states += state == CellState::Occupied ? '#' : state == CellState::Free ? '.' : '?';
    }
    return states;
}

octomap::OcTree treeOf(const VoxelBoxes& voxels)
{
    octomap::OcTree tree(voxels.resolution_m);
    voxels.forEach([&](const VoxelBox& box) {
        for (int k = 0; k < box.side() * box.side() * box.side(); ++k) {
            const int side = box.side();
            const octomap::OcTreeKey key(static_cast<octomap::key_type>(box.x + k % side),
                                         static_cast<octomap::key_type>(box.y + k / side % side),
                                         static_cast<octomap::key_type>(box.z + k / side / side));
            tree.setNodeValue(key, box.occupied ? 2.0F : -2.0F, true);
        }
    });
    tree.updateInnerOccupancy();
    return tree;
}

/** Random cubes, each in an 8-voxel cell of its own. */
VoxelBoxes randomCubes(unsigned seed)
{
    std::mt19937 random(seed);
    VoxelBoxes voxels;
    for (int k = 0; k < 200; ++k) {
        const int log2Side = static_cast<int>(random() % 4), side = 1 << log2Side;
        const auto inside = [&] {
            return static_cast<int>(random() % static_cast<unsigned>(8 / side)) * side;
        };
        const VoxelBox box = cube(8 * (k % 6) + inside(), 8 * (k / 6 % 5) + inside(),
                                  8 * (k / 30 + 1) + inside(), log2Side, random() % 2 == 0);
        voxels.boxes.push_back(box);
    }
    return voxels;
}

std::string complaintOf(const VoxelBoxes& voxels, const TCompressionOptions& options)
{
    return inputErrorOf([&] { GridCompressor(options).compress(voxels); });
}
}  // namespace

TEST(GridCompression, followsEquation7WithStrictComparisons)
{
    const VoxelBoxes voxels = columnsOf({"####    ",    // NO 4 > 2, NF 0 < 3
                                         "##      ",    // NO = NO_min: not occupied
                                         "####... ",    // NF = NF_max: neither
                                         "####.... ",   // NF > NF_max
                                         "........",    //
                                         "###..   ",    // NO 3 > 2, NF 2 < 3
                                         "...     "});  // NF = NF_max
    EXPECT_EQ(statesOf(GridCompressor(literal(0.2, 0.3, 0.8)).compress(voxels), 7), "#??..#?");
}

TEST(GridCompression, countsOnlyBetweenZMinAndZMax)
{
    const VoxelBoxes voxels = columnsOf({"##......##", "..######..", "##########"});
    TCompressionOptions options = literal(0.3, 0.3, 0.8);
    options.z_min = 0.2;
    EXPECT_EQ(statesOf(GridCompressor(options).compress(voxels), 3), ".##");
}

TEST(GridCompression, countsALargeLeafAsTheVoxelsThatItCoversInAllItsColumns)
{
    VoxelBoxes voxels;
    voxels.resolution_m = 0.1;
    voxels.boxes = {cube(0, 0, 0, 3, true), cube(8, 0, 0, 3, false)};
    const CompressedGrid compressed = GridCompressor(literal(0.75, 0.75, 0.8)).compress(treeOf(voxels));
    EXPECT_EQ(compressed.leaves, 1024u);  // not yet pruned
    octomap::OcTree pruned = treeOf(voxels);
    pruned.prune();
    const CompressedGrid same = GridCompressor(literal(0.75, 0.75, 0.8)).compress(pruned);
    EXPECT_EQ(same.leaves, 2u);
    EXPECT_EQ(same.grid, compressed.grid);
    EXPECT_EQ(same.grid.count(CellState::Occupied), 64u);
    EXPECT_EQ(same.grid.count(CellState::Free), 64u);
}

TEST(GridCompression, countsVoxelsAsTheSlowWayDoes)
{
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const VoxelBoxes drawn = randomCubes(seed);
        octomap::OcTree tree = treeOf(drawn);
        tree.prune();
        const VoxelBoxes voxels = voxelsOf(tree, 0.45, 0.55);
        VoxelBounds bounds = boundsOf(voxels);
        bounds.firstZ +=
            static_cast<int>(seed % 3);  // blocks that the range cuts; ranges of more and less than 64 layers
        bounds.lastZ -= static_cast<int>(seed / 2);
        const VoxelColumns columns(voxels, bounds);
        for (int y = 0; y < columns.height(); ++y)
            for (int x = 0; x < columns.width(); ++x) {
                int free = 0, occupied = 0, highest = -1, lowest = -1;
                for (int z = 0; z < columns.layers(); ++z) {
                    const auto* node =
                        tree.search(octomap::OcTreeKey(static_cast<octomap::key_type>(bounds.firstX + x),
                                                       static_cast<octomap::key_type>(bounds.firstY + y),
                                                       static_cast<octomap::key_type>(bounds.firstZ + z)));
                    if (node == nullptr) continue;
                    if (!tree.isNodeOccupied(node)) {
                        ++free;
                        continue;
                    }
                    ++occupied;
                    highest = z;
                    lowest = lowest < 0 ? z : lowest;
                }
                const auto column = static_cast<std::size_t>(y * columns.width() + x);
                ASSERT_EQ(columns.countFree(column), free);
                ASSERT_EQ(columns.countOccupied(column), occupied);
                ASSERT_EQ(columns.highestOccupied(column), highest);
                ASSERT_EQ(columns.lowestOccupied(column), lowest);
                ASSERT_EQ(columns.isUnknown(column), free + occupied == 0);
                ASSERT_EQ(columns.countFree(column, 0, 5) + columns.countFree(column, 5, columns.layers()),
                          free);
            }
    }
}

TEST(GridCompression, findsFloorAndCeilingAndMeasuresHeightsFromTheFloor)
{
    const ClassifiedGrid plan = drawMap({"########", "#......#", "#......#", "########"}, 0.1);
    VoxelBoxes voxels = extruded(plan, 2.5);
    for (VoxelBox& box : voxels.boxes)  // a lintel from 2.1 m on
        if (box.x == kO + 3 && box.y == kO + 1 && box.z >= kO + 21) box.occupied = true;
    const CompressedGrid c = GridCompressor(TCompressionOptions()).compress(voxels);
    EXPECT_TRUE(c.range.floorFound);
    EXPECT_TRUE(c.range.ceilingFound);
    EXPECT_NEAR(c.range.z_min_m, 0, 1e-9);
    EXPECT_NEAR(c.range.z_max_m, 2.5, 1e-9);
    ASSERT_TRUE(c.heights.top_m({0, 1}).has_value());
    EXPECT_NEAR(*c.heights.top_m({0, 1}), 2.5, 1e-9);
    ASSERT_TRUE(c.heights.lintel_m({3, 1}).has_value());
    EXPECT_NEAR(*c.heights.lintel_m({3, 1}), 2.1, 1e-9);
    EXPECT_FALSE(c.heights.lintel_m({3, 2}).has_value());
    TCompressionOptions cut;
    cut.z_max = 1.5;
    EXPECT_FALSE(GridCompressor(cut).compress(voxels).heights.top_m({0, 1}).has_value())
        << "how high a wall is cannot be seen below z_max";
}

TEST(GridCompression, takesNoDeskForAFloorAndNoSingleSurfaceForBoth)
{
    HeightHistogram histogram{kO, std::vector<std::int64_t>(30, 100)};
    histogram.occupied[2] = 1000;
    histogram.occupied[9] = 400;  // desks
    RoomHeight room = findRoomHeight(histogram, 0.1);
    EXPECT_EQ(room.floor, kO + 3);
    EXPECT_FALSE(room.ceiling.has_value());
    histogram.occupied[28] = 700;
    histogram.occupied[27] =
        300;  // part of the ceiling: more than a tenth of what the peak has over the median
    room = findRoomHeight(histogram, 0.1);
    EXPECT_EQ(room.floor, kO + 3);
    EXPECT_EQ(room.ceiling, kO + 27);
    histogram.occupied[2] = 100;
    histogram.occupied[9] = 100;
    room = findRoomHeight(histogram, 0.1);
    EXPECT_FALSE(room.floor.has_value());
    EXPECT_EQ(room.ceiling, kO + 27);
}

TEST(GridCompression, removesWhatEndsBelowHeadHeightUnderAirAndNothingElse)
{
    // the lowest layer is the floor
    const std::string chest = "#######              .....";      // 0.6 m, air seen above 2 m only
    const std::string wardrobe = "#####################  ....";  // 2 m: no furniture
    const std::string unseen = "#######                     ";   // nothing known above it
    const std::string floor = "#..........................", wall = "###########################";
    std::vector<std::string> columns = {wall, chest, wardrobe, unseen};
    columns.resize(44, floor);
    const VoxelBoxes voxels = columnsOf(columns);
    TCompressionOptions options;
    const CompressedGrid filtered = GridCompressor(options).compress(voxels);
    EXPECT_NEAR(filtered.range.z_min_m, 0.1, 1e-9);
    EXPECT_EQ(statesOf(filtered, 5), "#.##.");
    EXPECT_EQ(filtered.furnitureCells, 1u);
    options.furniture_height = 0;
    EXPECT_EQ(statesOf(GridCompressor(options).compress(voxels), 5), "####.");
}

TEST(GridCompression, refusesRangesAndLimitsThatLeaveNothing)
{
    const VoxelBoxes voxels = columnsOf({"########", "........"});
    EXPECT_NE(complaintOf(voxels, literal(0, 0.8, 0.8)).find("nf_max = 0.8 m leaves no free"),
              std::string::npos);
    EXPECT_NE(complaintOf(voxels, literal(0.8, 0.3, 0.8)).find("no_min = 0.8 m leaves no occupied"),
              std::string::npos);
    TCompressionOptions above;
    above.z_min = 5;
    EXPECT_NE(complaintOf(voxels, above).find("z_min = 5 m lies outside of the octree"), std::string::npos);
    TCompressionOptions below;
    below.z_max = -1;
    EXPECT_NE(complaintOf(voxels, below).find("z_max = -1 m lies outside of the octree"), std::string::npos);
    EXPECT_NE(complaintOf(VoxelBoxes(), TCompressionOptions()).find("no voxel"), std::string::npos);
    TCompressionOptions crossed;
    crossed.z_min = 2;
    crossed.z_max = 1;
    EXPECT_THROW(GridCompressor{crossed}, std::invalid_argument);
    TCompressionOptions overlapping;
    overlapping.p_max = 0.6;
    EXPECT_THROW(GridCompressor{overlapping}, std::invalid_argument);
}

TEST(GridCompression, takesTheOctreeOfAnMrptMap)
{
    mrpt::maps::COctoMap map(0.1);
    for (int z = 0; z < 10; ++z)
        for (int k = 0; k < 5; ++k) {
            map.updateVoxel(0.05, 0.05, 0.05 + 0.1 * z, true);
            map.updateVoxel(0.15, 0.05, 0.05 + 0.1 * z, false);
        }
    const CompressedGrid compressed = GridCompressor(literal(0.3, 0.3, 1)).compress(octreeOf(map));
    EXPECT_EQ(statesOf(compressed, 2), "#.");
    EXPECT_EQ(compressed.leaves, 20u);
}
