#include "support/someTopologicalMap.h"

namespace gr2to::test
{
namespace
{
View someView()
{
    View view;
    view.image = "views/3_0.png";
    view.apertureX_rad = 1;
    return view;
}
}  // namespace

Place somePlace(PlaceId id)
{
    Place place;
    place.id = id;
    place.area_m2 = 12;
    place.words = {"office"};
    place.boundary = {{0, 0}, {4, 0}, {4, 3}};
    for (std::uint32_t i = 0; i < 2; ++i) {
        Wall wall;
        wall.id = 10U * id + i;
        wall.size.length_m = 4;
        wall.size.height_m = 2.5;
        place.walls.push_back(wall);
    }
    place.views = {someView()};
    return place;
}

Connection someConnection(std::uint32_t id, PlaceId from, PlaceId to)
{
    Connection connection;
    connection.id = id;
    connection.from = from;
    connection.to = to;
    connection.words = {"blue door"};
    connection.doorway.size.length_m = 0.9;
    connection.doorway.view = someView();
    return connection;
}

TopologicalMap someMap(const std::function<void(Connection&)>& change)
{
    TopologicalMap map;
    map.resolution_m = 0.05;
    for (const PlaceId id : {PlaceId{5}, PlaceId{1}, PlaceId{3}}) map.addPlace(somePlace(id));
    Connection connection = someConnection(7, 3, 5);
    change(connection);
    map.addConnection(connection);
    return map;
}
}  // namespace gr2to::test
