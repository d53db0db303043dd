#include "gr2to/stages/GridFiltering.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

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

/** Finds the blobs that are pieces of wall: those with a long and thin straight stretch, and those with
 * a shorter one that goes on where a wall ends, beyond a doorway. */
class WallFinder
{
 public:
    WallFinder(const ClassifiedGrid& grid, const std::vector<WallSegment>& segments,
               const std::vector<LineDirection>& directions, const TFilterOptions& options, Runs& runs)
        : m_grid(grid),
          m_segments(segments),
          m_directions(directions),
          m_options(options),
          m_runs(runs),
          m_tried(segments.size(), false),
          m_isWall(runs.runs().size(), false)
    {
        for (std::size_t k = 0; k < segments.size(); ++k) {
            m_inRow[{segments[k].direction, segments[k].beginRow}].push_back(k);
            if (segments[k].endRow != segments[k].beginRow)
                m_inRow[{segments[k].direction, segments[k].endRow}].push_back(k);
        }
    }

    /** By the roots of their runs. \param stands  whether the blob of a root is too large to be removed */
    template <class Stands>
    std::vector<bool> find(const Stands& stands)
    {
        for (std::size_t k = 0; k < m_segments.size(); ++k)
            if (stands(m_runs.root(m_runs.find(m_grid.index(m_segments[k].cell))))) {
                m_tried[k] = true;
                m_queue.push_back(k);
            }
        for (std::size_t k = 0; k < m_segments.size(); ++k)
            if (length_m(m_segments[k]) >= m_options.min_wall) accept(k);
        while (!m_queue.empty()) {
            const std::size_t k = m_queue.back();
            m_queue.pop_back();
            for (const std::size_t other : beyondDoorways(m_segments[k]))
                if (length_m(m_segments[other]) >= m_options.min_aligned_wall) accept(other);
        }
        return std::move(m_isWall);
    }

 private:
    static constexpr double kDoorway_m = 2;   // wider than doors are
    static constexpr double kInLine_m = 0.2;  // about as thick as walls are

    double length_m(const WallSegment& s) const
    {
        return (s.end - s.begin + 1) * m_directions[s.direction].stretch() * m_grid.resolution_m();
    }

    /** All that a thin stretch runs over is wall, gaps in it being gaps of the map. */
    void accept(std::size_t k)
    {
        if (m_tried[k]) return;
        m_tried[k] = true;
        const WallSegment& s = m_segments[k];
        const LineDirection& direction = m_directions[s.direction];
        std::vector<Cell> cells = middleOf(s, direction);
        if (!isThin(m_grid, direction, cells, m_options.max_wall_thickness / m_grid.resolution_m())) return;
        m_queue.push_back(k);
        cells.push_back(s.cell);
        for (const Cell c : cells)
            if (m_grid.contains(c) && !m_grid.isFree(c))
                m_isWall[m_runs.root(m_runs.find(m_grid.index(c)))] = true;
    }

    /** The stretches that go on in line with one, at most a doorway beyond either end. */
    std::vector<std::size_t> beyondDoorways(const WallSegment& s) const
    {
        const double stretch = m_directions[s.direction].stretch(), resolution = m_grid.resolution_m();
        const int rows = static_cast<int>(kInLine_m / resolution * stretch);
        const int doorway = static_cast<int>(kDoorway_m / resolution / stretch);
        std::vector<std::size_t> found;
        for (const bool ahead : {false, true}) {
            const int row = ahead ? s.endRow : s.beginRow;
            for (auto at = m_inRow.lower_bound({s.direction, row - rows});
                 at != m_inRow.end() && at->first.first == s.direction && at->first.second <= row + rows;
                 ++at)
                for (const std::size_t k : at->second) {
                    const WallSegment& other = m_segments[k];
                    const int gap = ahead ? other.begin - s.end : s.begin - other.end;
                    const int facingRow = ahead ? other.beginRow : other.endRow;
                    if (gap > 0 && gap <= doorway && std::abs(facingRow - row) <= rows) found.push_back(k);
                }
        }
        return found;
    }

    const ClassifiedGrid& m_grid;
    const std::vector<WallSegment>& m_segments;
    const std::vector<LineDirection>& m_directions;
    const TFilterOptions& m_options;
    Runs& m_runs;
    std::map<std::pair<std::size_t, int>, std::vector<std::size_t>>
        m_inRow;                       //!< by direction and row of an end
    std::vector<bool> m_tried;         //!< segments that are walls or have been found too thick
    std::vector<std::size_t> m_queue;  //!< walls beyond whose ends nobody has looked
    std::vector<bool> m_isWall;
};
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
         "The same where the stretch goes on in line with a wall, at most 2 m beyond its end.", 0, 100},
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
    const auto stands = [&](std::size_t root) {
        return sizes[root] >= kTooLarge ||
               static_cast<double>(sizes[root]) * cellArea >= m_options.max_blob_area;
    };
    const std::vector<bool> isWall = WallFinder(grid, segments, directions, m_options, runs).find(stands);
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
