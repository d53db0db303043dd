#include "gr2to/io/OccupancyGrid.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "gr2to/base/errors.h"
#include "gr2to/base/text.h"

namespace gr2to
{
namespace
{
using Map = mrpt::maps::COccupancyGridMap2D;
static_assert(sizeof(Map::cellType) == 1, "the table below has one entry for each 8-bit log-odds");

std::array<CellState, 256> stateTable(const OccupancyThresholds& thresholds)
{
    std::array<CellState, 256> table{};
    for (int logOdds = -128; logOdds < 128; ++logOdds) {
        const double occupancy = 1.0 - static_cast<double>(Map::l2p(static_cast<Map::cellType>(logOdds)));
        CellState state = CellState::Unknown;
        if (logOdds != 0 && occupancy > thresholds.occupied) state = CellState::Occupied;
        if (logOdds != 0 && occupancy < thresholds.free) state = CellState::Free;
        table[static_cast<std::uint8_t>(logOdds)] = state;
    }
    return table;
}

double shortestDecimal(float value)
{
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    double exact = 0;
    std::from_chars(buffer, end, exact);
    return exact;
}
}  // namespace

ClassifiedGrid fromOccupancyGrid(const mrpt::maps::COccupancyGridMap2D& map,
                                 const OccupancyThresholds& thresholds)
{
    GridFrame frame;
    frame.resolution_m = shortestDecimal(map.getResolution());
    frame.origin_x_m = shortestDecimal(map.getXMin());
    frame.origin_y_m = shortestDecimal(map.getYMin());
    ClassifiedGrid grid(static_cast<int>(map.getSizeX()), static_cast<int>(map.getSizeY()), frame);
    const auto table = stateTable(thresholds);
    for (int y = 0; y < grid.height(); ++y) {
        const Map::cellType* in = map.getRow(y);
        CellState* out = grid.row(y);
        for (int x = 0; x < grid.width(); ++x) out[x] = table[static_cast<std::uint8_t>(in[x])];
    }
    return grid;
}

Map toOccupancyGrid(const ClassifiedGrid& grid)
{
    const GridFrame& frame = grid.frame();
    if (frame.yaw_rad != 0)
        throw InputError("the grid is turned by " + numberText(frame.yaw_rad) +
                         " rad, which an MRPT grid cannot be; turn the grid itself");
    const auto end = [&](double origin, int cells) {
        return static_cast<float>(origin + cells * frame.resolution_m);
    };
    const auto x = static_cast<float>(frame.origin_x_m), y = static_cast<float>(frame.origin_y_m);
    Map map(x, end(frame.origin_x_m, grid.width()), y, end(frame.origin_y_m, grid.height()),
            static_cast<float>(frame.resolution_m));
    const auto width = std::min(static_cast<unsigned>(grid.width()), map.getSizeX());
    const auto height = std::min(static_cast<unsigned>(grid.height()), map.getSizeY());
    for (unsigned row = 0; row < height; ++row)
        for (unsigned column = 0; column < width; ++column) {
            const CellState state = grid.at({static_cast<int>(column), static_cast<int>(row)});
            map.setCell(static_cast<int>(column), static_cast<int>(row),
                        state == CellState::Free       ? 1.0F
                        : state == CellState::Occupied ? 0.0F
                                                       : 0.5F);
        }
    return map;
}
}  // namespace gr2to
