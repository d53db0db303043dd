#include "support/BuildingGenerator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/building/Rasteriser.h"

namespace gr2to::test
{
namespace
{
BuildingRoom annotated(const PlanRoom& room, std::size_t index, const BuildingPose& pose)
{
    BuildingRoom result;
    result.id = static_cast<PlaceId>(index + 1);
    result.corridor = room.corridor;
    result.area_m2 = room.area();
    for (const auto& p : room.outline) result.polygon.push_back(pose.toMap(p));
    const auto& largest = *std::max_element(room.floor.begin(), room.floor.end(),
                                            [](const Rect& a, const Rect& b) { return a.area() < b.area(); });
    result.inner = pose.toMap({(largest.x0 + largest.x1) / 2, (largest.y0 + largest.y1) / 2});
    return result;
}

BuildingDoor annotated(const PlanDoor& door, double thickness, const BuildingPose& pose)
{
    const Eigen::Vector2d across =
        pose.turned(door.wall.vertical ? Eigen::Vector2d(1, 0) : Eigen::Vector2d(0, 1));
    BuildingDoor result;
    result.centre = pose.toMap(door.centre());
    result.width_m = door.width;
    result.thickness_m = thickness;
    const bool swapped = door.wall.low > door.wall.high;
    const Eigen::Vector2d passage = swapped ? Eigen::Vector2d(-across) : across;
    result.angle_rad = std::atan2(passage.y(), passage.x());
    result.a = static_cast<PlaceId>(std::min(door.wall.low, door.wall.high) + 1);
    result.b = static_cast<PlaceId>(std::max(door.wall.low, door.wall.high) + 1);
    result.closed = door.closed;
    return result;
}
}  // namespace

FloorPlan makeFloorPlan(const TBuildingOptions& options)
{
    FloorPlan plan;
    const bool single = options.tiles_x == 1 && options.tiles_y == 1;
    for (int row = 0; row < options.tiles_y; ++row)
        for (int column = 0; column < options.tiles_x; ++column) {
            const auto tile = static_cast<std::size_t>(row) * static_cast<std::size_t>(options.tiles_x) +
                              static_cast<std::size_t>(column);
            const Rect area{column * options.width, row * options.height, (column + 1) * options.width,
                            (row + 1) * options.height};
            for (auto& room :
                 layOutTile(options, area, !single, {options.seed, SeededRandom::Purpose::Layout, tile})) {
                room.tile = tile;
                plan.rooms.push_back(std::move(room));
            }
        }
    constructFloors(plan.rooms, options.wall_thickness);
    placeDoors(plan, findBoundaries(plan.rooms, options), options);
    if (plan.rooms.size() > std::numeric_limits<PlaceId>::max())
        throw std::invalid_argument("building.tiles_x, tiles_y: the building has " +
                                    std::to_string(plan.rooms.size()) +
                                    " rooms, at most 65535 can be numbered; use fewer tiles or larger rooms");
    findWalls(plan, options);
    furnish(plan, options);
    return plan;
}

Building generateBuilding(const TBuildingOptions& options)
{
    options.check();
    const FloorPlan plan = makeFloorPlan(options);
    const BuildingPose pose(plan, options);
    RasterisedPlan raster = rasterise(plan, pose, options);
    degrade(raster, options);

    Building building;
    building.grid = std::move(raster.grid);
    building.labels = std::move(raster.labels);
    for (std::size_t i = 0; i < plan.rooms.size(); ++i)
        building.rooms.push_back(annotated(plan.rooms[i], i, pose));
    for (const auto& door : plan.doors)
        building.doors.push_back(annotated(door, options.wall_thickness, pose));
    for (const auto& wall : plan.walls)
        building.walls.push_back({static_cast<PlaceId>(wall.room + 1), static_cast<PlaceId>(wall.behind + 1),
                                  pose.toMap(wall.from), pose.toMap(wall.to), wall.thickness});
    return building;
}
}  // namespace gr2to::test
