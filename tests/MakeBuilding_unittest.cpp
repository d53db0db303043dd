#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "gr2to/base/files.h"
#include "gr2to/io/GridReader.h"
#include "support/buildingMeasures.h"

using namespace gr2to::test;

namespace
{
namespace fs = std::filesystem;

/** A folder of its own for every test, removed at the end. */
class MakeBuilding : public testing::Test
{
 protected:
    MakeBuilding()
        : m_folder(fs::temp_directory_path() /
                   ("gr2to-make-building-" + std::to_string(::getpid()) + "-" +
                    testing::UnitTest::GetInstance()->current_test_info()->name()))
    {
        fs::create_directories(m_folder);
    }
    ~MakeBuilding() override { fs::remove_all(m_folder); }

    /** Exit code; what it printed is in `output`. */
    int run(const std::string& arguments)
    {
        const auto log = m_folder / "log";
        const std::string program = GR2TO_BINARY_DIR "/apps/gr2to-make-building/gr2to-make-building";
        const int status = std::system((program + " " + arguments + " >" + log.string() + " 2>&1").c_str());
        output = gr2to::readFile(log);
        return WEXITSTATUS(status);
    }

    fs::path m_folder;
    std::string output;
};
}  // namespace

TEST_F(MakeBuilding, writesWhatTheGeneratorMakes)
{
    ASSERT_EQ(
        run("-o " + (m_folder / "new").string() + " --name flat --seed 7 --rotation -30 --furniture 0.1"), 0)
        << output;
    const auto b = generateBuilding(buildingOptions(7, -30.0, 0.1));
    const auto grid = gr2to::readGrid(m_folder / "new" / "flat.yaml", {});
    EXPECT_TRUE(grid == b.grid);
    EXPECT_EQ(gr2to::readFile(m_folder / "new" / "flat.gt.json"), annotationJson(b, "flat"));
    EXPECT_TRUE(fs::exists(m_folder / "new" / "flat.gt_labels.png"));
}

TEST_F(MakeBuilding, helpNamesEveryOptionWithUnitRangeAndDefault)
{
    ASSERT_EQ(run("--help"), 0);
    TBuildingOptions options;
    for (auto field : options.fields()) {
        std::replace(field.name.begin(), field.name.end(), '_', '-');
        EXPECT_THAT(output, testing::HasSubstr("--" + field.name + " "));
    }
    EXPECT_THAT(output,
                testing::HasSubstr("Clear width of corridors. [number, m, within [0.8, 20]; default 2]"));
}

TEST_F(MakeBuilding, badUsageExitsWithTwoAndWritesNothing)
{
    const std::string to = "-o " + (m_folder / "none").string() + " ";
    for (const char* arguments : {"--seed x", "--seed ''", "--rotation nan", "--corridor-width 0.9",
                                  "--bogus 1", "--name a/b", "--image ../x.png", "--layout maze"})
    {
        EXPECT_EQ(run(to + arguments), 2) << arguments;
        EXPECT_FALSE(output.empty());
        EXPECT_FALSE(fs::exists(m_folder / "none")) << arguments;
    }
    gr2to::writeFile(m_folder / "file", "x");
    EXPECT_EQ(run("-o " + (m_folder / "file").string()), 2);
}

TEST_F(MakeBuilding, shippedSampleIsMadeByTheCommandInItsReadme)
{
    const fs::path sample = fs::path(GR2TO_SOURCE_DIR) / "share" / "sample";
    const std::string readme = gr2to::readFile(sample / "README.md");
    const std::string program = "gr2to-make-building ";
    const auto start = readme.find(program) + program.size();
    ASSERT_EQ(
        run(readme.substr(start, readme.find('\n', start) - start) + " -o " + (m_folder / "again").string()),
        0)
        << output;
    EXPECT_TRUE(gr2to::readGrid(m_folder / "again" / "office.yaml", {}) ==
                gr2to::readGrid(sample / "office.yaml", {}));
    EXPECT_EQ(gr2to::readFile(m_folder / "again" / "office.gt.json"),
              gr2to::readFile(sample / "office.gt.json"));
}
