#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "gr2to/base/files.h"
#include "gr2to/io/XmlMap.h"
#include "gr2to/mrpt/archive.h"
#include "support/cli.h"
#include "support/someTopologicalMap.h"

using namespace gr2to;
using namespace gr2to::test;
using nlohmann::json;
using testing::HasSubstr;

namespace
{
class CliInfo : public testing::Test
{
 protected:
    CliRun run(const std::vector<std::string>& arguments) const { return runCli(m_folder.path(), arguments); }
    std::string printed(const std::vector<std::string>& arguments) const
    {
        const CliRun result = run(arguments);
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return result.out;
    }
    TempFolder m_folder;
};

/** Three places, a door and an opening, with words. */
TopologicalMap smallMap()
{
    TopologicalMap map;
    map.resolution_m = 0.05;
    map.source = "office.yaml";
    for (PlaceId id = 1; id <= 3; ++id) {
        Place place;
        place.id = id;
        place.area_m2 = 10.0 * id;
        place.center = {1.0 * id, 2, 0};
        map.addPlace(place);
    }
    map.place(2).kind = PlaceKind::Corridor;
    map.place(3).words = {"Büro"};
    for (std::uint32_t id = 1; id <= 2; ++id) {
        Connection connection;
        connection.id = id;
        connection.from = static_cast<PlaceId>(id);
        connection.to = static_cast<PlaceId>(id + 1);
        connection.doorway.size.length_m = 0.9;
        connection.doorway.real = id == 1;
        map.addConnection(connection);
    }
    return map;
}
}  // namespace

TEST_F(CliInfo, tellsAboutAGrid)
{
    writeRooms(m_folder);
    const std::string text = printed({"info", "rooms.yaml"});
    for (const char* part : {"ROS map_server YAML", "rooms.png", "80 x 50 cells", "0.1 m a cell",
                             "8.00 x 5.00 m", "x -1 m, y 2 m", "occupied above 0.65", "free below 0.196"})
        EXPECT_THAT(text, HasSubstr(part));
    const json info = json::parse(printed({"info", "rooms.yaml", "--json"}));
    const ClassifiedGrid grid = roomsGrid();
    EXPECT_EQ(info["free"]["cells"], grid.count(CellState::Free));
    EXPECT_EQ(info["occupied"]["cells"], grid.count(CellState::Occupied));
    EXPECT_EQ(info["unknown"]["cells"], 0);
    EXPECT_NEAR(info["free"]["area_m2"], 0.01 * static_cast<double>(grid.count(CellState::Free)), 1e-9);
    EXPECT_EQ(info["origin"]["x_m"], -1);
    EXPECT_EQ(info["origin"]["yaw_rad"], 0);
}

TEST_F(CliInfo, yawIsTold)
{
    writeRooms(m_folder);
    std::string yaml = readFile(m_folder.path() / "rooms.yaml");
    const auto origin = yaml.find("origin:");
    yaml.replace(origin, yaml.find('\n', origin) - origin, "origin: [1, 2, 0.5]");
    m_folder.write("turned.yaml", yaml);
    EXPECT_THAT(printed({"info", "turned.yaml"}), HasSubstr("yaw 28.65 deg"));
}

TEST_F(CliInfo, tellsAboutATopologicalMapInEitherForm)
{
    m_folder.write("map.xml", toXml(smallMap()));
    m_folder.write("map.gr2to", toArchive(smallMap()));
    for (const std::string file : {"map.xml", "map.gr2to"}) {
        const std::string text = printed({"info", file});
        for (const char* part :
             {"office.yaml, 0.05 m", "3 of 60.00 m2: 2 rooms, 1 corridor", "2: 1 door, 1 opening",
              " 2  corridor    20.00  2.00  2.00         1, 3", "Büro"})
            EXPECT_THAT(text, HasSubstr(part)) << file;
        const json info = json::parse(printed({"info", file, "--json"}));
        EXPECT_EQ(info["places"].size(), 3u);
        EXPECT_EQ(info["places"][1]["neighbours"], (json{1, 3}));
        EXPECT_EQ(info["places"][2]["words"], (json{"Büro"}));
        EXPECT_EQ(info["connections"][0]["real"], true);
        EXPECT_EQ(info["connections"][1]["real"], false);
    }
}

TEST_F(CliInfo, folderStandsForTheMapInIt)
{
    m_folder.write("out/topomap.xml", toXml(smallMap()));
    EXPECT_THAT(printed({"info", "out"}), HasSubstr("2 rooms"));
    EXPECT_EQ(printed({"validate", "out"}), "out/topomap.xml: valid\n");
    std::filesystem::create_directory(m_folder.path() / "bare");
    expectBadUsage(run({"info", "bare"}), {"'bare'", "topomap.xml"});
}

TEST_F(CliInfo, badFilesAreRefused)
{
    m_folder.write("map.xml", toXml(smallMap()));
    m_folder.write("broken.xml", toXml(smallMap()).substr(0, 300));
    m_folder.write("broken.gr2to", toArchive(smallMap()).substr(0, 30));
    expectBadUsage(run({"info", "absent"}), {"'absent'", "does not exist"});
    expectBadUsage(run({"info", "broken.xml"}), {"broken.xml"});
    expectBadUsage(run({"info", "broken.gr2to"}), {"broken.gr2to"});
    expectBadUsage(run({"info", "map.xml", "--resolution", "0.1"}), {"'map.xml'", "topological map"});
    expectBadUsage(run({"info"}), {"FILE"});
}

TEST_F(CliInfo, validateAcceptsWhatKeepsTheRules)
{
    m_folder.write("map.xml", toXml(smallMap()));
    m_folder.write("map.gr2to", toArchive(smallMap()));
    EXPECT_EQ(printed({"validate", "map.xml"}), "map.xml: valid\n");
    EXPECT_EQ(printed({"validate", "map.gr2to"}), "map.gr2to: valid\n");
    EXPECT_EQ(json::parse(printed({"validate", "map.xml", "--json"}))["valid"], true);
}

TEST_F(CliInfo, validatePrintsALineForEachBrokenRule)
{
    TopologicalMap map = smallMap();
    map.place(1).area_m2 = -1;
    map.resolution_m = 0;
    m_folder.write("map.xml", toXml(map));
    const CliRun result = run({"validate", "map.xml"});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 2) << result.out;
    EXPECT_THAT(result.out, HasSubstr("area"));
    EXPECT_THAT(result.out, HasSubstr("resolution"));
    const CliRun asJson = run({"validate", "map.xml", "--json"});
    EXPECT_EQ(asJson.code, 2);
    EXPECT_EQ(json::parse(asJson.out)["findings"].size(), 2u);
}

TEST_F(CliInfo, validateRefusesWhatIsNoMap)
{
    writeRooms(m_folder);
    m_folder.write("other.xml", "<other/>");
    expectBadUsage(run({"validate", "rooms.yaml"}), {"'rooms.yaml'"});
    expectBadUsage(run({"validate", "other.xml"}), {"other.xml"});
    expectBadUsage(run({"validate", "absent.xml"}), {"'absent.xml'", "does not exist"});
}
