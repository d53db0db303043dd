#include "support/buildingMeasures.h"

#include <cmath>

namespace gr2to::test
{
TBuildingOptions buildingOptions(int seed, double rotation_deg, double furniture)
{
    TBuildingOptions o;
    o.seed = seed;
    o.rotation = rotation_deg;
    o.furniture = furniture;
    return o;
}

std::vector<TBuildingOptions> variousBuildings()
{
    std::vector<TBuildingOptions> all;
    int seed = 100;
    for (const char* layout : {"straight", "l", "t", "cross", "ring"})
        for (const double rotation : {0.0, 27.0, 90.0}) {
            auto o = buildingOptions(++seed, rotation, rotation == 0.0 ? 0.0 : 0.15);
            o.layout = layout;
            o.height = 24;
            all.push_back(o);
        }
    return all;
}

std::string nameOf(const TBuildingOptions& o)
{
    return "seed " + std::to_string(o.seed) + ", " + o.layout + ", " + std::to_string(o.rotation) + " deg";
}

Cell cellAt(const ClassifiedGrid& grid, const Eigen::Vector2d& p)
{
    const auto c = grid.frame().toGrid(p.x(), p.y());
    return {static_cast<int>(std::lround(c.x())), static_cast<int>(std::lround(c.y()))};
}

Eigen::Vector2d passage(const BuildingDoor& door)
{
    return {std::cos(door.angle_rad), std::sin(door.angle_rad)};
}
Eigen::Vector2d across(const BuildingDoor& door)
{
    return {-std::sin(door.angle_rad), std::cos(door.angle_rad)};
}

double freeRun(const ClassifiedGrid& grid, const BuildingDoor& door)
{
    const double step = grid.resolution_m() / 10;
    double length = step;
    for (const double sign : {1.0, -1.0})
        for (int i = 1; grid.isFree(cellAt(grid, door.centre + sign * i * step * across(door))); ++i)
            length += step;
    return length;
}

Components freeComponents(const ClassifiedGrid& grid, const std::vector<bool>& shut)
{
    Components result;
    auto& number = result.numbers;
    number.assign(grid.size(), 0);
    const auto enter = [&](Cell c) {
        if (!grid.isFree(c)) return false;
        const auto i = grid.index(c);
        if (number[i] != 0 || (!shut.empty() && shut[i])) return false;
        number[i] = result.count;
        return true;
    };
    for (std::size_t seed = 0; seed < grid.size(); ++seed) {
        ++result.count;
        std::vector<Cell> open;
        if (enter(grid.cell(seed)))
            open.push_back(grid.cell(seed));
        else
            --result.count;
        while (!open.empty()) {
            const Cell c = open.back();
            open.pop_back();
            for (const Cell n :
                 {Cell{c.x + 1, c.y}, Cell{c.x - 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x, c.y - 1}})
                if (enter(n)) open.push_back(n);
        }
    }
    return result;
}

/** The cells of all doorways by the annotation: the opening in the thickness of its wall, half a cell more
 * around. */
std::vector<bool> doorwayCells(const Building& b)
{
    std::vector<bool> shut(b.grid.size(), false);
    const double res = b.grid.resolution_m();
    for (const auto& door : b.doors) {
        const int reach = static_cast<int>((door.width_m + door.thickness_m) / res) + 2;
        const Cell centre = cellAt(b.grid, door.centre);
        for (int y = centre.y - reach; y <= centre.y + reach; ++y)
            for (int x = centre.x - reach; x <= centre.x + reach; ++x) {
                if (!b.grid.contains({x, y})) continue;
                const Eigen::Vector2d d = b.grid.frame().toMap(x, y) - door.centre;
                if (std::abs(d.dot(across(door))) <= door.width_m / 2 + res / 2 &&
                    std::abs(d.dot(passage(door))) <= door.thickness_m / 2 + res / 2)
                    shut[b.grid.index({x, y})] = true;
            }
    }
    return shut;
}

}  // namespace gr2to::test
