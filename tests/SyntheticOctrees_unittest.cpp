#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "gr2to/grid/VoxelColumns.h"
#include "gr2to/io/GridReader.h"
#include "gr2to/io/OctreeReader.h"
#include "gr2to/pipeline/Gr2To.h"
#include "support/inputFiles.h"

using namespace gr2to;
using namespace gr2to::test;
namespace fs = std::filesystem;

/** Octrees made from annotated floor plans: what is wall, furniture and lintel in them is known. */
namespace
{
constexpr double kResolution_m = 0.05;

/** The real door within 0.5 m of a point. */
std::optional<Doorway> nearestDoor(const TopologicalMap& map, double x, double y)
{
    std::optional<Doorway> nearest;
    double best = 0.5;
    for (const Connection& c : map.connections()) {
        const double d = std::hypot(c.doorway.position.mean.x - x, c.doorway.position.mean.y - y);
        if (d > best || !c.doorway.real) continue;
        best = d;
        nearest = c.doorway;
    }
    return nearest;
}

/** A plan, the octree made from it and what the program makes of the octree. */
class SyntheticOctree : public testing::TestWithParam<const char*>
{
 protected:
    void SetUp() override
    {
        const fs::path data = GR2TO_EVALUATION_DATA;
        const std::string name = GetParam();
        const fs::path octree = data / "3d" / ("synthetic_" + name + ".bt");
        if (!fs::exists(octree))
            GTEST_SKIP() << "the evaluation data 3d is not here: its octrees are not tested";
        std::ifstream(data / "3d" / ("synthetic_" + name + ".3d.json")) >> m_truth;
        m_clean = readGrid(data / "ipa" / (name + ".clean.png"), imageOptions());
        m_furnished = readGrid(data / "ipa" / (name + ".furnitures.png"), imageOptions());
        m_file = readOctree(octree);
        const TCompressionOptions options;
        m_voxels = voxelsOf(*m_file.tree, options.p_max, options.p_min);
        m_compressed = Gr2To().compress(*m_file.tree);
    }

    /** The cell of the plan over a cell of the compressed grid; both frames are whole cells apart. */
    Cell inPlan(Cell c) const
    {
        const Eigen::Vector2d p = m_compressed.grid.frame().toMap(c);
        return {static_cast<int>(std::floor(p.x() / kResolution_m)),
                static_cast<int>(std::floor(p.y() / kResolution_m))};
    }

    /** Part of the cells that satisfy `counts` which also satisfy `holds`; both take a cell's index and its
     * cell of the plan. */
    template <class Counts, class Holds>
    double shareOf(const Counts& counts, const Holds& holds) const
    {
        std::size_t all = 0, good = 0;
        for (std::size_t i = 0; i < m_compressed.grid.size(); ++i) {
            const Cell c = inPlan(m_compressed.grid.cell(i));
            if (!m_clean.contains(c) || !counts(i, c)) continue;
            ++all;
            good += holds(i) ? 1 : 0;
        }
        EXPECT_GT(all, 100u);
        return static_cast<double>(good) / static_cast<double>(all);
    }

    nlohmann::json m_truth;
    ClassifiedGrid m_clean, m_furnished;
    OctreeFile m_file;
    VoxelBoxes m_voxels;
    CompressedGrid m_compressed;
};
}  // namespace

TEST_P(SyntheticOctree, hasItsFloorAndItsCeiling)
{
    EXPECT_TRUE(m_compressed.range.floorFound);
    EXPECT_TRUE(m_compressed.range.ceilingFound);
    EXPECT_NEAR(m_compressed.range.z_min_m, 0, 1e-9);
    EXPECT_NEAR(m_compressed.range.z_max_m, m_truth["room_height_m"], 1e-9);
}

TEST_P(SyntheticOctree, hasNoFurnitureAfterStageOne)
{
    const double free =
        shareOf([&](std::size_t, Cell c) { return m_clean.isFree(c) && !m_furnished.isFree(c); },
                [&](std::size_t i) { return m_compressed.grid[i] == CellState::Free; });
    RecordProperty("free_per_mille", static_cast<int>(1000 * free));
    EXPECT_GE(free, 0.98);
}

TEST_P(SyntheticOctree, keepsTheWallsThatRaysHit)
{
    const GridFrame& frame = m_compressed.grid.frame();
    VoxelBounds bounds;
    bounds.firstX = VoxelBoxes::kOrigin + static_cast<int>(std::lround(frame.origin_x_m / kResolution_m));
    bounds.firstY = VoxelBoxes::kOrigin + static_cast<int>(std::lround(frame.origin_y_m / kResolution_m));
    bounds.lastX = bounds.firstX + m_compressed.grid.width();
    bounds.lastY = bounds.firstY + m_compressed.grid.height();
    bounds.firstZ = VoxelBoxes::kOrigin;
    bounds.lastZ = bounds.firstZ + static_cast<int>(m_compressed.layers);
    const VoxelColumns columns(m_voxels, bounds);
    const double occupied =
        shareOf([&](std::size_t i, Cell c) { return !m_clean.isFree(c) && columns.countOccupied(i) > 0; },
                [&](std::size_t i) { return m_compressed.grid[i] == CellState::Occupied; });
    EXPECT_GE(occupied, 0.99);
}

TEST_P(SyntheticOctree, hasDoorsUnderItsLintelsAsHighAsThey)
{
    const Extraction e = Gr2To().extract(m_compressed);
    const auto& lintels = m_truth["lintels"];
    std::size_t found = 0;
    for (const auto& lintel : lintels) {
        const double x = (lintel["mid_px"][0].get<double>() + 0.5) * kResolution_m;
        const double y = (m_clean.height() - lintel["mid_px"][1].get<double>() - 0.5) * kResolution_m;
        const auto door = nearestDoor(e.map, x, y);
        if (!door) continue;
        ++found;
        ASSERT_TRUE(door->size.height_m.has_value()) << "door at " << x << ", " << y;
        EXPECT_NEAR(*door->size.height_m, m_truth["lintel_z_m"], 0.05) << "door at " << x << ", " << y;
    }
    EXPECT_GE(static_cast<double>(found), 0.95 * static_cast<double>(lintels.size()));
    RecordProperty("doors_found", static_cast<int>(found));
}

/** A closed door and the jambs beside it are sides of places too. Jambs are seen up to the lintel or, by
 * slanted rays, a little less, and a short side of jamb and wall is in between; a door whose jambs were not
 * seen has no height. */
TEST_P(SyntheticOctree, hasWallsAsHighAsItsRooms)
{
    const Extraction e = Gr2To().extract(m_compressed);
    const double room_m = m_truth["room_height_m"], lintel_m = m_truth["lintel_z_m"], jamb_m = 0.15;
    const auto connections = e.map.connections();
    const auto isOfDoor = [&](const Wall& wall) {
        const double height_m = wall.size.height_m.value_or(lintel_m);
        if (height_m < lintel_m - jamb_m || height_m > room_m) return false;
        return std::any_of(connections.begin(), connections.end(), [&](const Connection& c) {
            const auto offset = c.doorway.position.mean - wall.position.mean;
            return c.doorway.real && std::hypot(offset.x, offset.y) <= c.doorway.size.length_m / 2 + jamb_m;
        });
    };
    double walls_m = 0, high_m = 0;
    for (const auto& [id, place] : e.map.places())
        for (const Wall& wall : place.walls) {
            if (!wall.real) continue;
            walls_m += wall.size.length_m;
            if ((wall.size.height_m && std::abs(*wall.size.height_m - room_m) <= 0.05 + 1e-9) ||
                isOfDoor(wall))
                high_m += wall.size.length_m;
        }
    EXPECT_GE(high_m, 0.95 * walls_m) << "95 % of the walls, by length";
}

INSTANTIATE_TEST_SUITE_P(All, SyntheticOctree,
                         testing::Values("Freiburg52_scan", "Freiburg79_scan", "lab_ipa", "office_b",
                                         "office_h"),
                         [](const auto& instance) { return std::string(instance.param); });
