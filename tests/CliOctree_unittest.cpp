#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "gr2to/io/XmlMap.h"
#include "support/building/Octrees.h"
#include "support/cli.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
/** The rooms of writeRooms() as a storey of 2.5 m, with a lintel from 2.0 m on over the door. */
VoxelBoxes roomsIn3D()
{
    const ClassifiedGrid plan = roomsGrid();
    VoxelBoxes voxels = extruded(plan, 2.5);
    const auto isWall = [&](int x) {
        int occupied = 0;
        for (int y = 1; y + 1 < plan.height(); ++y) occupied += plan.isOccupied({x, y}) ? 1 : 0;
        return occupied > plan.height() / 2;
    };
    for (VoxelBox& box : voxels.boxes) {
        const int x = box.x - VoxelBoxes::kOrigin + 10;  // the grid begins at x = -1 m
        if (x > 5 && x < plan.width() - 5 && isWall(x) && box.z >= VoxelBoxes::kOrigin + 20)
            box.occupied = true;
    }
    return voxels;
}

/** A call that has to be refused. */
struct BadOctree
{
    const char* name;
    std::vector<std::string> arguments;
    std::vector<std::string> words;
};
}  // namespace

TEST(CliOctree, extractMakesAMapWithHeights)
{
    const TempFolder folder;
    folder.write("rooms.bt", binaryOctree(roomsIn3D()));
    const CliRun run = runCli(folder.path(), {"extract", "rooms.bt", "-o", "out", "--json"});
    ASSERT_EQ(run.code, 0) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json["places"], 2);
    EXPECT_EQ(json["doors"], 1);
    EXPECT_NEAR(json["compression"]["z_min_m"], 0, 1e-9);
    EXPECT_NEAR(json["compression"]["z_max_m"], 2.5, 1e-9);
    EXPECT_TRUE(json["compression"]["floor_found"]);
    EXPECT_TRUE(json["compression"]["ceiling_found"]);
    const TopologicalMap map = readXml(folder.path() / "out" / "topomap.xml");
    const Doorway door = map.connections().front().doorway;
    ASSERT_TRUE(door.size.height_m.has_value());
    EXPECT_NEAR(*door.size.height_m, 2.0, 1e-9);
    EXPECT_NEAR(door.position.mean.z, 1.0, 1e-9);
    for (const Wall& wall : map.places().begin()->second.walls)
        if (wall.real) {
            ASSERT_TRUE(wall.size.height_m.has_value());
            EXPECT_NEAR(*wall.size.height_m, 2.5, 1e-9);
        }
    EXPECT_EQ(runCli(folder.path(), {"validate", "out"}).code, 0);
    const CliRun text = runCli(folder.path(), {"extract", "rooms.bt", "-o", "out"});
    EXPECT_NE(text.out.find("z = 0.000 m (floor found) to 2.500 m (ceiling found)"), std::string::npos)
        << text.out;
}

TEST(CliOctree, fullAndBinaryFilesGiveTheSameMap)
{
    const TempFolder folder;
    const auto binary = folder.write("rooms.bt", binaryOctree(roomsIn3D()));
    octomap::OcTree tree(binary.string());
    std::ostringstream full;
    tree.write(full);
    folder.write("rooms.ot", full.str());
    for (const char* name : {"rooms.bt", "rooms.ot"})
        ASSERT_EQ(runCli(folder.path(), {"extract", name, "-o", std::string("out-") + name, "-q"}).code, 0);
    EXPECT_EQ(contentOf(folder.path() / "out-rooms.bt").at("places.png"),
              contentOf(folder.path() / "out-rooms.ot").at("places.png"));
}

TEST(CliOctree, infoTellsWhatAnOctreeHolds)
{
    const TempFolder folder;
    folder.write("rooms.bt", binaryOctree(roomsIn3D()));
    const CliRun text = runCli(folder.path(), {"info", "rooms.bt"});
    EXPECT_EQ(text.code, 0) << text.err;
    for (const char* word :
         {"OctoMap binary octree", "0.1 m a voxel", "floor       z = 0.000 m", "ceiling     z = 2.500 m"})
        EXPECT_NE(text.out.find(word), std::string::npos) << word << " in\n" << text.out;
    const auto json = nlohmann::json::parse(runCli(folder.path(), {"info", "rooms.bt", "--json"}).out);
    EXPECT_EQ(json["kind"], "octree");
    EXPECT_NEAR(json["floor_m"], 0, 1e-9);
    EXPECT_GT(json["occupied"]["voxels"], 1000);
}

TEST(CliOctree, badInputIsRefusedAndLeavesNothingBehind)
{
    const TempFolder folder;
    const std::string good = binaryOctree(roomsIn3D());
    folder.write("good.bt", good);
    folder.write("cut.bt", good.substr(0, good.size() / 2));
    folder.write("cut.ot", "# Octomap OcTree file\nid OcTree\nsize 4\nres 0.1\ndata\nabc");
    folder.write("colour.bt", binaryOctree(roomsIn3D(), "ColorOcTree"));
    folder.write("text.bt", "no octree\n");
    writeRooms(folder);
    const auto before = contentOf(folder.path());
    const std::vector<BadOctree> calls = {
        {"truncated .bt", {"cut.bt"}, {"cut.bt", "truncated"}},
        {"truncated .ot", {"cut.ot"}, {"cut.ot", "truncated"}},
        {"another tree type", {"colour.bt"}, {"colour.bt", "ColorOcTree", "convert"}},
        {"no octree at all", {"text.bt"}, {"text.bt", "holds text"}},
        {"z range above the tree", {"good.bt", "--z-min", "9"}, {"good.bt", "z_min = 9 m", "lies outside"}},
        {"z range below the tree", {"good.bt", "--z-max", "-3"}, {"good.bt", "z_max = -3 m", "lies outside"}},
        {"z range upside down", {"good.bt", "--z-min", "2", "--z-max", "1"}, {"z_max", "must exceed"}},
        {"z range between two layers",
         {"good.bt", "--z-min", "0.06", "--z-max", "0.08"},
         {"good.bt", "z_min = 0.06 m and z_max = 0.08 m", "farther apart"}},
        {"NO_min leaves nothing",
         {"good.bt", "--compression-no-min", "4"},
         {"good.bt", "no_min", "leaves no occupied"}},
        {"NF_max leaves nothing",
         {"good.bt", "--compression-nf-max", "4"},
         {"good.bt", "nf_max", "leaves no free"}},
        {"an option for images",
         {"good.bt", "--resolution", "0.1"},
         {"good.bt", "input.resolution", "does not apply"}},
        {"an option for octrees",
         {"rooms.yaml", "--z-min", "0"},
         {"rooms.yaml", "compression.z_min", "does not apply"}},
    };
    for (const BadOctree& call : calls) {
        SCOPED_TRACE(call.name);
        std::vector<std::string> arguments = {"extract", "-o", "out"};
        arguments.insert(arguments.end(), call.arguments.begin(), call.arguments.end());
        expectBadUsage(runCli(folder.path(), arguments), call.words);
        EXPECT_EQ(contentOf(folder.path()), before);
    }
    expectBadUsage(runCli(folder.path(), {"info", "cut.bt"}), {"cut.bt", "truncated"});
}
