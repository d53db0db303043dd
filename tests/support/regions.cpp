#include "support/regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "support/buildingMeasures.h"

namespace gr2to::test
{
namespace
{
std::string text(double value)
{
    return std::to_string(value);
}

std::string at(Cell c)
{
    return "(" + std::to_string(c.x) + ", " + std::to_string(c.y) + ")";
}

/** For each region of `a` the one of `b` that holds most of its cells. */
std::vector<std::size_t> counterparts(const DoorTopology& a, const DoorTopology& b,
                                      const std::function<Cell(Cell)>& move)
{
    std::vector<std::map<std::size_t, std::size_t>> shared(a.regions.size());
    for (std::size_t i = 0; i < a.grid.size(); ++i) {
        const Cell c = a.grid.cell(i), there = move(c);
        if (a.grid.isFree(c) && b.grid.isFree(there)) ++shared[a.regionAt(c)][b.regionAt(there)];
    }
    std::vector<std::size_t> result;
    for (const auto& counts : shared) {
        const auto most = std::max_element(counts.begin(), counts.end(),
                                           [](const auto& l, const auto& r) { return l.second < r.second; });
        result.push_back(most == counts.end() ? b.regions.size() : most->first);
    }
    return result;
}

/** The first door of the one that has no counterpart in the other; empty when all have. */
std::string missingDoor(const std::vector<Cell>& doors, const std::vector<Cell>& others, double tolerance)
{
    for (const Cell door : doors) {
        const auto isNear = [&](Cell o) { return std::hypot(o.x - door.x, o.y - door.y) <= tolerance; };
        if (std::count_if(others.begin(), others.end(), isNear) != 1) return at(door);
    }
    return "";
}
}  // namespace

DoorTopology::DoorTopology(const ClassifiedGrid& g, Extraction e) : grid(g), extraction(std::move(e))
{
    const TopologicalMap& map = extraction.map;
    std::vector<std::size_t> root(map.places().size() + 1);
    std::iota(root.begin(), root.end(), std::size_t{0});
    const std::vector<Connection> connections = map.connections();
    for (bool changed = true; changed;) {
        changed = false;
        for (const Connection& c : connections) {
            const std::size_t low = std::min(root[c.from], root[c.to]);
            if (c.doorway.real || root[c.from] == root[c.to]) continue;
            root[c.from] = root[c.to] = low;
            changed = true;
        }
    }
    regionOfPlace.assign(root.size(), 0);
    for (std::size_t p = 1; p < root.size(); ++p) {
        if (root[p] == p) {
            regionOfPlace[p] = regions.size();
            regions.emplace_back();
        } else
            regionOfPlace[p] = regionOfPlace[root[p]];
        regions[regionOfPlace[p]].area_m2 += map.place(static_cast<PlaceId>(p)).area_m2;
    }
    for (const Connection& c : connections) {
        if (!c.doorway.real) continue;
        ++regions[regionOfPlace[c.from]].doors;
        ++regions[regionOfPlace[c.to]].doors;
        doors.push_back(cellAt(grid, {c.doorway.position.mean.x, c.doorway.position.mean.y}));
    }
}

std::string differenceBetween(const DoorTopology& a, const DoorTopology& b,
                              const std::function<Cell(Cell)>& move, const RegionTolerance& tolerance)
{
    std::vector<Cell> moved;
    for (const Cell door : a.doors) moved.push_back(move(door));
    if (const auto door = missingDoor(moved, b.doors, tolerance.door_cells); !door.empty())
        return "the door at " + door + " of the first is not in the second";
    if (const auto door = missingDoor(b.doors, moved, tolerance.door_cells); !door.empty())
        return "the door at " + door + " of the second is not in the first";
    if (a.regions.size() != b.regions.size())
        return std::to_string(a.regions.size()) + " regions against " + std::to_string(b.regions.size());
    std::vector<std::size_t> partner = counterparts(a, b, move);
    for (std::size_t r = 0; r < partner.size(); ++r) {
        if (partner[r] >= b.regions.size()) return "region " + std::to_string(r) + " has no counterpart";
        const Region &here = a.regions[r], &there = b.regions[partner[r]];
        if (here.doors != there.doors)
            return std::to_string(here.doors) + " doors of a region against " + std::to_string(there.doors);
        if (here.area_m2 >= tolerance.minArea_m2 &&
            std::abs(here.area_m2 - there.area_m2) > tolerance.area * here.area_m2)
            return "area " + text(here.area_m2) + " m2 against " + text(there.area_m2) + " m2";
    }
    std::sort(partner.begin(), partner.end());
    if (std::adjacent_find(partner.begin(), partner.end()) != partner.end())
        return "two regions have the same counterpart";
    return "";
}
}  // namespace gr2to::test
