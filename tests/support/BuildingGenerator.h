#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/PlaceImage.h"
#include "support/building/BuildingOptions.h"

namespace gr2to::test
{
/** A room or corridor as it was built: exact, whatever the cells say. Map frame, metres. */
struct BuildingRoom
{
    PlaceId id = 0;
    bool corridor = false;
    std::vector<Eigen::Vector2d> polygon;  //!< faces of its walls, counter-clockwise, without doorways
    Eigen::Vector2d inner;                 //!< a point well inside
    double area_m2 = 0;                    //!< of the polygon
};

struct BuildingDoor
{
    Eigen::Vector2d centre;  //!< in the middle of the wall
    double width_m = 0;      //!< clear
    double thickness_m = 0;  //!< of the wall
    double angle_rad = 0;    //!< direction of passage from `a` to `b`
    PlaceId a = 0, b = 0;
    bool closed = false;
};

/** One side of a wall, seen from its room, whole where a door interrupts it. */
struct BuildingWall
{
    PlaceId room = 0;
    PlaceId behind = 0;        //!< the room on the other side; 0 is the outside
    Eigen::Vector2d from, to;  //!< on the wall's face, the room to the left
    double thickness_m = 0;
};

/** A grid and the truth about it. */
struct Building
{
    ClassifiedGrid grid;
    PlaceImage labels;                //!< room of every free cell; half of a doorway belongs to either room
    std::vector<BuildingRoom> rooms;  //!< ids 1, 2, ... in this order
    std::vector<BuildingDoor> doors;
    std::vector<BuildingWall> walls;
};

/** Builds rooms along corridors from a seed and samples them at the centres of cells.
 *
 * The geometry does not depend on the resolution, and the map frame's origin is the grid's bottom-left
 * corner, so two resolutions show the same building in the same place. Equal options give equal results on
 * every platform. \throws std::invalid_argument  an option is out of range, or options contradict one another
 * Cost: linear in cells and rooms.
 */
Building generateBuilding(const TBuildingOptions& options);

/** The annotation as JSON: the structure of the evaluation data's `*.gt.json`, with metric keys added. */
std::string annotationJson(const Building& building, const std::string& name);
/** A map_server description of an image with 254 free, 205 unknown, 0 occupied. */
std::string mapServerYaml(const ClassifiedGrid& grid, const std::string& imageFile);
}  // namespace gr2to::test
