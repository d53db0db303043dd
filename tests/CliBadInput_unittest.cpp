#include <gmock/gmock.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include <ostream>

#include "gr2to/base/files.h"
#include "gr2to/io/PngWriter.h"
#include "gr2to/io/RosMapWriter.h"
#include "support/cli.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
/** A call that has to be refused. */
struct BadInput
{
    const char* name;
    std::vector<std::string> arguments;  //!< of `gr2to extract`
    std::vector<std::string> words;      //!< of the message
};

std::ostream& operator<<(std::ostream& out, const BadInput& bad)
{
    return out << bad.name;
}

std::string gridmap()
{
    mrpt::maps::COccupancyGridMap2D map(0.0f, 3.0f, 0.0f, 3.0f, 0.1f);
    map.fill(0.9f);
    map.setCell(5, 5, 0.1f);
    mrpt::io::CMemoryStream stream;
    mrpt::serialization::archiveFrom(stream) << map;
    return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}

std::string yamlOf(const std::string& imageLine)
{
    return imageLine +
           "resolution: 0.1\norigin: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.196\nnegate: 0\n";
}

void writeImages(const TempFolder& folder)
{
    const ClassifiedGrid rooms = roomsGrid();
    const std::string png = encodePng8(rooms), pgm = encodePgm(rooms);
    folder.write("truncated.png", png.substr(0, png.size() / 2));
    folder.write("truncated.pgm", pgm.substr(0, pgm.size() / 2));
    folder.write("whole.gridmap", gridmap());
    folder.write("truncated.gridmap", gridmap().substr(0, 500));
    folder.write("empty.png", "");
    folder.write("text.png", "this is not a picture\n");
    folder.write("huge.pgm", "P5\n65536 65536\n255\n");
    const auto uniform = [&](const std::string& name, int side, CellState state) {
        folder.write(name, encodePng8(ClassifiedGrid(side, side, GridFrame{}, state)));
    };
    uniform("one.png", 1, CellState::Free);
    uniform("free.png", 20, CellState::Free);
    uniform("occupied.png", 20, CellState::Occupied);
    uniform("unknown.png", 20, CellState::Unknown);
    std::filesystem::create_directory(folder.path() / "folder.png");
}

class CliBadInput : public testing::TestWithParam<BadInput>
{
 protected:
    CliBadInput()
    {
        writeRooms(m_folder);
        writeImages(m_folder);
        m_folder.write("noimage.yaml", yamlOf(""));
        m_folder.write("escaping.yaml", yamlOf("image: ../secret.png\n"));
        m_folder.write("dangling.yaml", yamlOf("image: absent.png\n"));
        m_folder.write("typo.ini", "[door]\nmax_widht = 1.2\n");
        m_folder.write("section.ini", "[dor]\nmax_width = 1.2\n");
        m_folder.write("line.ini", "[door]\nmax_width 1.2\n");
        m_folder.write("twice.ini", "[door]\nmax_width = 1\nmax_width = 2\n");
        m_folder.write("range.ini", "[door]\nmax_width = 100\n");
    }
    TempFolder m_folder;
};

using Arguments = std::vector<std::string>;

Arguments image(const std::string& name)
{
    return {name, "--resolution", "0.1"};
}

Arguments rooms(const Arguments& more)
{
    Arguments all = {"rooms.yaml"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}
}  // namespace

TEST_P(CliBadInput, isRefusedInOneLineAndNothingIsWritten)
{
    const auto before = contentOf(m_folder.path());
    Arguments arguments = {"extract", "-o", "out"};
    arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
    expectBadUsage(runCli(m_folder.path(), arguments), GetParam().words);
    EXPECT_EQ(contentOf(m_folder.path()), before);
}

INSTANTIATE_TEST_SUITE_P(
    Files, CliBadInput,
    testing::Values(BadInput{"missing", image("absent.png"), {"'absent.png'", "does not exist"}},
                    BadInput{"directory", image("folder.png"), {"'folder.png'", "folder"}},
                    BadInput{"device", image("/dev/zero"), {"'/dev/zero'", "device"}},
                    BadInput{"empty", image("empty.png"), {"'empty.png'", "empty"}},
                    BadInput{"truncatedPng", image("truncated.png"), {"'truncated.png'", "truncated"}},
                    BadInput{"truncatedPgm", image("truncated.pgm"), {"'truncated.pgm'", "truncated"}},
                    BadInput{"truncatedGridmap", {"truncated.gridmap"}, {"'truncated.gridmap'", "truncated"}},
                    BadInput{"textNamedPng", image("text.png"), {"'text.png'", "text"}},
                    BadInput{"noResolution", {"rooms.png"}, {"'rooms.png'", "--resolution"}},
                    BadInput{"oneCell", image("one.png"), {"'one.png'", "1 x 1"}},
                    BadInput{"allFree", image("free.png"), {"'free.png'", "no occupied cell"}},
                    BadInput{"allOccupied", image("occupied.png"), {"'occupied.png'", "no free cell"}},
                    BadInput{"allUnknown", image("unknown.png"), {"'unknown.png'", "only unknown cells"}},
                    BadInput{"hugeHeader", image("huge.pgm"), {"'huge.pgm'", "65536"}},
                    BadInput{"yamlWithoutImage", {"noimage.yaml"}, {"'noimage.yaml'", "image"}},
                    BadInput{"imageEscapes", {"escaping.yaml"}, {"'escaping.yaml'", "../secret.png"}},
                    BadInput{"imageMissing", {"dangling.yaml"}, {"'dangling.yaml'", "absent.png"}}),
    [](const auto& bad) { return bad.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Options, CliBadInput,
    testing::Values(
        BadInput{"zeroResolution", {"rooms.png", "--resolution", "0"}, {"resolution", "0"}},
        BadInput{"negativeResolution", {"rooms.png", "--resolution", "-0.1"}, {"resolution", "-0.1"}},
        BadInput{"nanResolution", {"rooms.png", "--resolution", "nan"}, {"resolution", "nan"}},
        BadInput{
            "resolutionOfGridmap", {"whole.gridmap", "--resolution", "0.2"}, {"whole.gridmap", "resolution"}},
        BadInput{
            "unknownOption", rooms({"--door-max-widht", "1"}), {"--door-max-widht", "'--door-max-width'"}},
        BadInput{"unknownKey", rooms({"--set", "door.maxwidth=1"}), {"door.maxwidth", "'door.max_width'"}},
        BadInput{"keyWithoutValue", rooms({"--set", "door.max_width"}), {"'='"}},
        BadInput{"optionWithoutValue", rooms({"--door-max-width"}), {"--door-max-width", "value"}},
        BadInput{"noNumber", rooms({"--door-max-width", "wide"}), {"door.max_width", "'wide'"}},
        BadInput{"outOfRange", rooms({"--door-max-width", "100"}), {"door.max_width", "100", "20"}},
        BadInput{"contradiction", rooms({"--door-min-width", "2"}), {"door.max_width", "door.min_width"}},
        BadInput{
            "twice", rooms({"--door-max-width", "1", "--door-max-width", "2"}), {"--door-max-width", "once"}},
        BadInput{"twiceByKey",
                 rooms({"--door-max-width", "1", "--set", "door.max_width=1"}),
                 {"door.max_width", "once"}},
        BadInput{"outputTwice", rooms({"-o", "other"}), {"--output", "once"}},
        BadInput{"unknownPreset", rooms({"--preset", "papr"}), {"'papr'", "'paper'"}},
        BadInput{"strayArgument", rooms({"other.yaml"}), {"'other.yaml'"}},
        BadInput{"emptyValue", rooms({"-c", ""}), {"--config", "empty"}},
        BadInput{"missingConfig", rooms({"-c", "absent.ini"}), {"'absent.ini'", "does not exist"}},
        BadInput{"unknownKeyInConfig", rooms({"-c", "typo.ini"}), {"typo.ini", "line 2", "'door.max_width'"}},
        BadInput{"unknownSectionInConfig", rooms({"-c", "section.ini"}), {"section.ini", "dor.max_width"}},
        BadInput{"noEntryInConfig", rooms({"-c", "line.ini"}), {"line.ini", "line 2", "max_width 1.2"}},
        BadInput{"twiceInConfig", rooms({"-c", "twice.ini"}), {"twice.ini", "line 3", "line 2"}},
        BadInput{"outOfRangeInConfig", rooms({"-c", "range.ini"}), {"range.ini", "door.max_width", "100"}}),
    [](const auto& bad) { return bad.param.name; });

TEST(CliUsage, commandIsNeededAndNamedIfNear)
{
    const TempFolder folder;
    writeRooms(folder);
    expectBadUsage(runCli(folder.path(), {}), {"no command", "extract"});
    expectBadUsage(runCli(folder.path(), {"extrct", "rooms.yaml"}), {"'extrct'", "'extract'"});
    expectBadUsage(runCli(folder.path(), {"rooms.yaml"}), {"'gr2to extract rooms.yaml'"});
    expectBadUsage(runCli(folder.path(), {"--extract"}), {"'--extract'", "--help"});
    expectBadUsage(runCli(folder.path(), {"extract"}), {"INPUT", "gr2to extract --help"});
}
