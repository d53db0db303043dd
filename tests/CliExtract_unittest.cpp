#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "gr2to/base/files.h"
#include "gr2to/io/LabelImageReader.h"
#include "gr2to/io/XmlMap.h"
#include "gr2to/mrpt/archive.h"
#include "support/cli.h"

using namespace gr2to;
using namespace gr2to::test;
using nlohmann::json;
using testing::HasSubstr;

namespace
{
namespace fs = std::filesystem;

class CliExtract : public testing::Test
{
 protected:
    CliExtract() { writeRooms(m_folder); }

    CliRun run(const std::vector<std::string>& arguments) const
    {
        std::vector<std::string> all = {"extract"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return runCli(m_folder.path(), all);
    }
    /** Runs without trouble and gives the summary. */
    json summaryOf(std::vector<std::string> arguments) const
    {
        arguments.emplace_back("--json");
        const CliRun result = run(arguments);
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return json::parse(result.out);
    }
    fs::path at(const std::string& name) const { return m_folder.path() / name; }

    TempFolder m_folder;
};

std::set<PlaceId> idsOf(const PlaceImage& image)
{
    std::set<PlaceId> ids(image.ids.begin(), image.ids.end());
    ids.erase(0);
    return ids;
}

std::set<PlaceId> idsOf(const TopologicalMap& map)
{
    std::set<PlaceId> ids;
    for (const auto& [id, place] : map.places()) ids.insert(id);
    return ids;
}
}  // namespace

TEST_F(CliExtract, writesAllFilesOfAYamlMap)
{
    const CliRun result = run({"rooms.yaml", "-o", "out"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    std::vector<std::string> names;
    for (const auto& [name, bytes] : contentOf(at("out"))) names.push_back(name);
    EXPECT_EQ(names, extractedFiles());
    const TopologicalMap map = readXml(at("out/topomap.xml"));
    EXPECT_EQ(map.source, "rooms.yaml");
    EXPECT_EQ(map.frame, "map");
    EXPECT_EQ(map.resolution_m, 0.1);
    EXPECT_TRUE(map.validate().empty());
    EXPECT_EQ(loadTopologicalMap(at("out/topomap.gr2to")), map);
}

TEST_F(CliExtract, placesOfTheImageAreThoseOfTheMap)
{
    ASSERT_EQ(run({"rooms.yaml", "-o", "out"}).code, 0);
    const PlaceImage places = readLabelImage(at("out/places.png")).labels;
    EXPECT_EQ(places.width, roomsGrid().width());
    EXPECT_EQ(places.height, roomsGrid().height());
    const auto ids = idsOf(readXml(at("out/topomap.xml")));
    EXPECT_EQ(idsOf(places), ids);
    EXPECT_GE(ids.size(), 2u);
    EXPECT_NE(places.at({20, 25}), places.at({60, 25})) << "the two rooms";
}

TEST_F(CliExtract, doorLiesInTheMapFrame)
{
    ASSERT_EQ(run({"rooms.yaml", "-o", "out"}).code, 0);
    std::vector<Connection> doors;
    for (const auto& connection : readXml(at("out/topomap.xml")).connections())
        if (connection.doorway.real) doors.push_back(connection);
    ASSERT_EQ(doors.size(), 1u);
    const auto expected = roomsGrid().frame().toMap(40, 24);
    EXPECT_NEAR(doors[0].doorway.position.mean.x, expected.x(), 0.15);
    EXPECT_NEAR(doors[0].doorway.position.mean.y, expected.y(), 0.15);
    EXPECT_NEAR(doors[0].doorway.size.length_m, 0.9, 0.15);
}

TEST_F(CliExtract, xmlKeepsTheSchema)
{
    if (std::system("command -v xmllint >/dev/null") != 0)
        GTEST_SKIP() << "xmllint is not installed (package libxml2-utils): the schema is not tested";
    ASSERT_EQ(run({"rooms.yaml", "-o", "out"}).code, 0);
    const std::string command = "xmllint --noout --schema '" GR2TO_SOURCE_DIR "/share/topomap.xsd' " +
                                quoted(at("out/topomap.xml").string()) + " 2>/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST_F(CliExtract, bareImageNeedsItsResolutionOnly)
{
    const json summary = summaryOf({"rooms.png", "--resolution", "0.1", "-o", "out"});
    EXPECT_EQ(summary["grid"]["resolution_m"], 0.1);
    EXPECT_EQ(summary["grid"]["origin"]["x_m"], 0);
    EXPECT_EQ(summary["options"]["input"]["resolution"], 0.1);
    EXPECT_EQ(readXml(at("out/topomap.xml")).source, "rooms.png");
}

TEST_F(CliExtract, folderIsNamedAfterTheInput)
{
    fs::create_directory(at("sub folder"));
    fs::copy(at("rooms.png"), at("sub folder/Büro 1.final.png"));
    const json summary = summaryOf({"sub folder/Büro 1.final.png", "--resolution", "0.1"});
    EXPECT_TRUE(fs::exists(at("Büro 1.final/topomap.xml")));
    EXPECT_EQ(summary["files"][0], "Büro 1.final/topomap.xml");
}

TEST_F(CliExtract, summaryTellsWhatIsInTheFiles)
{
    const json summary = summaryOf({"rooms.yaml", "-o", "out", "--preset", "paper"});
    const TopologicalMap map = readXml(at("out/topomap.xml"));
    EXPECT_EQ(summary["input"], "rooms.yaml");
    EXPECT_EQ(summary["grid"]["width"], 80);
    EXPECT_EQ(summary["grid"]["height"], 50);
    EXPECT_EQ(summary["preset"], "paper");
    EXPECT_EQ(summary["places"], map.places().size());
    EXPECT_EQ(summary["rooms"].get<int>() + summary["corridors"].get<int>(), summary["places"].get<int>());
    EXPECT_EQ(summary["doors"].get<std::size_t>() + summary["openings"].get<std::size_t>(),
              map.connections().size());
    EXPECT_EQ(summary["files"].size(), extractedFiles().size());
    std::set<std::string> stages;
    for (const auto& stage : summary["stages"]) stages.insert(stage["stage"].get<std::string>());
    for (const char* stage : {"reading", "distance map", "door detection", "Voronoi diagram",
                              "place construction", "space delimitation", "drawing", "writing"})
        EXPECT_EQ(stages.count(stage), 1u) << stage;
}

TEST_F(CliExtract, tableNamesStagesCountsAndWhatToOpen)
{
    const CliRun result = run({"rooms.yaml", "-o", "out"});
    for (const char* text : {"distance map", "space delimitation", "writing", "total", " ms", "MB",
                             "bytes a cell", "1 door,", "rooms", "Open 'out/overlay.svg'"})
        EXPECT_THAT(result.out, HasSubstr(text));
    EXPECT_EQ(run({"rooms.yaml", "-o", "out", "-q"}).out, "");
}

TEST_F(CliExtract, sameInputGivesSameBytes)
{
    ASSERT_EQ(run({"rooms.yaml", "-o", "one"}).code, 0);
    ASSERT_EQ(run({"rooms.yaml", "-o", "two"}).code, 0);
    const auto one = contentOf(at("one"));
    EXPECT_EQ(one, contentOf(at("two")));
    EXPECT_EQ(one.size(), extractedFiles().size());
}

TEST_F(CliExtract, presetGivesWayToTheFileAndTheFileToTheCommandLine)
{
    const auto options = [&](const std::vector<std::string>& arguments) {
        std::vector<std::string> all = {"rooms.yaml", "-o", "out"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return summaryOf(all)["options"];
    };
    m_folder.write("my.ini",
                   "[distance]\nunknown_is_obstacle = yes // over the preset\n[door]\nmax_width = 1.4\n"
                   "[overlay]\nlegend = no\n[input]\nunknown_grey = 200\n");
    EXPECT_EQ(options({"--preset", "paper"})["distance"]["unknown_is_obstacle"], false);
    const json fromFile = options({"--preset", "paper", "-c", "my.ini"});
    EXPECT_EQ(fromFile["distance"]["unknown_is_obstacle"], true);
    EXPECT_EQ(fromFile["door"]["max_width"], 1.4);
    EXPECT_EQ(fromFile["overlay"]["legend"], false);
    EXPECT_EQ(fromFile["input"]["unknown_grey"], 200);
    EXPECT_EQ(options({"-c", "my.ini", "--door-max-width", "1.3"})["door"]["max_width"], 1.3);
    EXPECT_EQ(options({"-c", "my.ini", "--set", "door.max_width=1.2", "--set", "door.min_width=0.6"})["door"],
              (json{{"min_width", 0.6}, {"max_width", 1.2}}));
}

TEST_F(CliExtract, optionsWithoutEffectAreNoted)
{
    const auto idle = run({"rooms.yaml", "-o", "out", "--place-min-depth", "0.5"});
    EXPECT_EQ(idle.code, 0);
    EXPECT_THAT(idle.err, HasSubstr("note: 'place.min_depth' has no effect while cut.along_walls is yes\n"));
    const auto used = run({"rooms.yaml", "-o", "out", "--preset", "paper", "--place-min-depth", "0.5"});
    EXPECT_THAT(used.err, Not(HasSubstr("has no effect")));
    const auto quiet = run({"rooms.yaml", "-o", "out", "-q", "--place-min-depth", "0.5"});
    EXPECT_EQ(quiet.err, "");
}

TEST_F(CliExtract, layersAreSwitchedByOptions)
{
    ASSERT_EQ(run({"rooms.yaml", "-o", "all"}).code, 0);
    ASSERT_EQ(run({"rooms.yaml", "-o", "some", "--overlay-voronoi", "no"}).code, 0);
    EXPECT_NE(readFile(at("all/overlay.svg")), readFile(at("some/overlay.svg")));
    EXPECT_NE(readFile(at("all/overlay.png")), readFile(at("some/overlay.png")));
    EXPECT_EQ(readFile(at("all/topomap.xml")), readFile(at("some/topomap.xml")));
}

TEST_F(CliExtract, nameThatTextCannotHoldIsStoredWithQuestionMarks)
{
    const std::string name = "b\xfcro\n.png";
    fs::copy(at("rooms.png"), at(name));
    const CliRun result = run({name, "--resolution", "0.1", "-o", "out", "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(readXml(at("out/topomap.xml")).source, "b?ro?.png");
    EXPECT_TRUE(json::accept(result.out));
}
