#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "gr2to/base/files.h"
#include "gr2to/io/PngWriter.h"
#include "support/cli.h"

using namespace gr2to;
using namespace gr2to::test;
using nlohmann::json;
using testing::HasSubstr;

namespace
{
namespace fs = std::filesystem;

/** Two rooms that were extracted, and the truth about them. */
class CliCompare : public testing::Test
{
 protected:
    CliCompare()
    {
        writeRooms(m_folder);
        const ClassifiedGrid grid = roomsGrid();
        PlaceImage truth(grid.width(), grid.height());
        for (std::size_t i = 0; i < grid.size(); ++i)
            if (grid[i] == CellState::Free) truth.ids[i] = grid.cell(i).x < 40 ? 1 : 2;
        m_folder.write("truth.gt_labels.png", encodePng16(truth));
        m_folder.write("truth.gt.json",
                       R"({"resolution_m": 0.1, "interfaces": [{"kind": "door", "a": 1, "b": 2,
            "mid_px": [40, 25], "width_m": 0.9}]})");
        EXPECT_EQ(runCli(m_folder.path(), {"extract", "rooms.yaml", "-o", "out", "-q"}).code, 0);
    }
    CliRun run(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), "compare");
        return runCli(m_folder.path(), arguments);
    }
    json scoresOf(std::vector<std::string> arguments) const
    {
        arguments.emplace_back("--json");
        const CliRun result = run(arguments);
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return json::parse(result.out);
    }
    TempFolder m_folder;
};
}  // namespace

TEST_F(CliCompare, doorIsFoundInTheGridsFrame)
{
    const json scores = scoresOf({"out", "truth.gt_labels.png", "--grid", "rooms.yaml"});
    EXPECT_EQ(scores["doors"]["recall"], 1);
    EXPECT_EQ(scores["doors"]["precision"], 1);
    EXPECT_EQ(scores["edges"]["recall"], 1);
    EXPECT_GE(scores["bormann"]["precision"].get<double>(), 0.9);
    EXPECT_EQ(scores["matched"]["labelled_free"], 1);
}

TEST_F(CliCompare, withoutAGridTheFrameStartsAtTheImagesCorner)
{
    EXPECT_EQ(scoresOf({"out", "truth.gt_labels.png"})["doors"]["recall"], 0)
        << "the map was made in a frame with another origin";
    ASSERT_EQ(runCli(m_folder.path(), {"extract", "rooms.png", "--resolution", "0.1", "-o", "bare"}).code, 0);
    EXPECT_EQ(scoresOf({"bare", "truth.gt_labels.png"})["doors"]["recall"], 1);
    EXPECT_EQ(
        scoresOf({"bare", "truth.gt.json", "--grid", "rooms.png", "--resolution", "0.1"})["doors"]["recall"],
        1);
}

TEST_F(CliCompare, mapIsNamedByItsFilesToo)
{
    const json folder = scoresOf({"out", "truth.gt_labels.png", "--grid", "rooms.yaml"});
    EXPECT_EQ(scoresOf({"out/topomap.xml", "truth.gt.json", "--grid", "rooms.yaml"}), folder);
    EXPECT_EQ(scoresOf({"out/topomap.gr2to", "truth.gt.json", "--grid", "rooms.yaml"}), folder);
    fs::copy(m_folder.path() / "out/topomap.xml", m_folder.path() / "alone.xml");
    EXPECT_EQ(scoresOf({"alone.xml", "truth.gt.json", "--grid", "rooms.yaml", "--places", "out/places.png"}),
              folder);
    expectBadUsage(run({"alone.xml", "truth.gt.json"}), {"'alone.xml'", "--places"});
}

TEST_F(CliCompare, placesAloneAreScoredWithoutDoors)
{
    const json scores = scoresOf({"out/places.png", "truth.gt_labels.png"});
    EXPECT_TRUE(scores.contains("bormann"));
    EXPECT_FALSE(scores.contains("doors"));
    EXPECT_FALSE(scores.contains("edges"));
    fs::create_directory(m_folder.path() / "only");
    fs::copy(m_folder.path() / "out/places.png", m_folder.path() / "only/places.png");
    EXPECT_EQ(scoresOf({"only", "truth.gt_labels.png"}), scores);
}

TEST_F(CliCompare, tableNamesTheFigures)
{
    const CliRun result = run({"out", "truth.gt_labels.png", "--grid", "rooms.yaml"});
    ASSERT_EQ(result.code, 0) << result.err;
    for (const char* part : {"mean IoU", "recall ceiling", "Doors", "Pairs of neighbouring rooms"})
        EXPECT_THAT(result.out, HasSubstr(part));
}

TEST_F(CliCompare, contradictionsAreRefused)
{
    m_folder.write("small.gt_labels.png", encodePng16(PlaceImage(5, 5)));
    expectBadUsage(run({"out"}), {"REFERENCE"});
    expectBadUsage(run({"absent", "truth.gt_labels.png"}), {"'absent'"});
    expectBadUsage(run({"out", "absent.gt_labels.png"}), {"absent.gt_labels.png"});
    expectBadUsage(run({"out", "small.gt_labels.png"}), {"5 x 5"});
    expectBadUsage(run({"out", "truth.gt.json", "--resolution", "0.1"}), {"--grid"});
    expectBadUsage(run({"out", "truth.gt.json", "--grid", "rooms.png", "--resolution", "0.2"}),
                   {"0.1 m", "0.2 m"});
    expectBadUsage(run({"out/places.png", "truth.gt.json", "--places", "out/places.png"}), {"--places"});
}
