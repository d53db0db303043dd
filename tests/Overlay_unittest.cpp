#include "gr2to/view/Overlay.h"

#include <gmock/gmock.h>

#include <pugixml.hpp>

#include "gr2to/base/errors.h"
#include "gr2to/view/Palette.h"
#include "support/picture.h"
#include "support/twoRooms.h"

namespace
{
using namespace gr2to;
using test::decodePng;
using test::Picture;
using test::TwoRooms;

TOverlayOptions bare()
{
    TOverlayOptions options;
    options.legend = options.scale_bar = false;
    return options;
}

/** Reads a picture without a strip by cells; fractions of a cell are allowed. */
class MapPicture
{
 public:
    MapPicture(const OverlayInput& input, const TOverlayOptions& options)
        : m_picture(decodePng(renderOverlayPng(input, options))),
          m_rows(input.grid.height()),
          m_scale(static_cast<double>(m_picture.width) / input.grid.width())
    {
    }
    const Picture& picture() const { return m_picture; }
    Rgb at(double x, double y) const
    {
        return m_picture.at(static_cast<int>((x + 0.5) * m_scale),
                            static_cast<int>((m_rows - 0.5 - y) * m_scale));
    }
    /** How many of 200 pixels on the straight line between two cells have the colour. */
    int countOn(double x0, double y0, double x1, double y1, Rgb color) const
    {
        int hits = 0;
        for (int i = 0; i < 200; ++i)
            hits += at(x0 + (x1 - x0) * i / 199.0, y0 + (y1 - y0) * i / 199.0) == color ? 1 : 0;
        return hits;
    }

 private:
    Picture m_picture;
    int m_rows;
    double m_scale;
};

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

TEST(Overlay, aRealDoorSpansItsGapAndNothingElse)
{
    const TwoRooms rooms;  // the gap is x = 20, y = 8 ... 12
    const MapPicture picture(rooms.input(), bare());
    for (const double y : {7.7, 9.0, 11.0, 12.3}) EXPECT_EQ(picture.at(20, y), palette::door) << y;
    for (const double y : {6.5, 13.5}) EXPECT_NE(picture.at(20, y), palette::door) << y;
    for (const double x : {18.5, 21.5}) EXPECT_NE(picture.at(x, 9), palette::door) << x;
}

TEST(Overlay, aDoorWhoseCentreIsBesideAThinWallStillLiesAlongIt)
{
    TwoRooms rooms;
    rooms.moveDoor(19, 10);
    const MapPicture picture(rooms.input(), bare());
    for (const double y : {8.0, 10.0, 12.0}) EXPECT_EQ(picture.at(19, y), palette::door) << y;
}

TEST(Overlay, aDoorwayInTheOpenIsSquareToItsConnection)
{
    TwoRooms rooms;
    for (std::size_t i = 0; i < rooms.grid.size(); ++i) rooms.grid[i] = CellState::Free;
    const MapPicture picture(rooms.input(), bare());  // the connection rises by 2 cells in 20
    for (const double dy : {-2.0, -1.0, 1.0, 2.0})
        EXPECT_EQ(picture.at(20 - dy / 10, 10 + dy), palette::door) << dy;
}

TEST(Overlay, aVirtualOpeningIsDashed)
{
    const TwoRooms rooms;  // the opening is x = 20, y = 15 ... 18
    auto options = bare();
    options.connections = false;
    const int blue = MapPicture(rooms.input(), options).countOn(20, 14.7, 20, 18.3, palette::door);
    EXPECT_GT(blue, 60);
    EXPECT_LT(blue, 160);
}

TEST(Overlay, anOpeningInTheOpenLiesWhereItsPlacesTouch)
{
    TwoRooms rooms;
    for (std::size_t i = 0; i < rooms.grid.size(); ++i) rooms.grid[i] = CellState::Free;
    for (int y = 0; y < 21; ++y)  // the places touch along x + y = 30.5, the connection rises by 2 in 20
        for (int x = 0; x < 41; ++x)
            rooms.places.ids[rooms.places.index({x, y})] = x + y <= 30 ? PlaceId{1} : PlaceId{2};
    Connection opening;
    opening.id = 3;
    opening.from = 1;
    opening.to = 2;
    const Eigen::Vector2d middle = rooms.grid.frame().toMap(20.25, 10.25);
    opening.doorway.position.mean = {middle.x(), middle.y(), 0};
    opening.doorway.size.length_m = 1.2;
    rooms.map.addConnection(opening);
    auto options = bare();
    options.connections = options.critical_points = options.voronoi = false;
    const MapPicture picture(rooms.input(), options);
    EXPECT_GT(picture.countOn(16.5, 14, 24, 6.5, palette::door), 60);
    EXPECT_LT(picture.countOn(20.25, 14, 20.25, 6.5, palette::door), 40);
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
