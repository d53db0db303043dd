#include <algorithm>

#include "support/building/Rasteriser.h"

namespace gr2to::test
{
namespace
{
/** Side of the pieces that are displaced as one [m]. */
constexpr double kPiece_m = 0.5;

/** Moves a share of the pieces by one cell to the right, upwards or both; neighbours stay within one cell. */
void displace(RasterisedPlan& raster, const TBuildingOptions& options)
{
    const ClassifiedGrid before = raster.grid;
    const PlaceImage labels = raster.labels;
    const int side = std::max(2, static_cast<int>(kPiece_m / options.resolution));
    const int pieces = before.width() / side + 1;
    SeededRandom random(options.seed, SeededRandom::Purpose::Jitter);
    std::vector<Cell> shift(static_cast<std::size_t>(pieces));
    for (int y = 0; y < before.height(); ++y) {
        if (y % side == 0)
            for (auto& s : shift) {
                s = {0, 0};
                if (!random.chance(options.wall_jitter)) continue;
                const int kind = random.integer(1, 3);
                s = {kind & 1, kind >> 1};
            }
        for (int x = 0; x < before.width(); ++x) {
            const Cell s = shift[static_cast<std::size_t>(x / side)];
            const Cell from{std::max(0, x - s.x), std::max(0, y - s.y)};
            raster.grid.set({x, y}, before.at(from));
            raster.labels.ids[raster.labels.index({x, y})] = labels.at(from);
        }
    }
}

/** Neighbour of `c` by a side in the wanted state; `c` itself when there is none. */
Cell neighbourIn(const ClassifiedGrid& grid, Cell c, CellState wanted)
{
    for (const Cell n : {Cell{c.x + 1, c.y}, Cell{c.x - 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x, c.y - 1}})
        if (grid.contains(n) && grid.at(n) == wanted) return n;
    return c;
}

void flip(RasterisedPlan& raster, const TBuildingOptions& options)
{
    const ClassifiedGrid before = raster.grid;
    const PlaceImage labels = raster.labels;
    SeededRandom random(options.seed, SeededRandom::Purpose::Noise);
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] == CellState::Unknown) continue;
        const bool free = before[i] == CellState::Free;
        const Cell c = before.cell(i);
        const Cell other = neighbourIn(before, c, free ? CellState::Occupied : CellState::Free);
        const bool edge = other != c;
        if (!free && !edge) continue;
        if (!random.chance(edge ? options.noise : options.speckle)) continue;
        raster.grid[i] = free ? CellState::Occupied : CellState::Free;
        raster.labels.ids[i] = free ? PlaceId{0} : labels.at(other);
    }
}
}  // namespace

void degrade(RasterisedPlan& raster, const TBuildingOptions& options)
{
    if (options.wall_jitter > 0.0) displace(raster, options);
    if (options.noise > 0.0 || options.speckle > 0.0) flip(raster, options);
}
}  // namespace gr2to::test
