#include "gr2to/io/PngWriter.h"

#include <gmock/gmock.h>

#include "gr2to/base/errors.h"
#include "gr2to/io/GridReader.h"
#include "gr2to/io/RosMapWriter.h"
#include "support/drawMap.h"
#include "support/inputFiles.h"
#include "support/pngBytes.h"

using namespace gr2to;
using namespace gr2to::test;

TEST(PngWriter, placeIdsAreBigEndianGreysWithTheTopRowFirst)
{
    PlaceImage image(3, 2);
    image.ids = {1, 256, 65535, 0, 0x1234, 7};  // the bottom row first
    const auto png = decodeGreyPng(encodePng16(image));
    EXPECT_EQ(png.width, 3u);
    EXPECT_EQ(png.height, 2u);
    EXPECT_EQ(png.bits, 16);
    EXPECT_EQ(png.rows[0], std::string("\x00\x00\x12\x34\x00\x07", 6));
    EXPECT_EQ(png.rows[1], std::string("\x00\x01\x01\x00\xff\xff", 6));
}

TEST(PngWriter, statesAreTheGreysOfMapSavers)
{
    const auto png = decodeGreyPng(encodePng8(drawMap({".?", "#."})));
    EXPECT_EQ(png.bits, 8);
    EXPECT_EQ(png.rows[0], "\xfe\xcd");
    EXPECT_EQ(png.rows[1], std::string("\x00\xfe", 2));
}

TEST(PngWriter, writingTwiceGivesTheSameBytes)
{
    const auto map = randomMap(123, 77, 9);
    EXPECT_EQ(encodePng8(map), encodePng8(map));
    PlaceImage image(123, 77);
    for (std::size_t i = 0; i < image.ids.size(); ++i) image.ids[i] = static_cast<PlaceId>(i * i);
    EXPECT_EQ(encodePng16(image), encodePng16(image));
}

TEST(PngWriter, randomGridsRoundTripAsPngAndPgm)
{
    const TempFolder folder;
    for (unsigned seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        const auto map = randomMap(1 + static_cast<int>(seed) * 7, 40 - static_cast<int>(seed), seed);
        EXPECT_EQ(readGrid(folder.write("a.png", encodePng8(map)), imageOptions()), map);
        EXPECT_EQ(readGrid(folder.write("a.pgm", encodePgm(map)), imageOptions()), map);
    }
}

TEST(PngWriter, randomPlacesRoundTrip)
{
    PlaceImage image(57, 31);
    for (std::size_t i = 0; i < image.ids.size(); ++i) image.ids[i] = static_cast<PlaceId>(i * 40503U);
    const auto png = decodeGreyPng(encodePng16(image));
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto& row = png.rows[static_cast<std::size_t>(image.height - 1 - y)];
            const auto high = static_cast<unsigned char>(row[2 * static_cast<std::size_t>(x)]);
            const auto low = static_cast<unsigned char>(row[2 * static_cast<std::size_t>(x) + 1]);
            ASSERT_EQ(high * 256 + low, image.at({x, y})) << x << ", " << y;
        }
}

TEST(PngWriter, imagesWithoutPixelsAreRefused)
{
    EXPECT_THROW(encodePng16(PlaceImage()), OutputError);
    EXPECT_THROW(encodePng8(ClassifiedGrid()), OutputError);
}

TEST(RosMapWriter, theYamlHasTheKeysThatMapServerNeeds)
{
    EXPECT_EQ(encodeRosYaml(GridFrame{0.05, -1.5, 2, 0.25}, "map.pgm"),
              "image: \"map.pgm\"\nmode: trinary\nresolution: 0.05\norigin: [-1.5, 2, 0.25]\nnegate: 0\n"
              "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}
