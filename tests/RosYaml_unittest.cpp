#include <gmock/gmock.h>

#include <cmath>

#include "gr2to/io/GridReader.h"
#include "gr2to/io/PngWriter.h"
#include "gr2to/io/RosMapWriter.h"
#include "support/drawMap.h"
#include "support/inputFiles.h"

using namespace gr2to;
using namespace gr2to::test;
using testing::AllOf;
using testing::HasSubstr;

namespace
{
const std::string kPixels = "P2 7 1 255 255 206 205 204 128 89 0";

/** A folder with `map.pgm` and a YAML file for it. */
class RosMap : public testing::Test
{
 protected:
    RosMap() { m_folder.write("map.pgm", kPixels); }

    /** A good YAML file, but for one key, which gets another value or, with an empty one, goes. */
    std::filesystem::path yamlWith(const std::string& key, const std::string& value) const
    {
        std::string text;
        for (const auto& [name, good] :
             std::vector<std::pair<std::string, std::string>>{{"image", "map.pgm"},
                                                              {"resolution", "0.05"},
                                                              {"origin", "[-1.5, 2, 0]"},
                                                              {"negate", "0"},
                                                              {"occupied_thresh", "0.65"},
                                                              {"free_thresh", "0.196"}})
            if (name != key) text.append(name).append(": ").append(good).append("\n");
        return m_folder.write("map.yaml", value.empty() ? text : text + key + ": " + value + "\n");
    }
    std::string drawingWith(const std::string& key, const std::string& value,
                            const TGridReaderOptions& options = {}) const
    {
        return drawingOf(readGrid(yamlWith(key, value), options));
    }
    std::string errorWith(const std::string& key, const std::string& value) const
    {
        return readErrorOf(yamlWith(key, value), TGridReaderOptions());
    }

    TempFolder m_folder;
};
}  // namespace

TEST_F(RosMap, valuesOfTheFileApply)
{
    GridSource source;
    const auto grid = readGrid(yamlWith("", ""), TGridReaderOptions(), &source);
    EXPECT_EQ(drawingOf(grid), "..???##\n");
    EXPECT_EQ(grid.resolution_m(), 0.05);
    EXPECT_EQ(grid.frame().origin_x_m, -1.5);
    EXPECT_EQ(grid.frame().origin_y_m, 2.0);
    EXPECT_EQ(source.occupied_threshold, 0.65);
    EXPECT_EQ(source.free_threshold, 0.196);
    EXPECT_EQ(drawingWith("free_thresh", "0.1"), ".????##\n");
    EXPECT_EQ(drawingWith("free_thresh", "0.25"), "..?.?##\n");  // 205 is what ROS 2 saves for unknown
    EXPECT_EQ(drawingWith("occupied_thresh", "0.4"), "..??###\n");
    EXPECT_EQ(drawingWith("negate", "1"), "####??.\n");
}

TEST_F(RosMap, modesAreThoseOfRos)
{
    EXPECT_EQ(drawingWith("mode", "trinary"), "..???##\n");
    EXPECT_EQ(drawingWith("mode", "scale"), "..???##\n");
    EXPECT_EQ(drawingWith("mode", "raw"), "?????#.\n");
}

TEST_F(RosMap, optionsThatAreGivenWinOverTheFile)
{
    TGridReaderOptions options;
    options.resolution = 0.1;
    options.occupied_threshold = 0.4;
    options.negate = "no";
    const auto grid = readGrid(yamlWith("negate", "1"), options);
    EXPECT_EQ(drawingOf(grid), "..??###\n");
    EXPECT_EQ(grid.resolution_m(), 0.1);
    EXPECT_EQ(readGrid(yamlWith("resolution", ""), options).resolution_m(), 0.1);
    options.mode = "raw";
    EXPECT_EQ(drawingWith("mode", "scale", options), "?????#.\n");
}

TEST_F(RosMap, theYawTurnsTheGridAboutItsOrigin)
{
    const auto grid = readGrid(yamlWith("origin", "[1.0, 2.0, 1.5707963267948966]"), TGridReaderOptions());
    const auto centre =
        grid.frame().toMap(Cell{6, 0});  // 6.5 cells along the grid's x, half a cell along its y
    EXPECT_NEAR(centre.x(), 1.0 - 0.025, 1e-12);
    EXPECT_NEAR(centre.y(), 2.0 + 0.325, 1e-12);
}

TEST_F(RosMap, roundTripsLoseNothing)
{
    auto drawn = randomMap(17, 11, 5);
    ClassifiedGrid map(drawn.width(), drawn.height(), GridFrame{0.1 / 3, -12.34, 1e-7, -0.3});
    for (std::size_t i = 0; i < map.size(); ++i) map[i] = drawn[i];
    m_folder.write("my \"own\" map: 1.png", encodePng8(map));
    const auto yaml = m_folder.write("b.yaml", encodeRosYaml(map.frame(), "my \"own\" map: 1.png"));
    EXPECT_EQ(readGrid(yaml, TGridReaderOptions()), map);
}

TEST_F(RosMap, lackingKeysAreNamed)
{
    for (const std::string key :
         {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"})
        EXPECT_THAT(errorWith(key, ""), AllOf(HasSubstr("lacks the key '" + key + "'"), HasSubstr("add")));
}

TEST_F(RosMap, badValuesAreNamedWithTheirKeyAndRule)
{
    for (const std::string bad : {"0", "-0.05", "nan", ".nan", "inf", "five", "[0.05]", "~", "0.05m", "''"})
        EXPECT_THAT(errorWith("resolution", bad), AllOf(HasSubstr("resolution"), HasSubstr("positive")))
            << bad;
    for (const std::string bad :
         {"[0, 0]", "[0, 0, 0, 0]", "0", "[0, 0, nan]", "[0, x, 0]", "{x: 0}", "[[0], 0, 0]"})
        EXPECT_THAT(errorWith("origin", bad), AllOf(HasSubstr("origin"), HasSubstr("[x, y, yaw]"))) << bad;
    for (const std::string bad : {"2", "maybe", "[0]"})
        EXPECT_THAT(errorWith("negate", bad), HasSubstr("negate"));
    for (const std::string key : {"occupied_thresh", "free_thresh"})
        for (const std::string bad : {"-0.1", "65", "nan", "much"})
            EXPECT_THAT(errorWith(key, bad), AllOf(HasSubstr(key), HasSubstr("[0, 1]"))) << bad;
    EXPECT_THAT(errorWith("free_thresh", "0.7"), AllOf(HasSubstr("0.7"), HasSubstr("0.65")));
    EXPECT_THAT(errorWith("mode", "binary"), AllOf(HasSubstr("mode"), HasSubstr("trinary, scale or raw")));
}

TEST_F(RosMap, malformedYamlIsRefused)
{
    for (const std::string bad :
         {"image: [map.pgm\n", "image: \"map.pgm\n", "image: map.pgm\n\tresolution: 1\n", "image: *unknown\n",
          "just words\n", "- image\n- list\n", "---\n", "# nothing\n", "image: a\nimage: b\n",
          "image: {a: b}\n", "image:\n", "image: ''\n"})
        EXPECT_NE(readErrorOf(m_folder.write("bad.yaml", bad), TGridReaderOptions()), "") << bad;
    EXPECT_NE(readErrorOf(m_folder.write("deep.yaml", std::string(100000, '[')), TGridReaderOptions()), "");
    EXPECT_THAT(readErrorOf(m_folder.write("long.yaml", std::string(2000000, 'a')), TGridReaderOptions()),
                HasSubstr("too long"));
}

TEST_F(RosMap, imagesThatAreAbsentOrLeadOutAreRefused)
{
    EXPECT_THAT(errorWith("image", "absent.pgm"),
                AllOf(HasSubstr("absent.pgm"), HasSubstr("does not exist")));
    EXPECT_THAT(errorWith("image", "../map.pgm"), HasSubstr("leads out"));
    EXPECT_THAT(errorWith("image", "a/../../map.pgm"), HasSubstr("leads out"));
    EXPECT_THAT(errorWith("image", ".."), HasSubstr("leads out"));
    EXPECT_THAT(errorWith("image", "."), HasSubstr("folder"));
    EXPECT_THAT(errorWith("image", "map.yaml"), HasSubstr("no PNG or PGM"));
    m_folder.write("short.pgm", kPixels.substr(0, 20));
    EXPECT_THAT(errorWith("image", "short.pgm"), AllOf(HasSubstr("short.pgm"), HasSubstr("truncated")));
}

TEST_F(RosMap, imagesInSubfoldersAndByAbsolutePathAreRead)
{
    m_folder.write("sub/map.pgm", kPixels);
    EXPECT_EQ(drawingWith("image", "sub/../sub/./map.pgm"), "..???##\n");
    const TempFolder elsewhere;
    EXPECT_EQ(drawingWith("image", elsewhere.write("far.pgm", kPixels).string()), "..???##\n");
}
