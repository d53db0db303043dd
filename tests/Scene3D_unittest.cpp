#include "gr2to/view/Scene3D.h"

#include <gtest/gtest.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/CSetOfTriangles.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "gr2to/base/files.h"
#include "gr2to/view/triangulate.h"
#include "support/building/Octrees.h"
#include "support/cli.h"
#include "support/drawMap.h"
#include "support/inputFiles.h"
#include "support/picture.h"
#include "support/someTopologicalMap.h"

using namespace gr2to;
using namespace gr2to::test;
using gr2to::drawMap;  // of a map; the test's own draws grids

namespace
{
using Polygon = std::vector<mrpt::math::TPoint2D>;

double areaOf(const Polygon& polygon)
{
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return twice / 2;
}

double coveredArea(const Polygon& polygon)
{
    double area = 0;
    for (const auto& [a, b, c] : triangulate(polygon)) {
        const double part = areaOf({polygon[a], polygon[b], polygon[c]});
        EXPECT_GT(part, 0);
        area += part;
    }
    return area;
}
std::shared_ptr<mrpt::opengl::CSetOfTriangles> wallsOf(const TopologicalMap& map,
                                                       const TSceneOptions& options)
{
    return std::dynamic_pointer_cast<mrpt::opengl::CSetOfTriangles>(
        drawMap(map, options)->getByName("walls"));
}

/** A room of 2 x 1 m in voxels of 0.1 m, 2.5 m high. */
VoxelBoxes roomOfVoxels()
{
    std::vector<std::string> rows(12, "#" + std::string(20, '.') + "#");
    rows.front() = rows.back() = std::string(22, '#');
    return extruded(drawMap(rows, 0.1), 2.5);
}
}  // namespace

TEST(Triangulate, coversConvexAndOtherPolygonsOnce)
{
    const Polygon square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Polygon corner = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    const Polygon comb = {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1},
                          {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
    const Polygon collinear = {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    for (const Polygon& polygon : {square, corner, comb, collinear})
        EXPECT_NEAR(coveredArea(polygon), areaOf(polygon), 1e-12);
}

TEST(Triangulate, makesNothingOfLessThanATriangle)
{
    EXPECT_TRUE(triangulate({}).empty());
    EXPECT_TRUE(triangulate({{0, 0}, {1, 0}}).empty());
    EXPECT_TRUE(triangulate({{0, 0}, {1, 0}, {2, 0}}).empty());
}

TEST(Scene3D, wallsAndDoorsStandAsHighAsTheyWereMeasured)
{
    TSceneOptions options;
    options.graph = false;
    options.wall_height = 3.25;
    const auto highest = [&](const TopologicalMap& map) {
        const auto walls = wallsOf(map, options);
        float z = -1;
        for (std::size_t i = 0; i < walls->getTrianglesCount(); ++i) {
            mrpt::opengl::TTriangle triangle;
            walls->getTriangle(i, triangle);
            for (const auto& vertex : triangle.vertices) z = std::max(z, vertex.xyzrgba.pt.z);
        }
        return z;
    };
    TopologicalMap map = someMap();
    for (const auto& [id, place] : map.places())
        for (Wall& wall : map.place(id).walls) {
            wall.size.height_m.reset();
            wall.real = true;
        }
    EXPECT_NEAR(highest(map), map.places().begin()->second.center.z + 3.25, 1e-5);
    map.place(map.places().begin()->first).walls.at(0).size.height_m = 4.5;
    EXPECT_NEAR(highest(map), map.places().begin()->second.center.z + 4.5, 1e-5);
}

TEST(Scene3D, wallsAreSeenThroughAsFarAsWanted)
{
    TSceneOptions options;
    for (const double opacity : {1.0, 0.4}) {
        options.wall_opacity = opacity;
        TopologicalMap map = someMap();
        for (const auto& [id, place] : map.places())
            for (Wall& wall : map.place(id).walls) wall.real = true;
        const auto walls = wallsOf(map, options);
        std::size_t seenThrough = 0;
        for (std::size_t i = 0; i < walls->getTrianglesCount(); ++i) {
            mrpt::opengl::TTriangle triangle;
            walls->getTriangle(i, triangle);
            seenThrough += triangle.vertices[0].xyzrgba.a == std::lround(255 * opacity) ? 1 : 0;
        }
        EXPECT_GT(seenThrough, 0u);
    }
}

TEST(Scene3D, voxelsAreDrawnWithoutFloorAndCeiling)
{
    const VoxelBoxes voxels = roomOfVoxels();
    const auto drawn = std::dynamic_pointer_cast<mrpt::opengl::COctoMapVoxels>(drawVoxels(voxels));
    ASSERT_TRUE(drawn);
    constexpr std::size_t wallCells = 22 * 12 - 20 * 10, layers = 25;
    ASSERT_EQ(drawn->getVoxelCount(mrpt::opengl::VOXEL_SET_OCCUPIED), wallCells * layers);
    for (std::size_t i = 0; i < wallCells * layers; ++i) {
        const auto& voxel = drawn->getVoxel(mrpt::opengl::VOXEL_SET_OCCUPIED, i);
        ASSERT_GT(voxel.coords.z, 0);
        ASSERT_LT(voxel.coords.z, 2.5F);
        ASSERT_NEAR(voxel.side_length, 0.1, 1e-9);
    }
}

TEST(Scene3D, largeCubesAreDrawnAsFarAsTheyReachIntoTheRoom)
{
    VoxelBoxes voxels = roomOfVoxels();
    constexpr int far = VoxelBoxes::kOrigin + 64;
    voxels.boxes.push_back({far, far, VoxelBoxes::kOrigin - 2, 2, true});  // two of its four layers
    voxels.boxes.push_back({far, far, VoxelBoxes::kOrigin + 8, 3, true});  // all of it
    const auto drawn = std::dynamic_pointer_cast<mrpt::opengl::COctoMapVoxels>(drawVoxels(voxels));
    std::size_t ofPart = 0, whole = 0;
    for (std::size_t i = 0; i < drawn->getVoxelCount(mrpt::opengl::VOXEL_SET_OCCUPIED); ++i) {
        const auto& voxel = drawn->getVoxel(mrpt::opengl::VOXEL_SET_OCCUPIED, i);
        if (voxel.coords.x < 6) continue;
        (voxel.side_length > 0.5 ? whole : ofPart) += 1;
    }
    EXPECT_EQ(ofPart, 4u * 4 * 2);
    EXPECT_EQ(whole, 1u);
}

TEST(Scene3D, anOctreeWithNothingToDrawIsRefused)
{
    VoxelBoxes nothing;
    EXPECT_NE(inputErrorOf([&] { drawVoxels(nothing); }).find("no occupied voxel"), std::string::npos);
}

TEST(Scene3D, optionsOutOfRangeAreRefused)
{
    TSceneOptions options;
    options.elevation = 91;
    EXPECT_THROW(drawMap(someMap(), options), std::invalid_argument);
}

class CliRender : public testing::Test
{
 protected:
    CliRender()
    {
        writeRooms(m_folder);
        EXPECT_EQ(runCli(m_folder.path(), {"extract", "rooms.yaml", "-q", "-o", "out"}).code, 0);
    }
    CliRun render(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), "render");
        return runCli(m_folder.path(), arguments);
    }
    TempFolder m_folder;
};

TEST_F(CliRender, drawsThePlacesWithoutADisplay)
{
    const CliRun run = render({"out", "--to", "png", "--scene-width", "320", "--scene-height", "200",
                               "--scene-elevation", "90", "--scene-graph", "no"});
    if (run.err.find("EGL") != std::string::npos) GTEST_SKIP() << "no off-screen OpenGL here: " << run.err;
    ASSERT_EQ(run.code, 0) << run.err;
    const Picture picture = decodePng(readFile(m_folder.path() / "out/topomap.png"));
    ASSERT_EQ(picture.width, 320);
    ASSERT_EQ(picture.height, 200);
    // Seen from above, the map's two floors fill the middle of the picture, left and right.
    EXPECT_NE(picture.at(110, 100), picture.at(210, 100));
    EXPECT_NE(picture.at(110, 100), picture.at(2, 2));
}

TEST_F(CliRender, writesASceneThatMrptReads)
{
    ASSERT_EQ(render({"out/topomap.xml", "--to", "3Dscene", "-o", "deep/er/map.3Dscene"}).code, 0);
    mrpt::opengl::COpenGLScene scene;
    ASSERT_TRUE(scene.loadFromFile((m_folder.path() / "deep/er/map.3Dscene").string()));
    EXPECT_TRUE(scene.getByClass<mrpt::opengl::CSetOfTriangles>());
}

TEST_F(CliRender, drawsTheOctreeThatTheMapWasMadeFrom)
{
    m_folder.write("room.bt", binaryOctree(roomOfVoxels()));
    ASSERT_EQ(render({"out", "--to", "3Dscene", "-o", "map.3Dscene", "--octree", "room.bt"}).code, 0);
    mrpt::opengl::COpenGLScene scene;
    ASSERT_TRUE(scene.loadFromFile((m_folder.path() / "map.3Dscene").string()));
    const auto voxels = scene.getByClass<mrpt::opengl::COctoMapVoxels>();
    ASSERT_TRUE(voxels);
    EXPECT_GT(voxels->getVoxelCount(mrpt::opengl::VOXEL_SET_OCCUPIED), 1000u);
}

TEST_F(CliRender, badUsageIsTold)
{
    m_folder.write("cut.bt", binaryOctree(roomOfVoxels()).substr(0, 100));
    const auto before = contentOf(m_folder.path());
    expectBadUsage(render({"out", "--to", "3Dscene", "--octree", "cut.bt"}), {"cut.bt", "truncated"});
    expectBadUsage(render({"out", "--to", "3Dscene", "--octree", "rooms.png"}), {"rooms.png", "no OctoMap"});
    expectBadUsage(render({"out", "--to", "3Dscene", "--octree", "none.bt"}), {"none.bt"});
    expectBadUsage(render({"out", "--to", "png", "--scene-wall-opacity", "2"}), {"scene.wall_opacity = 2"});
    EXPECT_EQ(contentOf(m_folder.path()), before);
    expectBadUsage(render({"out", "--to", "jpeg"}), {"'jpeg'", "png, 3Dscene"});
    expectBadUsage(render({"nowhere", "--to", "png"}), {"'nowhere'"});
    expectBadUsage(render({"rooms.png", "--to", "png"}), {"rooms.png"});
}
