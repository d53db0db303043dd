#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <cstdlib>

#include "gr2to/base/files.h"
#include "gr2to/io/GridReader.h"
#include "gr2to/io/OccupancyGrid.h"
#include "gr2to/io/XmlMap.h"
#include "gr2to/mrpt/simplemap.h"
#include "gr2to/pipeline/Gr2To.h"
#include "support/BuildingGenerator.h"
#include "support/cli.h"
#include "support/inputFiles.h"

namespace gr2to::test
{
namespace
{
using mrpt::maps::COccupancyGridMap2D;
using mrpt::maps::CSimpleMap;
using mrpt::obs::CObservation2DRangeScan;

std::string iniFor(double resolution_m)
{
    return "[MappingApplication]\noccupancyGrid_count = 1\n"
           "[MappingApplication_occupancyGrid_00_creationOpts]\n"
           "min_x = -1\nmax_x = 1\nmin_y = -1\nmax_y = 1\nresolution = " +
           std::to_string(resolution_m) +
           "\n[MappingApplication_occupancyGrid_00_insertOpts]\n"
           "maxDistanceInsertion = 100\nconsiderInvalidRangesAsFreeSpace = false\n";
}

/** The grid that MRPT's observations2map makes, by the calls that it makes. */
ClassifiedGrid rebuilt(const CSimpleMap& keyframes, double resolution_m)
{
    mrpt::maps::TSetOfMetricMapInitializers wanted;
    wanted.loadFromConfigFile(mrpt::config::CConfigFileMemory(iniFor(resolution_m)), "MappingApplication");
    mrpt::maps::CMultiMetricMap maps;
    maps.setListOfMaps(wanted);
    maps.loadFromProbabilisticPosesAndObservations(keyframes);
    return fromOccupancyGrid(*maps.mapByClass<COccupancyGridMap2D>(), {0.5, 0.5});
}

/** How a rebuilt grid agrees with the original, cell by cell. */
struct Agreement
{
    std::size_t free = 0;        //!< free in both
    std::size_t occupied = 0;    //!< occupied in both
    std::size_t wrongFree = 0;   //!< free in the rebuilt grid alone
    std::size_t wrongWall = 0;   //!< occupied in the rebuilt grid alone
    std::size_t unseenFree = 0;  //!< free in the original, unknown in the rebuilt grid

    Agreement(const ClassifiedGrid& original, const ClassifiedGrid& again)
    {
        for (std::size_t i = 0; i < again.size(); ++i) {
            const Cell cell = again.cell(i);
            const auto at = again.frame().toMap(cell);
            const auto there = original.frame().toGrid(at.x(), at.y());
            const Cell here{static_cast<int>(std::lround(there.x())),
                            static_cast<int>(std::lround(there.y()))};
            const CellState truth = original.contains(here) ? original.at(here) : CellState::Unknown;
            if (again[i] == CellState::Free) ++(truth == CellState::Free ? free : wrongFree);
            if (again[i] == CellState::Occupied) ++(truth == CellState::Occupied ? occupied : wrongWall);
            if (again[i] == CellState::Unknown && truth == CellState::Free) ++unseenFree;
        }
    }
};

CSimpleMap simplemapOf(const Extraction& extraction, const TSimplemapOptions& options = {})
{
    return toSimplemap(extraction.map, extraction.grid, options);
}

template <class T>
std::vector<std::shared_ptr<T>> observationsOf(const CSimpleMap& map, std::size_t keyframe)
{
    std::vector<std::shared_ptr<T>> found;
    for (const auto& observation : *std::get<1>(map.get(keyframe)))
        if (auto one = std::dynamic_pointer_cast<T>(observation)) found.push_back(one);
    return found;
}

ClassifiedGrid office()
{
    return readGrid(GR2TO_SOURCE_DIR "/share/sample/office.yaml", TGridReaderOptions());
}
}  // namespace

TEST(SimplemapOutput, rebuildsTwoRoomsCellByCell)
{
    const Extraction extraction = Gr2To().extract(roomsGrid());
    const Agreement found(extraction.grid, rebuilt(simplemapOf(extraction), 0.1));
    EXPECT_EQ(found.wrongFree, 0u);
    EXPECT_EQ(found.wrongWall, 0u);
    EXPECT_LT(found.unseenFree, 75u) << "of 3705 cells those behind the jambs are unseen";
    EXPECT_EQ(found.free + found.unseenFree, extraction.grid.count(CellState::Free));
    EXPECT_GT(found.occupied, 230u) << "of 246 inner wall cells and corners";
}

/** What is wrong are cells that MRPT's lines from cell to cell touch and the true rays do not. */
TEST(SimplemapOutput, rebuildsAnOfficeCellByCell)
{
    const Extraction extraction = Gr2To().extract(office());
    const Agreement found(extraction.grid, rebuilt(simplemapOf(extraction), extraction.grid.resolution_m()));
    std::cout << found.free << " free, " << found.occupied << " occupied, " << found.wrongFree
              << " wrongly free, " << found.wrongWall << " wrongly occupied, " << found.unseenFree
              << " unseen\n";
    EXPECT_LT(static_cast<double>(found.wrongWall), 0.001 * static_cast<double>(found.occupied));
    EXPECT_LT(static_cast<double>(found.wrongFree), 0.002 * static_cast<double>(found.free));
    EXPECT_GT(static_cast<double>(found.free),
              0.95 * static_cast<double>(extraction.grid.count(CellState::Free)));
}

TEST(SimplemapOutput, observations2mapRebuildsTheSame)
{
    if (std::system("command -v observations2map >/dev/null") != 0)
        GTEST_SKIP() << "observations2map is not installed (package mrpt-apps); the calls that it makes are "
                        "tested all the same";
    const TempFolder folder;
    const Extraction extraction = Gr2To().extract(roomsGrid());
    const CSimpleMap keyframes = simplemapOf(extraction);
    folder.write("rooms.simplemap", encodeSimplemap(keyframes));
    folder.write("rooms.ini", iniFor(0.1));
    const std::string command = "cd " + quoted(folder.path().string()) +
                                " && observations2map rooms.ini rooms.simplemap rooms </dev/null >log 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << readFile(folder.path() / "log");
    TGridReaderOptions reading;
    reading.occupied_threshold = reading.free_threshold = 0.5;
    const ClassifiedGrid grid = readGrid(folder.path() / "rooms_gridmap_no00.gridmap", reading);
    EXPECT_EQ(grid.cells(), rebuilt(keyframes, 0.1).cells());
}

TEST(SimplemapOutput, hasOneKeyframeOfStandardClassesForEachPlace)
{
    const Extraction extraction = Gr2To().extract(roomsGrid());
    const CSimpleMap keyframes = simplemapOf(extraction);
    ASSERT_EQ(keyframes.size(), extraction.map.places().size());
    std::size_t i = 0;
    for (const auto& [id, place] : extraction.map.places()) {
        const auto pdf = std::get<0>(keyframes.get(i));
        const auto* pose = dynamic_cast<const mrpt::poses::CPose3DPDFGaussian*>(pdf.get());
        ASSERT_NE(pose, nullptr);
        EXPECT_EQ(pose->mean.x(), place.center.x);
        EXPECT_EQ(pose->mean.y(), place.center.y);
        EXPECT_NEAR(pose->cov(0, 0), 0.1 * 0.1 / 12, 1e-12);
        EXPECT_EQ(pose->cov(5, 5), 0);
        ASSERT_EQ(observationsOf<CObservation2DRangeScan>(keyframes, i).size(), 1u);
        const auto comments = observationsOf<mrpt::obs::CObservationComment>(keyframes, i);
        ASSERT_EQ(comments.size(), 1u);
        EXPECT_EQ(comments[0]->text, toXml(place));
        EXPECT_THAT(comments[0]->text, testing::StartsWith("<place id=\"" + std::to_string(id) + "\""));
        EXPECT_EQ(mrpt::Clock::toDouble(comments[0]->timestamp), id);
        ++i;
    }
}

TEST(SimplemapOutput, unknownCellsGiveNoEcho)
{
    ClassifiedGrid grid(41, 41, GridFrame{0.1, 0, 0, 0}, CellState::Free);
    for (int i = 0; i < 41; ++i) {
        for (const Cell wall : {Cell{0, i}, Cell{i, 0}, Cell{i, 40}}) grid.set(wall, CellState::Occupied);
        grid.set({40, i}, CellState::Unknown);
    }
    TopologicalMap map;
    Place place;
    place.id = 1;
    place.center = {2.05, 2.05, 0};
    map.addPlace(place);
    const auto keyframes = toSimplemap(map, grid);
    const auto scan = observationsOf<CObservation2DRangeScan>(keyframes, 0).at(0);
    const std::size_t ahead = scan->getScanSize() / 2;
    EXPECT_FALSE(scan->getScanRangeValidity(ahead)) << "to the unknown cells at the right";
    EXPECT_NEAR(scan->getScanRange(ahead), 1.95, 1e-5) << "up to the border of the first unknown cell";
    EXPECT_TRUE(scan->getScanRangeValidity(0)) << "to the wall at the left";
    EXPECT_NEAR(scan->getScanRange(0), 2.0, 1e-5) << "to the middle of the wall's cell";
    const Agreement found(grid, rebuilt(keyframes, 0.1));
    EXPECT_EQ(found.wrongFree + found.wrongWall, 0u);
}

TEST(SimplemapOutput, raysFollowAGridThatIsTurned)
{
    ClassifiedGrid grid = roomsGrid();
    const Extraction plain = Gr2To().extract(grid);
    ClassifiedGrid turned(grid.width(), grid.height(), GridFrame{0.1, -1, 2, M_PI / 2}, CellState::Free);
    for (std::size_t i = 0; i < grid.size(); ++i) turned[i] = grid[i];
    const Extraction other = Gr2To().extract(turned);
    const auto a = observationsOf<CObservation2DRangeScan>(simplemapOf(plain), 0).at(0);
    const auto b = observationsOf<CObservation2DRangeScan>(simplemapOf(other), 0).at(0);
    ASSERT_EQ(a->getScanSize(), b->getScanSize());
    const std::size_t half = a->getScanSize() / 2;
    const double quarter = static_cast<double>(a->getScanSize()) / 4;
    EXPECT_NEAR(a->getScanRange(half), b->getScanRange(half + static_cast<std::size_t>(quarter)), 0.02);
}

TEST(SimplemapOutput, viewsAreImagesThatStayOutside)
{
    Extraction extraction = Gr2To().extract(roomsGrid());
    View view;
    view.image = "views/1_0.png";
    view.position.mean = {extraction.map.place(1).center.x + 1, extraction.map.place(1).center.y, 1.2};
    view.time_s = 1.7e9;
    extraction.map.place(1).views.push_back(view);
    const auto images = observationsOf<mrpt::obs::CObservationImage>(simplemapOf(extraction), 0);
    ASSERT_EQ(images.size(), 1u);
    EXPECT_EQ(images[0]->image.getExternalStorageFile(), "views/1_0.png");
    EXPECT_EQ(mrpt::Clock::toDouble(images[0]->timestamp), 1.7e9);
    EXPECT_NEAR(images[0]->cameraPose.x(), 1, 1e-9);
    EXPECT_NEAR(images[0]->cameraPose.z(), 1.2, 1e-9);
}

TEST(SimplemapOutput, sameBytesAndReadByMrpt)
{
    const TempFolder folder;
    const Extraction extraction = Gr2To().extract(roomsGrid());
    const std::string bytes = encodeSimplemap(simplemapOf(extraction));
    EXPECT_EQ(bytes, encodeSimplemap(simplemapOf(extraction)));
    CSimpleMap again;
    EXPECT_TRUE(again.loadFromFile(folder.write("a.simplemap", bytes).string()));
    EXPECT_EQ(again.size(), extraction.map.places().size());
}

TEST(SimplemapOutput, optionsAreChecked)
{
    TSimplemapOptions options;
    options.rays_per_cell = 0;
    EXPECT_THROW(toSimplemap(TopologicalMap(), roomsGrid(), options), std::invalid_argument);
}
}  // namespace gr2to::test
