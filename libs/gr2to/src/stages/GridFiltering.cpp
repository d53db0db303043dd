#include "gr2to/stages/GridFiltering.h"

#include <algorithm>
#include <limits>

#include "WallPieces.h"
#include "gr2to/grid/Runs.h"

namespace gr2to
{
namespace
{
constexpr double kDoorway_m = 2;   // wider than doors are
constexpr double kInLine_m = 0.2;  // about as thick as walls are
constexpr double kStub_m = 0.15;   // jambs are that deep at least
constexpr std::size_t kTooLarge = std::numeric_limits<std::size_t>::max() / 2;

/** Size of each region of cells that are not free, by its root; at least kTooLarge when it reaches the grid's
 * border. */
std::vector<std::size_t> sizesOfRegions(Runs& runs, std::size_t width, std::size_t cells)
{
    std::vector<std::size_t> sizes(runs.runs().size(), 0);
    for (std::size_t r = 0; r < sizes.size(); ++r) {
        const Runs::Run& run = runs.runs()[r];
        const bool atBorder =
            run.begin % width == 0 || run.end % width == 0 || run.begin < width || run.end > cells - width;
        std::size_t& size = sizes[runs.root(r)];
        size = atBorder || size >= kTooLarge ? kTooLarge : size + (run.end - run.begin);
    }
    return sizes;
}

WallPieceRules rulesOf(const TFilterOptions& options, double resolution_m)
{
    WallPieceRules rules;
    rules.minLength_cells = options.min_wall / resolution_m;
    rules.minAlignedLength_cells = std::min(options.min_wall, options.min_aligned_wall) / resolution_m;
    rules.mostThickness_cells = options.max_wall_thickness / resolution_m;
    rules.mostLoneThickness_cells = options.max_lone_thickness / resolution_m;
    rules.doorway_cells = kDoorway_m / resolution_m;
    rules.inLine_cells = kInLine_m / resolution_m;
    rules.stub_cells = kStub_m / resolution_m;
    return rules;
}
}  // namespace

std::vector<OptionField> TFilterOptions::fields()
{
    return {
        {"max_blob_area", &max_blob_area, "m2",
         "Free-standing obstacles smaller than this are removed before anything else; 0 keeps all.", 0, 100},
        {"min_wall", &min_wall, "m",
         "A free-standing obstacle with a straight, thin stretch of at least this is a piece of wall and "
         "stays.",
         0, 100},
        {"min_aligned_wall", &min_aligned_wall, "m",
         "The same where the stretch is in line with another one or with a wall, at most 2 m beyond its end.",
         0, 100},
        {"max_wall_thickness", &max_wall_thickness, "m",
         "A straight stretch that is thicker than this is furniture or a pillar, no wall.", 0, 10},
        {"max_lone_thickness", &max_lone_thickness, "m",
         "The same where the stretch is in line with nothing: partitions are thinner than walls that bear.",
         0, 10}};
}

GridFilter::GridFilter(TFilterOptions options) : m_options(std::move(options))
{
    m_options.check();
}

FilteredGrid GridFilter::filter(const ClassifiedGrid& grid, const std::vector<WallSegment>& segments,
                                const std::vector<LineDirection>& directions) const
{
    FilteredGrid result{grid, 0, 0};
    const double cellArea = grid.resolution_m() * grid.resolution_m();
    if (m_options.max_blob_area < cellArea) return result;
    Runs runs(grid.width(), grid.height(), Runs::Connectivity::SidesAndCorners,
              [&](std::size_t i) { return grid[i] != CellState::Free; });
    const std::vector<std::size_t> sizes =
        sizesOfRegions(runs, static_cast<std::size_t>(grid.width()), grid.size());
    const auto stands = [&](std::size_t root) {
        return sizes[root] >= kTooLarge ||
               static_cast<double>(sizes[root]) * cellArea >= m_options.max_blob_area;
    };
    const std::vector<bool> isWall =
        WallPieces(grid, segments, directions, rulesOf(m_options, grid.resolution_m())).find(runs, stands);
    for (std::size_t r = 0; r < sizes.size(); ++r) {
        if (isWall[runs.root(r)] || stands(runs.root(r))) continue;
        const Runs::Run& run = runs.runs()[r];
        for (std::size_t i = run.begin; i < run.end; ++i) result.grid[i] = CellState::Free;
        result.cells += run.end - run.begin;
        result.blobs += runs.root(r) == r ? 1 : 0;
    }
    return result;
}
}  // namespace gr2to
