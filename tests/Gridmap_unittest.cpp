#include <gmock/gmock.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <cstring>
#include <random>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/io/GridReader.h"
#include "gr2to/io/OccupancyGrid.h"
#include "support/inputFiles.h"

using namespace gr2to;
using namespace gr2to::test;
using mrpt::maps::COccupancyGridMap2D;
using testing::AllOf;
using testing::HasSubstr;

namespace
{
/** 4 x 3 cells of 0.05 m; the bottom row from known occupied to known free. */
COccupancyGridMap2D sampleMap()
{
    COccupancyGridMap2D map(-1.0f, -0.8f, 2.0f, 2.15f, 0.05f);
    map.fill(0.5f);
    const float free[] = {0.02f, 0.3f, 0.7f, 0.98f};
    for (int x = 0; x < 4; ++x) map.setCell(x, 0, free[x]);
    return map;
}

template <class Object>
std::string archiveOf(const Object& object)
{
    mrpt::io::CMemoryStream stream;
    mrpt::serialization::archiveFrom(stream) << object;
    return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}

template <class Object>
std::string gzipArchiveOf(const TempFolder& folder, const Object& object)
{
    const auto file = folder.path() / "packed";
    {
        mrpt::io::CFileGZOutputStream stream(file.string());
        mrpt::serialization::archiveFrom(stream) << object;
    }
    return readFile(file);
}

/** Overwrites one of the fields in front of the cells: width, height, x_min, x_max, y_min, y_max, resolution.
 */
std::string withField(std::string archive, std::size_t field, const void* value)
{
    const std::size_t nameLength = static_cast<unsigned char>(archive[0]) & 0x7fU;
    const std::size_t fields = 1 + nameLength + 1 /*version*/ + 1 /*bits of a cell*/;
    std::memcpy(archive.data() + fields + 4 * field, value, 4);
    return archive;
}
}  // namespace

TEST(Gridmap, archivesAreReadCompressedAndNotUnderAnyName)
{
    const TempFolder folder;
    for (const auto& archive : {archiveOf(sampleMap()), gzipArchiveOf(folder, sampleMap())})
        for (const char* name : {"a.gridmap", "a.gridmap.gz", "a.dat"}) {
            GridSource source;
            const auto grid = readGrid(folder.write(name, archive), TGridReaderOptions(), &source);
            EXPECT_EQ(drawingOf(grid), "????\n????\n##..\n");
            EXPECT_EQ(grid.resolution_m(), 0.05);
            EXPECT_EQ(grid.frame().origin_x_m, -1.0);
            EXPECT_EQ(grid.frame().origin_y_m, 2.0);
            EXPECT_EQ(source.format, "MRPT grid map");
        }
}

TEST(Gridmap, logOddsBecomeProbabilitiesByTheLogisticFunction)
{
    COccupancyGridMap2D map(0.0f, 25.6f, 0.0f, 0.1f, 0.1f);
    ASSERT_EQ(map.getSizeX(), 256u);
    for (int x = 0; x < 256; ++x) map.getRow(0)[x] = static_cast<COccupancyGridMap2D::cellType>(x - 128);
    const OccupancyThresholds thresholds{0.7, 0.2};
    const auto grid = fromOccupancyGrid(map, thresholds);
    for (int x = 0; x < 256; ++x) {
        const double logOdds = (x - 128) / 16.0, occupancy = 1.0 / (1.0 + std::exp(logOdds));
        auto expected = CellState::Unknown;
        if (occupancy > thresholds.occupied) expected = CellState::Occupied;
        if (occupancy < thresholds.free) expected = CellState::Free;
        EXPECT_EQ(grid.at({x, 0}), expected) << x - 128;
    }
}

TEST(Gridmap, untouchedCellsAreUnknownWhateverTheThresholds)
{
    COccupancyGridMap2D map(0.0f, 0.2f, 0.0f, 0.1f, 0.1f);
    map.getRow(0)[0] = 0;
    map.getRow(0)[1] = 1;
    EXPECT_EQ(drawingOf(fromOccupancyGrid(map, {0.6, 0.6})), "?.\n");
    EXPECT_EQ(drawingOf(fromOccupancyGrid(map, {0.4, 0.4})), "?#\n");
}

TEST(Gridmap, thresholdsAreOptionsAndWhatCannotApplyIsRefused)
{
    const TempFolder folder;
    const auto file = folder.write("a.gridmap", archiveOf(sampleMap()));
    TGridReaderOptions options;
    options.occupied_threshold = 0.9;
    options.free_threshold = 0.1;
    EXPECT_EQ(drawingOf(readGrid(file, options)), "????\n????\n#??.\n");
    options.resolution = 0.05;
    EXPECT_NO_THROW(readGrid(file, options));
    options.resolution = 0.1;
    EXPECT_THAT(readErrorOf(file, options), AllOf(HasSubstr("0.05 m"), HasSubstr("input.resolution")));
    options = {};
    options.negate = "yes";
    EXPECT_THAT(readErrorOf(file, options), HasSubstr("input.negate"));
    options = {};
    options.mode = "scale";
    EXPECT_THAT(readErrorOf(file, options), HasSubstr("input.mode"));
}

TEST(Gridmap, everyTruncatedArchiveIsRefused)
{
    const TempFolder folder;
    for (const auto& whole : {archiveOf(sampleMap()), gzipArchiveOf(folder, sampleMap())})
        for (std::size_t length = 3; length < whole.size(); ++length) {
            SCOPED_TRACE(length);
            EXPECT_NE(readErrorOf(folder.write("cut.gridmap", whole.substr(0, length)), {}), "");
        }
}

TEST(Gridmap, headersThatLieAreRefusedBeforeAllocation)
{
    const TempFolder folder;
    const auto archive = archiveOf(sampleMap());
    const auto reason = [&](const std::string& bytes) {
        return readErrorOf(folder.write("bad.gridmap", bytes), {});
    };
    const std::uint32_t tooMany = 65536, many = 30000, zero = 0;
    const float nan = std::nanf(""), huge = 1e30f;
    EXPECT_THAT(reason(withField(withField(archive, 0, &tooMany), 1, &tooMany)), HasSubstr("65536 x 65536"));
    EXPECT_THAT(reason(withField(archive, 0, &many)), HasSubstr("contradict"));
    EXPECT_THAT(reason(withField(archive, 1, &zero)), HasSubstr("positive"));
    for (std::size_t field = 2; field < 7; ++field) {
        EXPECT_THAT(reason(withField(archive, field, &nan)), HasSubstr("contradict")) << field;
        EXPECT_THAT(reason(withField(archive, field, &huge)), HasSubstr("contradict")) << field;
        EXPECT_THAT(reason(withField(archive, field, &zero)), HasSubstr("contradict")) << field;
    }
    const float side = 0.05f * 20000;
    auto large = withField(withField(archive, 3, &side), 5, &side);
    const std::uint32_t cells = 20000;
    large = withField(withField(withField(withField(large, 0, &cells), 1, &cells), 2, &zero), 4, &zero);
    EXPECT_THAT(reason(large), HasSubstr("truncated"));
}

TEST(Gridmap, damagedArchivesAreReadOrRefusedButNeverMore)
{
    const TempFolder folder;
    const auto whole = archiveOf(sampleMap());
    std::mt19937 random(11);
    int refused = 0;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ static_cast<char>(1U << (random() % 8U)));
        const auto file = folder.write("damaged.gridmap", damaged);
        try {
            EXPECT_EQ(readGrid(file, {}).size(), 12u) << at;
        } catch (const InputError& e) {
            ++refused;
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
            EXPECT_THAT(e.what(), HasSubstr(file.string()));
        }
    }
    EXPECT_GT(refused, 20);
}

TEST(Gridmap, otherArchivesAreNamedAndRefused)
{
    const TempFolder folder;
    const mrpt::obs::CSensoryFrame frame;
    for (const auto& archive : {archiveOf(frame), gzipArchiveOf(folder, frame)})
        EXPECT_THAT(readErrorOf(folder.write("a.gridmap", archive), {}),
                    AllOf(HasSubstr("a rawlog"), HasSubstr("gr2to-rawlog")));
    const auto pose = archiveOf(mrpt::poses::CPose3D());
    EXPECT_THAT(readErrorOf(folder.write("b.gridmap", pose), {}), HasSubstr("CPose3D"));
    EXPECT_THAT(readErrorOf(folder.write("c.gridmap", "\x1f\x8b no gzip"), {}), HasSubstr("gzip"));
}

namespace
{
void expectRealMap(const std::string& name, int width, int height, double resolution_m, double minX_m)
{
    const std::filesystem::path file = "/usr/share/mrpt/datasets/" + name;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "the package mrpt-common is absent: " << file;
    const auto grid = readGrid(file, TGridReaderOptions());
    EXPECT_EQ(grid.width(), width);
    EXPECT_EQ(grid.height(), height);
    EXPECT_EQ(grid.resolution_m(), resolution_m);
    EXPECT_EQ(grid.frame().origin_x_m, minX_m);
    for (const auto state : {CellState::Free, CellState::Occupied, CellState::Unknown})
        EXPECT_GT(grid.count(state), grid.size() / 500);
    EXPECT_GT(grid.count(CellState::Free), grid.size() / 6);
}
}  // namespace

TEST(Gridmap, theRoomOfMrptIsRead)
{
    expectRealMap("uwb_ro-localization_demo_map.gridmap.gz", 700, 650, 0.04, -10.0);
}

TEST(Gridmap, theCampusOfMrptIsRead)
{
    expectRealMap("2006-MalagaCampus.gridmap.gz", 1888, 2738, 0.08, -10.0);
}

TEST(Gridmap, rawlogsOfMrptAreNoMaps)
{
    const std::filesystem::path folder = "/usr/share/mrpt/datasets";
    if (!std::filesystem::exists(folder / "localization_demo.rawlog"))
        GTEST_SKIP() << "mrpt-common is absent";
    EXPECT_THAT(readErrorOf(folder / "localization_demo.rawlog"), HasSubstr("rawlog"));
}
