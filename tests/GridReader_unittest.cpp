#include "gr2to/io/GridReader.h"

#include <gmock/gmock.h>

#include <limits>

#include "gr2to/io/PngWriter.h"
#include "gr2to/io/RosMapWriter.h"
#include "support/drawMap.h"
#include "support/inputFiles.h"
#include "support/pngBytes.h"

using namespace gr2to;
using namespace gr2to::test;
using testing::AllOf;
using testing::HasSubstr;

namespace
{
std::string invalidArgumentOf(const std::function<void()>& action)
{
    try {
        action();
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

const ClassifiedGrid& sample()
{
    static const auto grid = drawMap({"####?", "#..#?", "#...."});
    return grid;
}
}  // namespace

TEST(GridReader, contentAndNotTheNameTellsTheFormat)
{
    const TempFolder folder;
    GridSource source;
    const auto png = folder.write("image.pgm", encodePng8(sample()));
    EXPECT_EQ(readGrid(png, imageOptions(), &source), sample());
    EXPECT_EQ(source.format, "PNG image");
    const auto pgm = folder.write("image.unknown", encodePgm(sample()));
    EXPECT_EQ(readGrid(pgm, imageOptions(), &source), sample());
    EXPECT_EQ(source.format, "PGM image");
    const auto yaml = folder.write("map.txt", encodeRosYaml(sample().frame(), "image.pgm"));
    EXPECT_EQ(readGrid(yaml, TGridReaderOptions(), &source), sample());
    EXPECT_EQ(source.format, "ROS map_server YAML");
    EXPECT_EQ(source.image, folder.path() / "image.pgm");
}

TEST(GridReader, aBareImageNeedsAResolution)
{
    const TempFolder folder;
    const auto file = folder.write("a.png", encodePng8(sample()));
    EXPECT_THAT(readErrorOf(file, TGridReaderOptions()), AllOf(HasSubstr("resolution"), HasSubstr(".yaml")));
}

TEST(GridReader, resolutionsThatAreNoLengthAreRefused)
{
    const TempFolder folder;
    const auto file = folder.write("a.png", encodePng8(sample()));
    for (const double bad :
         {0.0, -0.05, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    {
        auto options = imageOptions();
        options.resolution = bad;
        EXPECT_THAT(invalidArgumentOf([&] { readGrid(file, options); }), HasSubstr("input.resolution"))
            << bad;
    }
    TGridReaderOptions options;
    for (const char* bad : {"0", "-0.05", "nan", "inf", "five"})
        EXPECT_THAT(invalidArgumentOf([&] { options.set("resolution", bad); }), HasSubstr("input.resolution"))
            << bad;
}

TEST(GridReader, contradictoryThresholdsAreRefused)
{
    TGridReaderOptions options;
    options.free_threshold = 0.7;
    options.occupied_threshold = 0.6;
    EXPECT_THAT(invalidArgumentOf([&] { options.check(); }),
                AllOf(HasSubstr("input.free_threshold = 0.7"), HasSubstr("input.occupied_threshold = 0.6")));
    const TempFolder folder;
    const auto file = folder.write("a.png", encodePng8(sample()));
    options = imageOptions();
    options.occupied_threshold = 0.1;  // below the default of the other
    EXPECT_THAT(readErrorOf(file, options), HasSubstr("exceeds"));
}

TEST(GridReader, whatCannotBeReadAtAllIsRefused)
{
    const TempFolder folder;
    EXPECT_THAT(readErrorOf(folder.path() / "missing.png"), HasSubstr("does not exist"));
    EXPECT_THAT(readErrorOf(folder.path()), HasSubstr("folder"));
    EXPECT_THAT(readErrorOf(folder.write("empty.png", "")), HasSubstr("empty"));
}

TEST(GridReader, contentThatBeliesTheNameIsRefused)
{
    const TempFolder folder;
    EXPECT_THAT(readErrorOf(folder.write("text.png", "image: a.pgm\n")),
                AllOf(HasSubstr(".png"), HasSubstr("text")));
    EXPECT_THAT(readErrorOf(folder.write("text.PGM", "hello")), AllOf(HasSubstr(".pgm"), HasSubstr("text")));
    EXPECT_THAT(readErrorOf(folder.write("text.gridmap", "hello")), HasSubstr("text"));
    EXPECT_THAT(readErrorOf(folder.write("text.gridmap.gz", "hello")), HasSubstr("text"));
    EXPECT_THAT(readErrorOf(folder.write("noise.png", std::string("\0\1\2\3\xff\n", 6))),
                HasSubstr("other data"));
    EXPECT_THAT(readErrorOf(folder.write("noise.yaml", std::string("\0\1\2\3\xff\n", 6))),
                HasSubstr("not a map"));
    EXPECT_THAT(readErrorOf(folder.write("notes.txt", "hello")), HasSubstr("neither"));
}

TEST(GridReader, otherImagesAreNamedAndRefused)
{
    const TempFolder folder;
    const auto jpeg = folder.write("a.png", std::string("\xff\xd8\xff\xe0\0\x10JFIF\0", 11));
    EXPECT_THAT(readErrorOf(jpeg), AllOf(HasSubstr("JPEG"), HasSubstr("convert")));
    EXPECT_THAT(readErrorOf(folder.write("b.pgm", "P6\n1 1\n255\nabc")), HasSubstr("PPM"));
    EXPECT_THAT(readErrorOf(folder.write("a.simplemap", "rest")), HasSubstr("named as .simplemap but holds"));
    EXPECT_THAT(readErrorOf(folder.write("c.bmp", std::string("BM\0\0\0\0", 6))), HasSubstr("BMP"));
}

TEST(GridReader, inputsOfLaterVersionsAreRefusedByContentAndByName)
{
    const TempFolder folder;
    const auto refused = AllOf(HasSubstr("not supported by this version"), HasSubstr("2D grid"));
    EXPECT_THAT(readErrorOf(folder.write("a.rawlog", "rest")),
                AllOf(HasSubstr("a rawlog"), HasSubstr("gr2to-rawlog")));
    EXPECT_THAT(readErrorOf(folder.write("a.pcd", "# .PCD v0.7")), refused);
}

TEST(GridReader, octreesAreNoGrids)
{
    const TempFolder folder;
    EXPECT_THAT(readErrorOf(folder.write("a.dat", "# Octomap OcTree binary file\n\1\2")),
                AllOf(HasSubstr("OctoMap"), HasSubstr("2D grid is needed")));
    EXPECT_THAT(readErrorOf(folder.write("a.bt", "rest")), HasSubstr("holds text"));
    EXPECT_THAT(readErrorOf(folder.write("a.ot", "rest\1")), HasSubstr("holds other data"));
}

TEST(GridReader, unusableGridsAreRefusedEachWithItsReason)
{
    const auto reason = [](const ClassifiedGrid& grid) {
        auto message = inputErrorOf([&] { requireUsable(grid, "office.png"); });
        EXPECT_THAT(message, HasSubstr("'office.png'"));
        return message;
    };
    EXPECT_THAT(reason(drawMap({"."})), HasSubstr("1 x 1"));
    EXPECT_THAT(reason(drawMap({"#.#"})), HasSubstr("3 x 1"));
    EXPECT_THAT(reason(drawMap({"..", ".."})), HasSubstr("no occupied cell"));
    EXPECT_THAT(reason(drawMap({"##", "#?"})), HasSubstr("no free cell"));
    EXPECT_THAT(reason(drawMap({"??", "??"})), HasSubstr("only unknown"));
    EXPECT_NO_THROW(requireUsable(drawMap({"#.", "??"}), "office.png"));
}

TEST(GridReader, everyOptionHasAMeaningAndADefaultThatPasses)
{
    TGridReaderOptions options;
    EXPECT_NO_THROW(options.check());
    for (const auto& field : options.fields()) EXPECT_NE(field.meaning, "") << field.name;
    EXPECT_THAT(invalidArgumentOf([&] { options.set("ocupied_threshold", "0.5"); }),
                HasSubstr("'input.occupied_threshold'"));
    EXPECT_THAT(invalidArgumentOf([&] { options.set("mode", "binary"); }), HasSubstr("trinary|scale|raw"));
}
