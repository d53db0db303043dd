#include <gmock/gmock.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <filesystem>

#include "../libs/gr2to/src/mrpt/gz.h"
#include "gr2to/base/files.h"
#include "gr2to/io/XmlMap.h"
#include "support/cli.h"
#include "support/rawlogs.h"

using namespace gr2to;
using namespace gr2to::test;
using testing::HasSubstr;
using testing::Not;

namespace
{
namespace fs = std::filesystem;
constexpr int STEPS = 20;  // through the door, into the other room

class CliRawlog : public testing::Test
{
 protected:
    void SetUp() override
    {
#ifndef GR2TO_RAWLOG
        GTEST_SKIP()
            << "gr2to-rawlog is not built: MRPT's SLAM library (package libmrpt-slam-dev) is missing";
#endif
    }
    CliRun rawlog(const std::vector<std::string>& arguments) const
    {
#ifdef GR2TO_RAWLOG
        return runProgram(GR2TO_RAWLOG, m_folder.path(), arguments);
#else
        return runProgram("false", m_folder.path(), arguments);
#endif
    }
    CliRun gr2to(const std::vector<std::string>& arguments) const
    {
        return runCli(m_folder.path(), arguments);
    }
    /** Expects exit code 2, one line with the words, and no new file. */
    void expectRefused(const std::string& bytes, const std::vector<std::string>& words) const
    {
        m_folder.write("bad.rawlog", bytes);
        const auto before = contentOf(m_folder.path());
        const CliRun own = rawlog({"bad.rawlog", "-o", "bad.simplemap"});
        EXPECT_EQ(own.code, 2) << own.err;
        EXPECT_EQ(own.out, "");
        EXPECT_THAT(own.err, testing::StartsWith("gr2to-rawlog: error: "));
        for (const auto& word : words) EXPECT_THAT(own.err, HasSubstr(word));
        expectBadUsage(gr2to({"extract", "bad.rawlog", "-o", "out"}), words);
        EXPECT_EQ(contentOf(m_folder.path()), before);
    }
    /** Places and doors of a map that was extracted into a folder. */
    void expectTwoRooms(const std::string& folder) const
    {
        const TopologicalMap map = readXml(m_folder.path() / folder / "topomap.xml");
        EXPECT_EQ(map.places().size(), 2u);
        ASSERT_EQ(map.connections().size(), 1u);
        EXPECT_NEAR(map.connections()[0].doorway.size.length_m, 0.85, 0.15);
        EXPECT_NEAR(map.connections()[0].doorway.position.mean.x, 2.0, 0.15) << "from the robot's start";
    }
    TempFolder m_folder;
};
}  // namespace

TEST_F(CliRawlog, extractMapsARawlogWithOneCommand)
{
    m_folder.write("walk.rawlog", compressGz(walkThroughRooms(STEPS)));
    const CliRun run = gr2to({"extract", "walk.rawlog"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, HasSubstr("MRPT rawlog, mapped by ICP"));
    EXPECT_EQ(readXml(m_folder.path() / "walk/topomap.xml").source, "walk.rawlog");
    expectTwoRooms("walk");
}

TEST_F(CliRawlog, simplemapGoesTheSameWayAndIsTheSameEachTime)
{
    m_folder.write("walk.rawlog", walkThroughRooms(STEPS));
    const CliRun run = rawlog({"walk.rawlog"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, HasSubstr("walk.simplemap: "));
    EXPECT_THAT(run.out, HasSubstr("of 20 scans in 40 entries; not used: none"));
    ASSERT_EQ(gr2to({"extract", "walk.simplemap", "-o", "out"}).code, 0);
    expectTwoRooms("out");
    const std::string first = readFile(m_folder.path() / "walk.simplemap");
    ASSERT_EQ(rawlog({"walk.rawlog", "-q"}).out, "");
    EXPECT_EQ(readFile(m_folder.path() / "walk.simplemap"), first);
}

TEST_F(CliRawlog, missingTimestampsAreFilledIn)
{
    m_folder.write("walk.rawlog", walkThroughRooms(STEPS, false));
    const CliRun run = gr2to({"extract", "walk.rawlog", "-o", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    expectTwoRooms("out");
}

TEST_F(CliRawlog, configurationIsReadAndReachesTheMapping)
{
    m_folder.write("walk.rawlog", walkThroughRooms(STEPS));
    m_folder.write("far.ini",
                   "[MappingApplication]\ninsertionLinDistance = 100\ninsertionAngDistance = 360\n");
    EXPECT_THAT(rawlog({"walk.rawlog", "-c", "far.ini"}).out, HasSubstr(" 1 keyframes"));
    EXPECT_THAT(rawlog({"walk.rawlog", "-c", GR2TO_SOURCE_DIR "/share/rawlog.ini", "-o", "a.simplemap"}).out,
                Not(HasSubstr(" 1 keyframes")));
    ASSERT_EQ(rawlog({"walk.rawlog", "-o", "b.simplemap"}).code, 0);
    EXPECT_EQ(readFile(m_folder.path() / "a.simplemap"), readFile(m_folder.path() / "b.simplemap"))
        << "share/rawlog.ini has the defaults";
    ASSERT_EQ(gr2to({"extract", "walk.rawlog", "--rawlog-config", "far.ini", "-o", "out"}).code, 0);
    expectBadUsage(gr2to({"extract", "walk.rawlog", "--rawlog-config", "absent.ini"}), {"absent.ini"});
    writeRooms(m_folder);
    expectBadUsage(gr2to({"extract", "rooms.yaml", "--rawlog-config", "far.ini"}), {"is no rawlog"});
}

TEST_F(CliRawlog, rawlogThatEndsWithinAnEntryIsUsedWithAWarning)
{
    const std::string bytes = walkThroughRooms(STEPS);
    m_folder.write("cut.rawlog", bytes.substr(0, bytes.size() - 1000));
    const CliRun run = gr2to({"extract", "cut.rawlog", "-o", "out"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.err,
                testing::StartsWith("gr2to: warning: 'cut.rawlog' ends within entry 40; the 39 entries"));
    expectTwoRooms("out");
}

TEST_F(CliRawlog, rawlogWithoutScansIsRefusedWithWhatItHolds)
{
    const mrpt::obs::CObservationOdometry odometry;
    mrpt::obs::CObservationComment comment;
    comment.text = "hello";
    expectRefused(archiveOf({&odometry, &comment, &comment}),
                  {"'bad.rawlog'", "3 entries", "2 mrpt::obs::CObservationComment", "laser scans"});
}

TEST_F(CliRawlog, foreignClassIsRefusedByName)
{
    std::string bytes = walkThroughRooms(3);
    const std::string known = "mrpt::obs::CObservation2DRangeScan";
    bytes.replace(bytes.rfind(known), known.size(), "acme::obs::CObservationThermometer");
    expectRefused(bytes, {"'bad.rawlog'", "acme::obs::CObservationThermometer", "libacme.so"});
}

TEST_F(CliRawlog, otherBadInputIsRefused)
{
    expectRefused(walkThroughRooms(1).substr(0, 100),
                  {"'bad.rawlog' ends within entry 1", "no observation that can be mapped"});
    EXPECT_EQ(rawlog({"absent.rawlog"}).code, 2);
    EXPECT_EQ(rawlog({}).code, 2);
    m_folder.write("text.rawlog", "hello");
    const CliRun text = rawlog({"text.rawlog"});
    EXPECT_EQ(text.code, 2);
    EXPECT_THAT(text.err, HasSubstr("is no rawlog"));
    m_folder.write("walk.rawlog", walkThroughRooms(2));
    EXPECT_THAT(rawlog({"walk.rawlog", "-o", "walk.rawlog"}).err, HasSubstr("would replace the input"));
    EXPECT_THAT(rawlog({"walk.rawlog", "--plugins", "/nowhere/libacme.so"}).err, HasSubstr("libacme.so"));
}

TEST_F(CliRawlog, rawlogsOfMrptCommonAreExtracted)
{
    const fs::path datasets = "/usr/share/mrpt/datasets";
    if (!fs::exists(datasets / "localization_demo.rawlog")) GTEST_SKIP() << "mrpt-common is not installed";
    for (const char* name : {"localization_demo", "uwb_ro-localization_demo", "tests_rgbd",
                             "2006-01ENE-21-SENA_Telecom Faculty_one_loop_only"})
    {
        const CliRun run = gr2to({"extract", (datasets / name).string() + ".rawlog", "-o", name});
        EXPECT_EQ(run.code, 0) << run.err;
        EXPECT_FALSE(readXml(m_folder.path() / name / "topomap.xml").places().empty()) << name;
    }
    for (const char* name : {"RO-SLAM_demo", "kf-slam_demo", "test_rtk_path"})
        expectBadUsage(gr2to({"extract", (datasets / name).string() + ".rawlog", "-o", name}),
                       {name, "laser scans"});
}
