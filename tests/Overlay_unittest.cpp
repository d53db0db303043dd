#include "gr2to/view/Overlay.h"

#include <gmock/gmock.h>

#include <pugixml.hpp>

#include "gr2to/base/errors.h"
#include "gr2to/view/Palette.h"
#include "support/mapPicture.h"
#include "support/twoRooms.h"

namespace
{
using namespace gr2to;
using test::bare;
using test::decodePng;
using test::MapPicture;
using test::Picture;
using test::TwoRooms;

int dashedPaths(const std::string& svg)
{
    pugi::xml_document document;
    EXPECT_TRUE(document.load_buffer(svg.data(), svg.size()));
    return static_cast<int>(
        document.select_nodes("//*[local-name()='path'][contains(@style,'dasharray')]").size());
}
}  // namespace

TEST(Overlay, sameInputSameBytes)
{
    const TwoRooms rooms;
    EXPECT_EQ(renderOverlayPng(rooms.input()), renderOverlayPng(rooms.input()));
    EXPECT_EQ(renderOverlaySvg(rooms.input()), renderOverlaySvg(rooms.input()));
}

TEST(Overlay, smallGridsAreEnlargedByAWholeFactorAndTheLegendLiesBelow)
{
    const TwoRooms rooms;  // 41 x 21 cells
    const Picture map = decodePng(renderOverlayPng(rooms.input(), bare()));
    EXPECT_EQ(map.width, 41 * 25);
    EXPECT_EQ(map.height, 21 * 25);
    const Picture full = decodePng(renderOverlayPng(rooms.input()));
    EXPECT_EQ(full.width, map.width);
    EXPECT_GT(full.height, map.height + 20);
    EXPECT_TRUE(std::equal(map.pixels.begin(), map.pixels.end(), full.pixels.begin()));
}

TEST(Overlay, cellsShowTheirPlaceOrState)
{
    TwoRooms rooms;
    rooms.grid.set({6, 4}, CellState::Occupied);  // taken away by the filter: still of a place
    const MapPicture picture(rooms.input(), bare());
    EXPECT_EQ(picture.at(6, 4), palette::removed);
    EXPECT_EQ(picture.at(4, 4), placeColor(1));
    EXPECT_EQ(picture.at(36, 17), placeColor(2));
    EXPECT_EQ(picture.at(20, 4), palette::occupied);
    EXPECT_EQ(picture.at(40, 20), palette::unknown);
}

TEST(Overlay, anIdHasTheSameColourOnEveryMap)
{
    const TwoRooms rooms;
    PlaceImage swapped = rooms.places;
    for (auto& id : swapped.ids) id = id == 1 ? PlaceId{2} : id == 2 ? PlaceId{1} : PlaceId{0};
    const TopologicalMap none;
    const OverlayInput other{rooms.grid, swapped, rooms.voronoi, rooms.criticalPoints, none};
    EXPECT_EQ(MapPicture(other, bare()).at(4, 4), MapPicture(rooms.input(), bare()).at(36, 17));
    EXPECT_EQ(MapPicture(other, bare()).at(36, 17), MapPicture(rooms.input(), bare()).at(4, 4));
}

TEST(Overlay, everySwitchChangesThePicture)
{
    TwoRooms rooms;
    rooms.grid.set({6, 4}, CellState::Occupied);  // what "removed" shows
    const std::string png = renderOverlayPng(rooms.input()), svg = renderOverlaySvg(rooms.input());
    for (const char* layer : {"grid", "removed", "places", "ids", "voronoi", "critical_points", "doors",
                              "walls", "connections", "legend", "scale_bar"})
    {
        TOverlayOptions options;
        options.set(layer, "no");
        EXPECT_NE(renderOverlayPng(rooms.input(), options), png) << layer;
        EXPECT_NE(renderOverlaySvg(rooms.input(), options), svg) << layer;
    }
}

TEST(Overlay, realWallsAreSolidAndVirtualOnesDashed)
{
    const TwoRooms rooms;  // real: y = 0 under room 1; virtual: x = 20 beside it
    auto options = bare();
    options.doors = options.connections = false;
    const MapPicture picture(rooms.input(), options);
    EXPECT_EQ(picture.countOn(1.1, 0, 18.9, 0, palette::ink), 200);
    const int dashes = picture.countOn(30, 2, 30, 9, palette::ink);
    EXPECT_GT(dashes, 40);
    EXPECT_LT(dashes, 160);
}

TEST(Overlay, voronoiCellsCriticalPointsAndVerticesAreMarked)
{
    const TwoRooms rooms;
    auto options = bare();
    options.doors = options.ids = false;
    const MapPicture picture(rooms.input(), options);
    EXPECT_EQ(picture.at(20, 10), palette::criticalPoint);
    EXPECT_EQ(picture.at(10, 10), palette::vertex);
    options.connections = false;
    EXPECT_EQ(MapPicture(rooms.input(), options).at(15, 10), palette::voronoi);
}

TEST(Overlay, corridorsAreHatched)
{
    TwoRooms rooms;
    rooms.map.place(2).kind = PlaceKind::Corridor;
    const MapPicture picture(rooms.input(), bare());
    const int plain = picture.countOn(32, 17.5, 38, 17.5, placeColor(2));
    EXPECT_GT(plain, 80);
    EXPECT_LT(plain, 190);
    EXPECT_EQ(picture.countOn(3, 17.5, 9, 17.5, placeColor(1)), 200);
}

TEST(Overlay, thePictureDoesNotDependOnWhereTheFrameLies)
{
    const TwoRooms straight, turned(GridFrame{0.1, 7.0, -3.0, 0.6});
    const Picture a = decodePng(renderOverlayPng(straight.input()));
    const Picture b = decodePng(renderOverlayPng(turned.input()));
    ASSERT_EQ(a.pixels.size(), b.pixels.size());
    std::size_t different = 0;  // rounding may shade the rim of a line otherwise
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        different += std::abs(a.pixels[i].green - b.pixels[i].green) > 16 ? 1U : 0U;
    EXPECT_LT(different, a.pixels.size() / 10000);
}

TEST(Overlay, scaleBarIsAsLongAsItSays)
{
    const TwoRooms rooms;  // 0.1 m cells of 25 px: 0.2 m is the longest step below 100 px
    TOverlayOptions options;
    options.legend = false;
    const Picture picture = decodePng(renderOverlayPng(rooms.input(), options));
    int longest = 0;
    for (int y = 21 * 25; y < picture.height; ++y)
        for (int x = 0, run = 0; x < picture.width; ++x) {
            run = picture.at(x, y) == palette::ink ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    EXPECT_NEAR(longest, 50, 3);
}

TEST(Overlay, svgIsWellFormedAndDashesOnlyWhatIsVirtual)
{
    const TwoRooms rooms;
    EXPECT_EQ(dashedPaths(renderOverlaySvg(rooms.input(), bare())), 2);  // one wall, one opening
    auto options = bare();
    options.walls = false;
    EXPECT_EQ(dashedPaths(renderOverlaySvg(rooms.input(), options)), 1);
    options.doors = false;
    const std::string svg = renderOverlaySvg(rooms.input(), options);
    EXPECT_EQ(dashedPaths(svg), 0);
    pugi::xml_document document;
    ASSERT_TRUE(document.load_buffer(svg.data(), svg.size()));
    EXPECT_STREQ(document.child("svg").attribute("viewBox").value(), "0 0 1025 525");
    EXPECT_TRUE(document.select_node("//*[local-name()='image']"));
}

TEST(Overlay, unknownSurroundingsAreCroppedUnlessAskedFor)
{
    ClassifiedGrid grid(1000, 800, GridFrame{}, CellState::Unknown);
    for (int y = 300; y < 400; ++y)
        for (int x = 500; x < 700; ++x) grid.set({x, y}, CellState::Free);
    const OverlayInput input{grid, {}, {}, {}, {}};
    auto options = bare();
    const Picture cropped = decodePng(renderOverlayPng(input, options));
    EXPECT_EQ(cropped.width, (200 + 2 * 4) * 5);
    EXPECT_EQ(cropped.height, (100 + 2 * 4) * 5);
    EXPECT_EQ(cropped.at(19, 50), palette::unknown);
    EXPECT_EQ(cropped.at(21, 50), palette::free);
    options.crop = false;
    const Picture whole = decodePng(renderOverlayPng(input, options));
    EXPECT_EQ(whole.width, 1000);
    EXPECT_EQ(whole.at(600, 799 - 350), palette::free);
    EXPECT_EQ(whole.at(600, 350), palette::unknown);
}

TEST(Overlay, hugeGridsAreReducedAndThinWallsSurvive)
{
    ClassifiedGrid grid(7001, 5000, GridFrame{}, CellState::Free);
    PlaceImage places(7001, 5000);
    for (int y = 0; y < 5000; ++y)
        for (int x = 0; x < 7001; ++x) {
            if (x == 3334) grid.set({x, y}, CellState::Occupied);
            if (x != 3334) places.ids[places.index({x, y})] = x < 3334 ? PlaceId{1} : PlaceId{2};
        }
    const OverlayInput input{grid, places, {}, {}, {}};
    const Picture picture = decodePng(renderOverlayPng(input, bare()));  // three cells a pixel
    EXPECT_EQ(picture.width, 2334);
    EXPECT_EQ(picture.height, 1667);
    EXPECT_EQ(picture.at(1110, 800), placeColor(1));
    EXPECT_EQ(picture.at(1111, 800), palette::occupied);
    EXPECT_EQ(picture.at(1112, 800), placeColor(2));
}

TEST(Overlay, emptyMapsAndTinyGridsAreDrawn)
{
    for (const auto state : {CellState::Free, CellState::Occupied, CellState::Unknown}) {
        const ClassifiedGrid cell(1, 1, GridFrame{}, state), column(1, 30000, GridFrame{}, state);
        const OverlayInput one{cell, {}, {}, {}, {}}, thin{column, {}, {}, {}, {}};
        EXPECT_EQ(decodePng(renderOverlayPng(one, bare())).width, 1000);
        EXPECT_EQ(decodePng(renderOverlayPng(thin, bare())).height, 2308);
        EXPECT_GT(decodePng(renderOverlayPng(thin)).width, 100) << "no room for the legend";
        EXPECT_EQ(dashedPaths(renderOverlaySvg(thin, bare())), 0);
    }
}

TEST(Overlay, badInputIsRefused)
{
    const TwoRooms rooms;
    const ClassifiedGrid nothing;
    EXPECT_THROW(renderOverlayPng({nothing, {}, {}, {}, {}}), InputError);
    const PlaceImage other(3, 3);
    EXPECT_THROW(renderOverlayPng({rooms.grid, other, {}, {}, {}}), std::invalid_argument);
    TOverlayOptions options;
    options.min_side = 3000;
    EXPECT_THROW(renderOverlaySvg(rooms.input(), options), std::invalid_argument);
    options = {};
    options.door_width = -1;
    EXPECT_THROW(renderOverlayPng(rooms.input(), options), std::invalid_argument);
}
