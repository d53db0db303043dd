#include "gr2to/stages/GridFiltering.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gr2to/grid/Runs.h"

namespace gr2to
{
namespace
{
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

/** The cells in the middle of a straight stretch, from its begin to its end. */
std::vector<Cell> middleOf(const WallSegment& s, const LineDirection& direction)
{
    std::vector<Cell> cells;
    for (int step = s.begin; step <= s.end; ++step) {
        const double part = static_cast<double>(step - s.begin) / std::max(1, s.end - s.begin);
        cells.push_back(
            direction.cell(step, s.beginRow + static_cast<int>(std::lround(part * (s.endRow - s.beginRow)))));
    }
    return cells;
}

/** Whether a straight stretch is as thin as a wall for half of its length or more. */
bool isThin(const ClassifiedGrid& grid, const LineDirection& direction, const std::vector<Cell>& middle,
            double most_cells)
{
    const int most = static_cast<int>(most_cells * direction.stretch());  // rows
    std::size_t thin = 0;
    for (const Cell c : middle) {
        const int step = direction.step(c), row = direction.row(c);
        int up = 0, down = 0;
        while (up <= most && !grid.isFree(direction.cell(step, row + up))) ++up;
        while (down <= most && !grid.isFree(direction.cell(step, row - down))) ++down;
        thin += up + down - 1 <= most ? 1 : 0;
    }
    return 2 * thin >= middle.size();
}

/** The blobs that are pieces of wall, by the roots of their runs: all that a long and thin stretch runs over,
 * gaps in it being gaps of the map. */
std::vector<bool> findWalls(const ClassifiedGrid& grid, const std::vector<WallSegment>& segments,
                            const std::vector<LineDirection>& directions, const TFilterOptions& options,
                            Runs& runs)
{
    std::vector<bool> isWall(runs.runs().size(), false);
    const double resolution = grid.resolution_m();
    for (const WallSegment& s : segments) {
        const LineDirection& direction = directions[s.direction];
        if ((s.end - s.begin + 1) * direction.stretch() * resolution < options.min_wall) continue;
        const std::vector<Cell> middle = middleOf(s, direction);
        if (!isThin(grid, direction, middle, options.max_wall_thickness / resolution)) continue;
        isWall[runs.root(runs.find(grid.index(s.cell)))] = true;
        for (const Cell c : middle)
            if (grid.contains(c) && !grid.isFree(c)) isWall[runs.root(runs.find(grid.index(c)))] = true;
    }
    return isWall;
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
        {"max_wall_thickness", &max_wall_thickness, "m",
         "A straight stretch that is thicker than this is furniture or a pillar, no wall.", 0, 10}};
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
    const std::vector<bool> isWall = findWalls(grid, segments, directions, m_options, runs);
    for (std::size_t r = 0; r < sizes.size(); ++r) {
        const std::size_t size = sizes[runs.root(r)];
        if (isWall[runs.root(r)] || size >= kTooLarge ||
            static_cast<double>(size) * cellArea >= m_options.max_blob_area)
            continue;
        const Runs::Run& run = runs.runs()[r];
        for (std::size_t i = run.begin; i < run.end; ++i) result.grid[i] = CellState::Free;
        result.cells += run.end - run.begin;
        result.blobs += runs.root(r) == r ? 1 : 0;
    }
    return result;
}
}  // namespace gr2to
