#include "gr2to/io/OccupancyGrid.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <array>
#include <charconv>

#include "gr2to/base/errors.h"

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
}  // namespace gr2to
