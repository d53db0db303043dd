#include <gmock/gmock.h>

#include "gr2to/io/GridReader.h"
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
std::string bytes(std::initializer_list<int> values)
{
    std::string out;
    for (const int v : values) out += static_cast<char>(v);
    return out;
}

std::string drawingOfImage(const std::string& image, const TGridReaderOptions& options = imageOptions())
{
    const TempFolder folder;
    return drawingOf(readGrid(folder.write("image", image), options));
}

std::string greys(std::initializer_list<int> values)
{
    return encodePng(pngOf(PngImage::Grey, static_cast<std::uint32_t>(values.size()), {bytes(values)}));
}
}  // namespace

TEST(ImageReader, bareImagesReadAsRosTrinaryWith205Unknown)
{
    EXPECT_EQ(drawingOfImage(greys({254, 255, 205, 0, 206, 204, 128, 90, 89})),
              "..?#.??"
              "?#\n");
}

TEST(ImageReader, thresholdsAreStrictAndOptions)
{
    auto options = imageOptions();
    options.unknown_grey = -1;
    options.free_threshold = 0.4;      // grey 153
    options.occupied_threshold = 0.8;  // grey 51
    EXPECT_EQ(drawingOfImage(greys({154, 153, 152, 51, 50}), options), ".???#\n");
}

TEST(ImageReader, theGreyOfMapSaversIsUnknownWhateverTheThresholds)
{
    auto options = imageOptions();
    options.free_threshold = 0.25;
    EXPECT_EQ(drawingOfImage(greys({206, 205, 204}), options), ".?.\n");
    options.unknown_grey = -1;
    EXPECT_EQ(drawingOfImage(greys({206, 205, 204}), options), "...\n");
    options.unknown_grey = 205;
    options.mode = "scale";
    EXPECT_EQ(drawingOfImage(greys({206, 205, 204}), options), "...\n");
}

TEST(ImageReader, negateSwapsBlackAndWhite)
{
    auto options = imageOptions();
    options.negate = "yes";
    EXPECT_EQ(drawingOfImage(greys({0, 49, 50, 128, 165, 166, 205, 255}), options), "..???###\n");
}

TEST(ImageReader, rawGreysArePerCentOccupied)
{
    auto options = imageOptions();
    options.mode = "raw";
    EXPECT_EQ(drawingOfImage(greys({0, 19, 20, 65, 66, 100, 101, 255}), options), "..??##??\n");
    const TempFolder folder;
    const auto wide = folder.write("wide.pgm", "P2 1 1 65535 7");
    EXPECT_THAT(readErrorOf(wide, options), AllOf(HasSubstr("raw"), HasSubstr("65535")));
}

TEST(ImageReader, theTopRowOfTheImageIsTheTopOfTheMap)
{
    const TempFolder folder;
    const auto file =
        folder.write("a.png", encodePng(pngOf(PngImage::Grey, 2, {bytes({0, 254}), bytes({205, 254})})));
    const auto grid = readGrid(file, imageOptions());
    EXPECT_EQ(drawingOf(grid), "#.\n?.\n");
    EXPECT_EQ(grid.at({0, 1}), CellState::Occupied);
    EXPECT_EQ(grid.resolution_m(), 0.05);
    const auto center = grid.frame().toMap(Cell{0, 1});
    EXPECT_NEAR(center.x(), 0.025, 1e-12);
    EXPECT_NEAR(center.y(), 0.075, 1e-12);
}

TEST(ImageReader, everyKindOfPngGivesTheSameCells)
{
    const std::string expected = ".?#\n";
    EXPECT_EQ(drawingOfImage(greys({254, 205, 0})), expected);
    auto wide = pngOf(PngImage::Grey, 3, {bytes({254, 254, 205, 205, 0, 0})});
    wide.bits = 16;
    EXPECT_EQ(drawingOfImage(encodePng(wide)), expected);
    EXPECT_EQ(
        drawingOfImage(encodePng(pngOf(PngImage::Rgb, 3, {bytes({254, 254, 254, 255, 205, 155, 0, 0, 0})}))),
        expected);
    auto palette = pngOf(PngImage::Palette, 3, {bytes({2, 0, 1})});
    palette.palette = bytes({205, 205, 205, 0, 0, 0, 254, 254, 254});
    EXPECT_EQ(drawingOfImage(encodePng(palette)), expected);
    auto nibbles = pngOf(PngImage::Grey, 3, {bytes({0xf8, 0x00})});
    nibbles.bits = 4;
    EXPECT_EQ(drawingOfImage(encodePng(nibbles)), expected);
    auto pairs = pngOf(PngImage::Grey, 3, {bytes({0xe0})});  // 3, 2, 0
    pairs.bits = 2;
    EXPECT_EQ(drawingOfImage(encodePng(pairs)), expected);
    auto bits = pngOf(PngImage::Grey, 9, {bytes({0xaa, 0x80})});
    bits.bits = 1;
    EXPECT_EQ(drawingOfImage(encodePng(bits)), ".#.#.#.#.\n");
}

TEST(ImageReader, theMeanOfTheColourChannelsCounts)
{
    // Means 231 (free), 205, 85 (occupied); a brightness-weighted grey would call the last one free.
    const auto image = pngOf(PngImage::Rgb, 3, {bytes({255, 255, 183, 255, 255, 105, 0, 255, 0})});
    EXPECT_EQ(drawingOfImage(encodePng(image)), ".?#\n");
}

TEST(ImageReader, whatIsNotOpaqueIsUnknown)
{
    EXPECT_EQ(
        drawingOfImage(encodePng(pngOf(PngImage::GreyAlpha, 4, {bytes({254, 255, 254, 254, 0, 255, 0, 0})}))),
        ".?#?\n");
    EXPECT_EQ(drawingOfImage(encodePng(pngOf(PngImage::Rgba, 2, {bytes({254, 254, 254, 255, 0, 0, 0, 9})}))),
              ".?\n");
    auto palette = pngOf(PngImage::Palette, 3, {bytes({0, 1, 2})});
    palette.palette = bytes({254, 254, 254, 0, 0, 0, 0, 0, 0});
    palette.transparency = bytes({255, 0});
    EXPECT_EQ(drawingOfImage(encodePng(palette)), ".?#\n");
}

TEST(ImageReader, interlacedPngsGiveTheSameGrid)
{
    const auto map = randomMap(21, 19, 7);
    auto image = decodeGreyPng(encodePng8(map));
    image.interlaced = true;
    EXPECT_EQ(drawingOfImage(encodePng(image)), drawingOf(map));
}

TEST(ImageReader, everyKindOfPgmGivesTheSameCells)
{
    EXPECT_EQ(drawingOfImage("P2\n# by hand\n3 1 # size\n255\n254 205\t0\n"), ".?#\n");
    EXPECT_EQ(drawingOfImage("P5\n#CREATOR: x 0.05 m/pix\n3 1\n255\n" + bytes({254, 205, 0})), ".?#\n");
    EXPECT_EQ(drawingOfImage("P5 3 1 65535 " + bytes({254, 254, 205, 205, 0, 0})), ".?#\n");
    EXPECT_EQ(drawingOfImage("P2 4 1 100 100 81 80 0"), "..?#\n");  // 1 - 81/100 < 0.196 < 1 - 80/100
    EXPECT_EQ(drawingOfImage("P5 2 2 255\n" + bytes({0x0a, 0x20, 254, 205})),
              "##\n.?\n");  // pixels like blanks
}

TEST(ImageReader, everyTruncatedImageIsRefused)
{
    const TempFolder folder;
    const auto map = randomMap(40, 30, 3);
    auto interlaced = decodeGreyPng(encodePng8(map));
    interlaced.interlaced = true;
    for (const auto& whole : {encodePng8(map), encodePng(interlaced), encodePgm(map)})
        for (std::size_t length = 3; length < whole.size();
             length += length < 60 || length + 60 > whole.size() ? 1 : 37)
        {
            SCOPED_TRACE(length);
            EXPECT_NE(readErrorOf(folder.write("cut.png", whole.substr(0, length))), "");
        }
    const std::string text = "P2\n3 2\n255\n254 205 0\n100 0 7";
    for (std::size_t length = 2; length + 1 < text.size(); ++length)
        EXPECT_THAT(readErrorOf(folder.write("cut.pgm", text.substr(0, length))), HasSubstr("truncated"))
            << length;
}

TEST(ImageReader, aDamagedPngIsRefused)
{
    const TempFolder folder;
    const std::string whole = encodePng8(randomMap(40, 30, 4));
    for (std::size_t at = 8; at < whole.size(); at += 5) {
        SCOPED_TRACE(at);
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x41);
        EXPECT_NE(readErrorOf(folder.write("damaged.png", damaged)), "");
    }
}

TEST(ImageReader, malformedPgmsAreRefusedWithTheirReason)
{
    const TempFolder folder;
    const auto reason = [&](const std::string& image) { return readErrorOf(folder.write("bad.pgm", image)); };
    EXPECT_THAT(reason("P5\n-3 2\n255\n......"), HasSubstr("the width is not a number"));
    EXPECT_THAT(reason("P5\n3 2.5\n255\n......"), HasSubstr("the height is not a number"));
    EXPECT_THAT(reason("P5\n0 2\n255\n......"), HasSubstr("positive"));
    EXPECT_THAT(reason("P5\n3 2\n0\n......"), HasSubstr("largest grey is 0"));
    EXPECT_THAT(reason("P5\n3 2\n70000\n......"), HasSubstr("65535"));
    EXPECT_THAT(reason("P5\n3 2\n20\nzzzzzz"), HasSubstr("122"));
    EXPECT_THAT(reason("P5\n3 2\n255#......."), HasSubstr("no blank"));
    EXPECT_THAT(reason("P2\n2 1\n255\n7 x "), HasSubstr("not a number"));
    EXPECT_THAT(reason("P2\n2 1\n255\n7 300"), HasSubstr("300"));
    EXPECT_THAT(reason("P2\n2 1\n255\n7 7 7"), HasSubstr("more pixels"));
    EXPECT_THAT(reason("P5\n99999999999999999999 2\n255\n."), HasSubstr("exceeds"));
}

TEST(ImageReader, claimsOfHugeImagesAreRefusedBeforeAllocation)
{
    const TempFolder folder;
    EXPECT_THAT(readErrorOf(folder.write("a.pgm", "P5\n65536 65536\n255\n")), HasSubstr("65536 x 65536"));
    EXPECT_THAT(readErrorOf(folder.write("b.pgm", "P2\n65536 65536\n255\n")), HasSubstr("65536 x 65536"));
    EXPECT_THAT(readErrorOf(folder.write("c.pgm", "P5\n30000 30000\n255\n")), HasSubstr("truncated"));
    EXPECT_THAT(readErrorOf(folder.write("d.pgm", "P2\n30000 30000\n255\n")), HasSubstr("truncated"));
    PngImage image;
    image.width = image.height = 65536;
    EXPECT_THAT(readErrorOf(folder.write("a.png", encodePng(image))), HasSubstr("65536 x 65536"));
    image.width = image.height = 40000;
    EXPECT_THAT(readErrorOf(folder.write("b.png", encodePng(image))), HasSubstr("40000 x 40000"));
    image.interlaced = true;
    EXPECT_THAT(readErrorOf(folder.write("c.png", encodePng({image.width, image.height}))),
                HasSubstr("40000 x 40000"));
    image.width = 2000000;
    image.interlaced = false;
    EXPECT_NE(readErrorOf(folder.write("d.png", encodePng(image))), "");
}

TEST(ImageReader, theLargestGoodClaimOfItsLengthIsRead)
{
    // The bound on a PNG's claim must not refuse the blank image, which deflate packs best.
    const TempFolder folder;
    const ClassifiedGrid blank(3000, 3000, GridFrame{}, CellState::Free);
    EXPECT_EQ(readGrid(folder.write("blank.png", encodePng8(blank)), imageOptions()), blank);
}

TEST(ImageReader, theAnnotatedMapsHaveThreeStates)
{
    const std::filesystem::path file = GR2TO_EVALUATION_DATA "/rose/rose_fr079_map10.clean.png";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "the evaluation data are absent: " << file;
    const auto grid = readGrid(file, imageOptions());
    EXPECT_EQ(grid.width(), 1202);
    EXPECT_EQ(grid.height(), 786);
    EXPECT_EQ(grid.count(CellState::Free), 142570u);  // greys 254, 0 and 205, counted with another program
    EXPECT_EQ(grid.count(CellState::Occupied), 12747u);
    EXPECT_EQ(grid.count(CellState::Unknown), 789455u);
}

TEST(ImageReader, everyEvaluationMapIsUsable)
{
    const std::filesystem::path data = GR2TO_EVALUATION_DATA;
    if (!std::filesystem::exists(data)) GTEST_SKIP() << "the evaluation data are absent: " << data;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data)) {
        const auto& file = entry.path();
        if (file.extension() != ".png" && file.extension() != ".pgm") continue;
        if (file.string().find("labels") != std::string::npos) continue;
        EXPECT_NO_THROW(requireUsable(readGrid(file, imageOptions()), file.string())) << file;
    }
}
