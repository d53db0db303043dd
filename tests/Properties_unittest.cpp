#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "gr2to/io/XmlMap.h"
#include "gr2to/mrpt/archive.h"
#include "gr2to/pipeline/Gr2To.h"
#include "support/buildingMeasures.h"
#include "support/freeLabels.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
/** Calls a check with every kind of building, bare, furnished, noisy, in both presets. */
template <class Check>
void forEachExtraction(const Check& check)
{
    auto buildings = variousBuildings();
    auto noisy = buildingOptions(77, 12.0, 0.2);
    noisy.noise = 0.1, noisy.speckle = 0.003, noisy.wall_jitter = 0.3, noisy.closed_doors = 0.3;
    buildings.push_back(noisy);
    for (const TBuildingOptions& options : buildings)
        for (const std::string& preset : Gr2ToOptions::presets()) {
            SCOPED_TRACE(nameOf(options) + ", preset " + preset);
            const Building building = generateBuilding(options);
            check(building, Gr2To(Gr2ToOptions::preset(preset)).extract(building.grid));
        }
}

/** The grid with another frame. */
ClassifiedGrid reframed(const ClassifiedGrid& grid, const GridFrame& frame)
{
    ClassifiedGrid moved(grid.width(), grid.height(), frame);
    for (std::size_t i = 0; i < grid.size(); ++i) moved[i] = grid[i];
    return moved;
}
}  // namespace

TEST(Properties, everyFreeCellIsInOnePlaceAndEveryPlaceHasCells)
{
    forEachExtraction([](const Building& building, const Extraction& e) {
        EXPECT_EQ(breachOfPartition(e.grid, e.places), "");
        for (std::size_t i = 0; i < e.grid.size(); ++i)
            ASSERT_TRUE(building.grid[i] == e.grid[i] || e.grid[i] == CellState::Free)
                << "the filter frees cells and does nothing else";
        std::set<PlaceId> inImage(e.places.ids.begin(), e.places.ids.end()), inMap;
        inImage.erase(0);
        for (const auto& [id, place] : e.map.places()) inMap.insert(id);
        EXPECT_EQ(inImage, inMap);
    });
}

TEST(Properties, areasAddUpToTheFreeCells)
{
    forEachExtraction([](const Building&, const Extraction& e) {
        double area = 0;
        for (const auto& [id, place] : e.map.places()) area += place.area_m2;
        const double cell = e.grid.resolution_m() * e.grid.resolution_m();
        EXPECT_NEAR(area, static_cast<double>(e.grid.count(CellState::Free)) * cell, 1e-6);
    });
}

TEST(Properties, mapsKeepTheInvariantsOfTheModel)
{
    forEachExtraction([](const Building&, const Extraction& e) {
        EXPECT_THAT(e.map.validate(), testing::IsEmpty());
        EXPECT_FALSE(e.map.places().empty());
    });
}

TEST(Properties, xmlAndArchiveLoseNothing)
{
    forEachExtraction([](const Building&, const Extraction& e) {
        EXPECT_TRUE(fromXml(toXml(e.map), "map") == e.map);
        EXPECT_TRUE(fromArchive(toArchive(e.map), "map") == e.map);
    });
}

TEST(Properties, placeCentresLieInTheirPlaces)
{
    forEachExtraction([](const Building& building, const Extraction& e) {
        for (const auto& [id, place] : e.map.places()) {
            const Cell c = cellAt(building.grid, {place.center.x, place.center.y});
            EXPECT_EQ(e.places.at(c), id);
        }
    });
}

TEST(Properties, originAndYawMoveTheMapAndChangeNothingElse)
{
    const ClassifiedGrid plain = generateBuilding(buildingOptions(11)).grid;
    const GridFrame frame{0.05, -12.5, 40.25, 2.1};
    const TopologicalMap a = Gr2To().extract(plain).map, b = Gr2To().extract(reframed(plain, frame)).map;
    const auto move = [&](const mrpt::math::TPoint3D& p) {
        const Eigen::Vector2d grid = plain.frame().toGrid(p.x, p.y);
        return Eigen::Vector2d(frame.toMap(grid.x(), grid.y()));
    };
    const auto expectNear = [](const Eigen::Vector2d& expected, const mrpt::math::TPoint3D& found) {
        EXPECT_NEAR(expected.x(), found.x, 1e-6);
        EXPECT_NEAR(expected.y(), found.y, 1e-6);
    };
    ASSERT_EQ(a.places().size(), b.places().size());
    for (const auto& [id, place] : a.places()) {
        const Place& moved = b.place(id);
        EXPECT_EQ(place.area_m2, moved.area_m2);
        expectNear(move(place.center), moved.center);
        ASSERT_EQ(place.walls.size(), moved.walls.size());
        for (std::size_t w = 0; w < place.walls.size(); ++w) {
            EXPECT_EQ(place.walls[w].real, moved.walls[w].real);
            EXPECT_NEAR(place.walls[w].size.length_m, moved.walls[w].size.length_m, 1e-6);
            expectNear(move(place.walls[w].position.mean), moved.walls[w].position.mean);
            const auto& n = place.walls[w].normal.mean;
            const Eigen::Vector2d turned = frame.directionToMap({n.x, n.y});
            expectNear(turned, moved.walls[w].normal.mean);
        }
    }
    const auto doors = a.connections(), movedDoors = b.connections();
    ASSERT_EQ(doors.size(), movedDoors.size());
    for (std::size_t k = 0; k < doors.size(); ++k) {
        EXPECT_EQ(doors[k].doorway.real, movedDoors[k].doorway.real);
        expectNear(move(doors[k].doorway.position.mean), movedDoors[k].doorway.position.mean);
    }
}
