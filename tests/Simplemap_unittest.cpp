#include <gmock/gmock.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include "../libs/gr2to/src/mrpt/gz.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/io/GridReader.h"
#include "gr2to/io/OccupancyGrid.h"
#include "gr2to/mrpt/simplemap.h"
#include "gr2to/pipeline/Gr2To.h"
#include "support/cli.h"
#include "support/inputFiles.h"
#include "support/rawlogs.h"

using namespace gr2to;
using namespace gr2to::test;
using mrpt::maps::CSimpleMap;
using testing::AllOf;
using testing::HasSubstr;

namespace
{
using mrpt::obs::CSensoryFrame;

std::string archiveOf(const CSimpleMap& map)
{
    return test::archiveOf({&map});
}

mrpt::obs::CObservation2DRangeScan::Ptr scanAround(double pitch_rad = 0)
{
    constexpr std::size_t RAYS = 720;
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    scan->aperture = static_cast<float>(2 * M_PI);
    scan->maxRange = 10;
    scan->sensorPose = mrpt::poses::CPose3D(0, 0, 0, 0, pitch_rad, 0);
    scan->resizeScan(RAYS);
    for (std::size_t i = 0; i < RAYS; ++i) {
        scan->setScanRange(i, 2.0f);
        scan->setScanRangeValidity(i, true);
    }
    return scan;
}

/** Keyframes at x = 0, 1, 2 ... with one observation each. */
CSimpleMap keyframesWith(const std::vector<mrpt::obs::CObservation::Ptr>& observations)
{
    CSimpleMap map;
    double x = 0;
    for (const auto& observation : observations) {
        auto frame = CSensoryFrame::Create();
        if (observation) frame->insert(observation);
        auto pose = mrpt::poses::CPose3DPDFGaussian::Create();
        pose->mean = mrpt::poses::CPose3D(x++, 0, 0, 0, 0, 0);
        map.insert(pose, frame);
    }
    return map;
}

mrpt::obs::CObservationComment::Ptr comment()
{
    auto comment = mrpt::obs::CObservationComment::Create();
    comment->text = "hello";
    return comment;
}

TGridReaderOptions atResolution(double resolution_m)
{
    TGridReaderOptions options;
    options.resolution = resolution_m;
    return options;
}

class Simplemap : public testing::Test
{
 protected:
    ClassifiedGrid read(const std::string& bytes, const TGridReaderOptions& options = {})
    {
        return readGrid(m_folder.write("a.simplemap", bytes), options, &m_source);
    }
    std::string errorOf(const std::string& bytes, const TGridReaderOptions& options = {})
    {
        return readErrorOf(m_folder.write("a.simplemap", bytes), options);
    }
    TempFolder m_folder;
    GridSource m_source;
};

std::string replaced(std::string bytes, const std::string& what, const std::string& by)
{
    EXPECT_EQ(what.size(), by.size());
    const auto at = bytes.find(what);
    EXPECT_NE(at, std::string::npos);
    return bytes.replace(at, what.size(), by);
}

/** MRPT chooses another margin of unknown cells for a map that is loaded at once. */
void expectSameKnownCells(const ClassifiedGrid& a, const ClassifiedGrid& b)
{
    EXPECT_EQ(a.count(CellState::Free), b.count(CellState::Free));
    EXPECT_EQ(a.count(CellState::Occupied), b.count(CellState::Occupied));
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] == CellState::Unknown) continue;
        const auto at = a.frame().toMap(a.cell(i));
        const auto there = b.frame().toGrid(at.x(), at.y());
        const Cell cell{static_cast<int>(std::lround(there.x())), static_cast<int>(std::lround(there.y()))};
        ASSERT_TRUE(b.contains(cell));
        ASSERT_EQ(b.at(cell), a[i]) << at.x() << ", " << at.y();
    }
}
}  // namespace

TEST_F(Simplemap, isTheGridThatMrptBuilds)
{
    const CSimpleMap map = keyframesWith({scanAround(), scanAround(), comment()});
    const ClassifiedGrid grid = read(archiveOf(map), atResolution(0.1));
    mrpt::maps::COccupancyGridMap2D expected(-1, 1, -1, 1, 0.1f);
    expected.loadFromSimpleMap(map);
    expectSameKnownCells(grid, fromOccupancyGrid(expected, {0.65, 0.4}));
    EXPECT_EQ(m_source.format, "MRPT simplemap");
    EXPECT_EQ(m_source.free_threshold, 0.4);
    ASSERT_TRUE(m_source.scans);
    EXPECT_EQ(m_source.scans->keyframes, 3u);
    EXPECT_EQ(m_source.scans->observations, 3u);
    EXPECT_EQ(m_source.scans->inserted, 2u);
    EXPECT_EQ(grid.at({static_cast<int>(grid.frame().toGrid(0, 0).x() + 0.5),
                       static_cast<int>(grid.frame().toGrid(0, 0).y() + 0.5)}),
              CellState::Free)
        << "where the robot stood";
}

TEST_F(Simplemap, isToldByContentCompressedOrNot)
{
    const std::string bytes = archiveOf(keyframesWith({scanAround()}));
    const ClassifiedGrid grid = read(bytes);
    EXPECT_EQ(grid.resolution_m(), 0.05);
    for (const char* name : {"a.simplemap.gz", "a.gridmap", "a.dat"})
        EXPECT_EQ(readGrid(m_folder.write(name, compressGz(bytes)), {}), grid) << name;
}

TEST_F(Simplemap, optionsReachTheInsertion)
{
    const std::string bytes = archiveOf(keyframesWith({scanAround()}));
    TGridReaderOptions options;
    options.scans.max_range = 1;
    const ClassifiedGrid near = read(bytes, options);
    EXPECT_EQ(near.count(CellState::Occupied), 0u) << "the walls are 2 m away";
    EXPECT_LT(near.count(CellState::Free), read(bytes).count(CellState::Free) / 2);
    const std::string tilted = archiveOf(keyframesWith({scanAround(0.1)}));
    EXPECT_THAT(errorOf(tilted),
                AllOf(HasSubstr("1 mrpt::obs::CObservation2DRangeScan"), HasSubstr("max_tilt")));
    options = {};
    options.scans.max_tilt = 10;
    EXPECT_GT(read(tilted, options).count(CellState::Occupied), 0u);
}

TEST_F(Simplemap, ofRangeImagesIsBuiltOfTheirScans)
{
    auto image = mrpt::obs::CObservation3DRangeScan::Create();
    image->hasRangeImage = true;
    image->rangeUnits = 0.001f;
    image->rangeImage.setConstant(120, 160, 2000);
    image->range_is_depth = true;
    image->maxRange = 5;
    image->cameraParams.ncols = 160;
    image->cameraParams.nrows = 120;
    image->cameraParams.setIntrinsicParamsFromValues(130, 130, 80, 60);
    const ClassifiedGrid grid = read(archiveOf(keyframesWith({image})));
    EXPECT_EQ(m_source.scans->inserted, 1u);
    const auto ahead = grid.frame().toGrid(2.0, 0);
    int walls = 0;
    for (int x = -1; x <= 1; ++x)
        walls += grid.isOccupied({static_cast<int>(ahead.x() + 0.5) + x, static_cast<int>(ahead.y() + 0.5)});
    EXPECT_GE(walls, 1) << "a plane 2 m ahead";
}

TEST_F(Simplemap, withoutScansIsRefusedWithWhatItHolds)
{
    EXPECT_THAT(errorOf(archiveOf(CSimpleMap())), HasSubstr("without a keyframe"));
    EXPECT_THAT(errorOf(archiveOf(keyframesWith({comment(), comment(), nullptr}))),
                AllOf(HasSubstr("3 keyframes"), HasSubstr("2 mrpt::obs::CObservationComment"),
                      HasSubstr("laser scans")));
    EXPECT_THAT(errorOf(archiveOf(keyframesWith({nullptr}))), HasSubstr("observations: none"));
}

TEST_F(Simplemap, everyPrefixIsRefused)
{
    const std::string bytes = archiveOf(keyframesWith({comment(), scanAround(), comment()}));
    for (std::size_t size = 1; size < bytes.size(); size += size < 200 || size + 200 > bytes.size() ? 1 : 97)
        EXPECT_FALSE(errorOf(bytes.substr(0, size)).empty()) << "prefix of " << size << " bytes";
    EXPECT_THAT(errorOf(bytes.substr(0, bytes.size() / 2)), HasSubstr("truncated"));
    const std::string packed = compressGz(bytes);
    for (const std::size_t cut : {packed.size() - 1, packed.size() / 2, packed.size() / 3})
        EXPECT_THAT(errorOf(packed.substr(0, cut)), HasSubstr("truncated")) << cut;
    EXPECT_THAT(errorOf(bytes + "tail"), HasSubstr("more data follow"));
}

TEST_F(Simplemap, foreignClassIsNamedWithTheLibraryThatMayHoldIt)
{
    const std::string bytes = archiveOf(keyframesWith({scanAround(), comment()}));
    EXPECT_THAT(errorOf(replaced(bytes, "mrpt::obs::CObservationComment", "acme::obs::CObservationThermos")),
                AllOf(HasSubstr("'acme::obs::CObservationThermos'"), HasSubstr("not registered"),
                      HasSubstr("libacme.so"), HasSubstr("--scans-plugins")));
    EXPECT_THAT(
        errorOf(replaced(bytes, "mrpt::poses::CPose3DPDFGaussian", "mrpt::poses::CPose3DPDFNewestXY")),
        AllOf(HasSubstr("'mrpt::poses::CPose3DPDFNewestXY'"), HasSubstr("newer MRPT")));
}

TEST_F(Simplemap, pluginsThatCannotBeLoadedAreNamed)
{
    TGridReaderOptions options;
    options.scans.plugins = "/nowhere/libacme.so";
    const auto file = m_folder.write("a.simplemap", archiveOf(keyframesWith({scanAround()})));
    EXPECT_THAT(inputErrorOf([&] { readGrid(file, options); }),
                AllOf(HasSubstr("scans.plugins"), HasSubstr("/nowhere/libacme.so")));
}

TEST_F(Simplemap, ofANewerMrptIsRefused)
{
    std::string bytes = archiveOf(keyframesWith({scanAround()}));
    const std::string name = "mrpt::maps::CSimpleMap";
    bytes[bytes.find(name) + name.size()] = 2;
    EXPECT_THAT(errorOf(bytes), AllOf(HasSubstr("version 2"), HasSubstr("newer MRPT")));
}

TEST_F(Simplemap, farAwayKeyframesDoNotTakeAllMemory)
{
    for (const double x : {1e5, 1e30, std::nan("")}) {
        CSimpleMap map = keyframesWith({scanAround(), scanAround()});
        auto pose = mrpt::poses::CPose3DPDFGaussian::Create();
        pose->mean = mrpt::poses::CPose3D(x, 0, 0, 0, 0, 0);
        map.set(1, mrpt::poses::CPose3DPDF::Ptr(pose), CSensoryFrame::Ptr());
        EXPECT_THAT(errorOf(archiveOf(map)), AllOf(HasSubstr("keyframe 1"), HasSubstr("--resolution"))) << x;
    }
}

TEST_F(Simplemap, optionsForImagesDoNotApply)
{
    TGridReaderOptions options;
    options.negate = "yes";
    EXPECT_THAT(errorOf(archiveOf(keyframesWith({scanAround()})), options), HasSubstr("input.negate"));
    options = {};
    options.scans.certainty = 0.2;
    EXPECT_THROW(read(archiveOf(keyframesWith({scanAround()})), options), std::invalid_argument);
}

TEST_F(Simplemap, ofAnExtractionGivesItsPlacesAgain)
{
    const Extraction first = Gr2To().extract(roomsGrid());
    const std::string bytes = encodeSimplemap(toSimplemap(first.map, first.grid));
    const Extraction second = Gr2To().extract(read(bytes, atResolution(0.1)));
    ASSERT_EQ(second.map.places().size(), first.map.places().size());
    ASSERT_EQ(second.map.connections().size(), first.map.connections().size());
    for (const auto& [id, place] : first.map.places())
        EXPECT_NEAR(second.map.place(id).area_m2, place.area_m2, 0.05 * place.area_m2);
}

TEST_F(Simplemap, infoTellsKeyframesAndObservations)
{
    m_folder.write("a.simplemap", archiveOf(keyframesWith({scanAround(), comment()})));
    EXPECT_THAT(runCli(m_folder.path(), {"info", "a.simplemap"}).out,
                AllOf(HasSubstr("MRPT simplemap"), HasSubstr("2, 1 of 2 observations inserted")));
    EXPECT_THAT(runCli(m_folder.path(), {"info", "a.simplemap", "--json"}).out, HasSubstr("\"inserted\": 1"));
}

TEST_F(Simplemap, extractRefusesBadOnesInOneLineAndWritesNothing)
{
    const std::string bytes = archiveOf(keyframesWith({scanAround(), comment()}));
    m_folder.write("cut.simplemap", bytes.substr(0, bytes.size() / 2));
    m_folder.write("noscan.simplemap", archiveOf(keyframesWith({comment()})));
    m_folder.write("foreign.simplemap",
                   replaced(bytes, "mrpt::obs::CObservationComment", "acme::obs::CObservationThermos"));
    const auto before = contentOf(m_folder.path());
    const auto refused = [&](const std::string& name, const std::vector<std::string>& words) {
        expectBadUsage(runCli(m_folder.path(), {"extract", name, "-o", "out"}), words);
    };
    refused("cut.simplemap", {"'cut.simplemap'", "truncated"});
    refused("noscan.simplemap", {"'noscan.simplemap'", "laser scans"});
    refused("foreign.simplemap", {"'foreign.simplemap'", "acme::obs::CObservationThermos", "libacme.so"});
    EXPECT_EQ(contentOf(m_folder.path()), before);
}
