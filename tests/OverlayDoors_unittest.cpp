#include <gtest/gtest.h>

#include "gr2to/view/Overlay.h"
#include "gr2to/view/Palette.h"
#include "support/mapPicture.h"
#include "support/twoRooms.h"

namespace
{
using namespace gr2to;
using test::bare;
using test::MapPicture;
using test::TwoRooms;
}  // namespace

TEST(OverlayDoors, aRealDoorSpansItsGapAndNothingElse)
{
    const TwoRooms rooms;  // the gap is x = 20, y = 8 ... 12
    const MapPicture picture(rooms.input(), bare());
    for (const double y : {7.7, 9.0, 11.0, 12.3}) EXPECT_EQ(picture.at(20, y), palette::door) << y;
    for (const double y : {6.5, 13.5}) EXPECT_NE(picture.at(20, y), palette::door) << y;
    for (const double x : {18.5, 21.5}) EXPECT_NE(picture.at(x, 9), palette::door) << x;
}

TEST(OverlayDoors, aDoorWhoseCentreIsBesideAThinWallStillLiesAlongIt)
{
    TwoRooms rooms;
    rooms.moveDoor(19, 10);
    const MapPicture picture(rooms.input(), bare());
    for (const double y : {8.0, 10.0, 12.0}) EXPECT_EQ(picture.at(19, y), palette::door) << y;
}

TEST(OverlayDoors, aDoorwayInTheOpenIsSquareToItsConnection)
{
    TwoRooms rooms;
    for (std::size_t i = 0; i < rooms.grid.size(); ++i) rooms.grid[i] = CellState::Free;
    const MapPicture picture(rooms.input(), bare());  // the connection rises by 2 cells in 20
    for (const double dy : {-2.0, -1.0, 1.0, 2.0})
        EXPECT_EQ(picture.at(20 - dy / 10, 10 + dy), palette::door) << dy;
}

TEST(OverlayDoors, aVirtualOpeningIsDashed)
{
    const TwoRooms rooms;  // the opening is x = 20, y = 15 ... 18
    auto options = bare();
    options.connections = false;
    const int blue = MapPicture(rooms.input(), options).countOn(20, 14.7, 20, 18.3, palette::door);
    EXPECT_GT(blue, 60);
    EXPECT_LT(blue, 160);
}

TEST(OverlayDoors, anOpeningInTheOpenLiesWhereItsPlacesTouch)
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
