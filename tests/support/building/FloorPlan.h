#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "support/building/BuildingOptions.h"
#include "support/building/SeededRandom.h"

namespace gr2to::test
{
/** Least length of wall between a door and the next corner of its rooms [m]. */
constexpr double kJamb_m = 0.1;

/** Axis-parallel rectangle in the building's own frame [m]. */
struct Rect
{
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    double width() const { return x1 - x0; }
    double height() const { return y1 - y0; }
    double area() const { return width() * height(); }
    Rect grown(double by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
    bool overlaps(const Rect& o) const { return x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1; }
    bool inside(const Rect& o) const { return x0 >= o.x0 && y0 >= o.y0 && x1 <= o.x1 && y1 <= o.y1; }
};

struct PlanRoom
{
    bool corridor = false;
    std::vector<Rect> parts;                    //!< between the centre lines of walls; they tile the building
    std::vector<Rect> floor = {};               //!< between the faces of walls, disjoint
    std::vector<Eigen::Vector2d> outline = {};  //!< of the floor, counter-clockwise
    std::size_t tile = 0;
    double area() const;
};

/** A stretch of wall between two rooms: `low` lies at smaller x (vertical wall) or y, `high` beyond. */
struct Boundary
{
    std::size_t low = 0, high = 0;
    bool vertical = false;
    double line = 0;          //!< x of a vertical wall's centre line, y of a horizontal one's
    double from = 0, to = 0;  //!< extent along the wall, between the centre lines of the adjoining walls
};

struct PlanDoor
{
    Boundary wall;
    double along = 0;  //!< centre, along the wall
    double width = 0;
    bool closed = false;
    Eigen::Vector2d centre() const
    {
        return wall.vertical ? Eigen::Vector2d(wall.line, along) : Eigen::Vector2d(along, wall.line);
    }
};

/** One side of a wall, as seen from a room. */
struct PlanWall
{
    std::size_t room = 0;
    long behind = -1;          //!< the room behind it, -1 is the outside
    Eigen::Vector2d from, to;  //!< the room lies to the left
    double thickness = 0;
};

struct FloorPlan
{
    std::vector<PlanRoom> rooms;
    std::vector<PlanDoor> doors;
    std::vector<PlanWall> walls;
    std::vector<Rect> furniture;  //!< solid pieces, table and chair legs one by one
};

/** Rooms of one tile, their parts only. \param closed  whether gaps between wings become rooms, not yards */
std::vector<PlanRoom> layOutTile(const TBuildingOptions& options, const Rect& tile, bool closed,
                                 SeededRandom random);
/** Gives the rooms their floors and outlines. */
void constructFloors(std::vector<PlanRoom>& rooms, double wallThickness);
/** Stretches of wall between different rooms; rooms are in the order of their tiles. Linear in the number of
 * tiles. */
std::vector<Boundary> findBoundaries(const std::vector<PlanRoom>& rooms, const TBuildingOptions& options);
/** Doors that make every room reachable, and some more; rooms that no door can reach are taken out of the
 * plan. */
void placeDoors(FloorPlan& plan, const std::vector<Boundary>& boundaries, const TBuildingOptions& options);
/** The sides of walls, cut where the room behind changes. */
void findWalls(FloorPlan& plan, const TBuildingOptions& options);
/** Pieces that leave every door and every part of a room reachable. */
void furnish(FloorPlan& plan, const TBuildingOptions& options);
/** All of the above. */
FloorPlan makeFloorPlan(const TBuildingOptions& options);
}  // namespace gr2to::test
