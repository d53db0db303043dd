#include "support/building/BuildingOptions.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "gr2to/grid/ClassifiedGrid.h"
#include "support/building/FloorPlan.h"

namespace gr2to::test
{
namespace
{
/** Walls thinner than this many cells leak through the corners of cells once they are turned. */
constexpr double kThinnestWall_cells = 1.5;
/** Sums of decimal lengths are off by less [m]. */
constexpr double kRounding_m = 1e-9;

void require(bool holds, const std::string& name, double value, const std::string& rule)
{
    if (holds) return;
    std::ostringstream text;
    text << "building." << name << " = " << value << " m " << rule;
    throw std::invalid_argument(text.str());
}

std::string metres(double value)
{
    std::ostringstream text;
    text << value << " m";
    return text.str();
}
}  // namespace

std::vector<OptionField> TBuildingOptions::fields()
{
    return {
        {"seed", &seed, "", "Number that the whole building follows from.", 0, 2147483647},
        {"layout",
         &layout,
         "",
         "Course of the corridor.",
         0,
         0,
         {"auto", "straight", "l", "t", "cross", "ring"}},
        {"resolution", &resolution, "m", "Side of a cell.", 0.005, 1},
        {"width", &width, "m", "Length of a tile along x, before rotation.", 4, 1000},
        {"height", &height, "m", "Length of a tile along y, before rotation.", 4, 1000},
        {"tiles_x", &tiles_x, "", "Tiles side by side, each a floor plan of its own joined to the next.", 1,
         200},
        {"tiles_y", &tiles_y, "", "Rows of tiles.", 1, 200},
        {"corridor_width", &corridor_width, "m", "Clear width of corridors.", 0.8, 20},
        {"room_min_size", &room_min_size, "m", "Least distance between the centre lines of a room's walls.",
         1, 50},
        {"room_max_size", &room_max_size, "m", "Greatest usual distance between a room's opposite walls.", 1,
         100},
        {"door_min_width", &door_min_width, "m", "Narrowest clear width of a door.", 0.3, 5},
        {"door_max_width", &door_max_width, "m", "Widest clear width of a single-leaf door.", 0.3, 5},
        {"double_doors", &double_doors, "ratio", "Share of doors that are half as wide again.", 0, 1},
        {"suites", &suites, "ratio", "Share of rooms reached through a neighbour where one exists.", 0, 1},
        {"extra_doors", &extra_doors, "ratio", "Share of walls with a door more than needed.", 0, 1},
        {"closed_doors", &closed_doors, "ratio", "Share of doors that are shut, hence occupied.", 0, 1},
        {"wall_thickness", &wall_thickness, "m", "Thickness of walls between rooms.", 0.02, 1},
        {"outer_wall_thickness", &outer_wall_thickness, "m", "Thickness of walls to the outside.", 0.02, 2},
        {"furniture", &furniture, "ratio", "Share of the floor that furniture is to stand on.", 0, 0.5},
        {"noise", &noise, "ratio", "Share of cells on the edge of walls and furniture that flip.", 0, 0.5},
        {"speckle", &speckle, "ratio", "Share of the other free cells that are wrongly occupied.", 0, 0.5},
        {"wall_jitter", &wall_jitter, "ratio", "Share of half-metre pieces displaced by one cell.", 0, 1},
        {"rotation", &rotation, "deg", "Counter-clockwise turn of the building in the map.", -360, 360},
        {"margin", &margin, "m", "Unknown surroundings.", 0, 100},
    };
}

void TBuildingOptions::checkRules() const
{
    const double corridor = corridor_width + wall_thickness;
    const double doorSpace = door_max_width + wall_thickness + 2 * kJamb_m;
    require(door_min_width <= door_max_width, "door_min_width", door_min_width,
            "must not exceed door_max_width = " + metres(door_max_width));
    require(room_min_size <= room_max_size, "room_min_size", room_min_size,
            "must not exceed room_max_size = " + metres(room_max_size));
    require(room_min_size >= doorSpace - kRounding_m, "room_min_size", room_min_size,
            "leaves no wall for a door; it must be at least " + metres(doorSpace));
    require(corridor_width >= door_max_width + 2 * kJamb_m - kRounding_m, "corridor_width", corridor_width,
            "must be at least " + metres(door_max_width + 2 * kJamb_m) + ", the widest door and its jambs");
    require(wall_thickness >= kThinnestWall_cells * resolution - kRounding_m, "wall_thickness",
            wall_thickness,
            "must be at least 1.5 cells of " + metres(resolution) + ", or walls leak when they are turned");
    require(outer_wall_thickness >= wall_thickness, "outer_wall_thickness", outer_wall_thickness,
            "must be at least wall_thickness = " + metres(wall_thickness));

    const double shorter = std::min(width, height);
    const double needed = layout == "ring" ? 2 * corridor + 3 * room_min_size : corridor + 2 * room_min_size;
    require(shorter >= needed - kRounding_m, width < height ? "width" : "height", shorter,
            "is too small for the corridor with rooms on both sides; it must be at least " + metres(needed));
    // A turned building fits the square of its diagonal.
    const double diagonal = std::hypot(width * tiles_x + 2 * margin, height * tiles_y + 2 * margin);
    require(diagonal / resolution < ClassifiedGrid::maxSide(), "resolution", resolution,
            "gives too many cells for this size; use a coarser one or fewer tiles");
}
}  // namespace gr2to::test
