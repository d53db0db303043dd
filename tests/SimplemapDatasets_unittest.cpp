#include <gmock/gmock.h>

#include <filesystem>

#include "../libs/gr2to/src/mrpt/gz.h"
#include "gr2to/base/files.h"
#include "support/cli.h"
#include "support/inputFiles.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
const std::filesystem::path DATASETS = "/usr/share/mrpt/datasets";

/** The simplemaps that MRPT's own package holds. */
class SimplemapDatasets : public testing::Test
{
 protected:
    void SetUp() override
    {
        if (!std::filesystem::exists(DATASETS / "localization_demo.simplemap.gz"))
            GTEST_SKIP() << "mrpt-common is not installed: its simplemaps are not tested";
    }
    TempFolder m_folder;
};
}  // namespace

TEST_F(SimplemapDatasets, areExtracted)
{
    for (const char* name : {"localization_demo", "malaga-cs-fac-building"}) {
        const CliRun run = runCli(m_folder.path(), {"extract", (DATASETS / name).string() + ".simplemap.gz"});
        EXPECT_EQ(run.code, 0) << run.err;
        EXPECT_TRUE(std::filesystem::exists(m_folder.path() / name / "topomap.simplemap"));
        EXPECT_THAT(run.out, testing::Not(testing::HasSubstr("\n0 rooms")));
    }
}

TEST_F(SimplemapDatasets, foreignClassOfAnOldFrameIsNamed)
{
    std::string bytes = decompressGz(readFile(DATASETS / "localization_demo.simplemap.gz"),
                                     "localization_demo", std::size_t{1} << 24);
    const std::string known = "CObservation2DRangeScan", foreign = "CObservation2DRangeTape";
    ASSERT_NE(bytes.find(known), std::string::npos);
    bytes.replace(bytes.find(known), known.size(), foreign);
    m_folder.write("old.simplemap", bytes);
    const CliRun run = runCli(m_folder.path(), {"extract", "old.simplemap", "-o", "out"});
    expectBadUsage(run, {"'old.simplemap'", "'" + foreign + "'", "not registered", "--scans-plugins"});
    EXPECT_FALSE(std::filesystem::exists(m_folder.path() / "out"));
}
