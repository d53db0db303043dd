#include "gr2to/grid/DistanceMap.h"

#include <algorithm>

#include "base/vectorised.h"

namespace gr2to
{
namespace
{
constexpr std::uint16_t kNoObstacle = 0xFFFF;
constexpr std::int32_t kBeyond = INT32_MAX;  // column of the mark behind the last parabola

/** Obstacle of a row's envelope: its column and the square of its vertical distance to the row. */
struct Parabola
{
    std::int32_t column;
    std::int32_t height;
};

std::uint16_t next(std::uint16_t d)
{
    return static_cast<std::uint16_t>(d + (d != kNoObstacle ? 1 : 0));
}

GR2TO_VECTORISED
void sweepUp(const CellState* cells, std::size_t width, Obstacles obstacles, const std::uint16_t* below,
             std::uint16_t* out)
{
    if (obstacles == Obstacles::Occupied)
        for (std::size_t x = 0; x < width; ++x)
            out[x] = cells[x] == CellState::Occupied ? std::uint16_t{0} : next(below[x]);
    else
        for (std::size_t x = 0; x < width; ++x)
            out[x] = cells[x] != CellState::Free ? std::uint16_t{0} : next(below[x]);
}

GR2TO_VECTORISED
void sweepDown(const std::uint16_t* above, std::size_t width, std::uint16_t* out)
{
    for (std::size_t x = 0; x < width; ++x) out[x] = std::min(out[x], next(above[x]));
}

/** Vertical distance of every cell to the nearest obstacle of its column, kNoObstacle when there is none. */
class ColumnDistances
{
 public:
    ColumnDistances(const ClassifiedGrid& grid, Obstacles obstacles)
        : m_width(static_cast<std::size_t>(grid.width())), m_distance(grid.size())
    {
        const std::size_t height = grid.size() / m_width;
        const std::vector<std::uint16_t> beyond(m_width, kNoObstacle);
        for (std::size_t y = 0; y < height; ++y)
            sweepUp(grid.row(static_cast<int>(y)), m_width, obstacles, y ? row(y - 1) : beyond.data(),
                    rowToWrite(y));
        for (std::size_t y = height - 1; y-- > 0;) sweepDown(row(y + 1), m_width, rowToWrite(y));
    }

    const std::uint16_t* row(std::size_t y) const { return m_distance.data() + y * m_width; }

 private:
    std::uint16_t* rowToWrite(std::size_t y) { return m_distance.data() + y * m_width; }

    std::size_t m_width;
    std::vector<std::uint16_t> m_distance;
};

/** Whether b lies nowhere below both a and c, with a, b, c from left to right. */
bool hidden(const Parabola& a, const Parabola& b, const Parabola& c)
{
    const std::int64_t ab = b.column - a.column, bc = c.column - b.column, ac = ab + bc;
    return ac * b.height - bc * a.height - ab * c.height > ab * bc * ac;
}

/** Lower envelope of the parabolas of columns [first, last), from left to right. */
void buildEnvelope(const std::uint16_t* columnDistance, int first, int last, std::vector<Parabola>& envelope)
{
    Parabola* const base = envelope.data();
    Parabola* end = base;
    for (int x = first; x < last; ++x) {
        const std::uint16_t d = columnDistance[x];
        if (d == kNoObstacle) continue;
        const Parabola parabola{x, std::int32_t{d} * d};
        while (end - base >= 2 && hidden(end[-2], end[-1], parabola)) --end;
        *end++ = parabola;
    }
    *end = Parabola{kBeyond, 0};
}

/** Measures one row after another. */
class RowSweep
{
 public:
    RowSweep(const ClassifiedGrid& grid, Obstacles obstacles, const ColumnDistances& columns,
             DistanceMap& map, const NearestObstacleRow& onRow)
        : m_grid(grid),
          m_obstacles(obstacles),
          m_columns(columns),
          m_map(map),
          m_onRow(onRow),
          m_nearest(onRow ? static_cast<std::size_t>(grid.width()) : 0),
          m_envelope(static_cast<std::size_t>(grid.width()) + 1)
    {
    }

    /** Stretches between obstacles of the row are independent: nothing beyond an obstacle in the row is
     * nearer than it. */
    void sweep(int y)
    {
        const std::uint16_t* columnDistance = m_columns.row(static_cast<std::size_t>(y));
        const int width = m_grid.width();
        for (int first = 0; first < width;) {
            if (columnDistance[first] == 0) {
                ++first;
                continue;
            }
            int last = first;
            while (last < width && columnDistance[last] != 0) ++last;
            const CellState* cells = m_grid.row(y);
            if (std::find(cells + first, cells + last, CellState::Free) != cells + last) {
                buildEnvelope(columnDistance, std::max(0, first - 1), std::min(width, last + 1), m_envelope);
                measure(y, first, last);
            }
            first = last;
        }
        if (m_onRow) m_onRow(y, m_nearest.data());
    }

 private:
    static std::int32_t squaredDistance(const Parabola& p, int x)
    {
        const std::int32_t dx = x - p.column;
        return dx * dx + p.height;
    }

    void measure(int y, int first, int last)
    {
        const CellState* cells = m_grid.row(y);
        const std::size_t row = m_grid.index({0, y});
        std::int32_t* squared = m_map.squared.data() + row;
        const Parabola* nearest = m_envelope.data();
        if (nearest->column == kBeyond) {
            for (int x = first; x < last; ++x)
                if (cells[x] == CellState::Free) squared[x] = DistanceMap::unreachable();
            return;
        }
        int obstacleRow = rowOf(*nearest, y);
        for (int x = first; x < last; ++x) {
            if (cells[x] != CellState::Free) continue;
            const Parabola* before = nearest;
            std::int32_t best = squaredDistance(*nearest, x);
            while (nearest[1].column != kBeyond) {
                const std::int32_t candidate = squaredDistance(nearest[1], x);
                if (candidate >= best) break;
                best = candidate;
                ++nearest;
            }
            squared[x] = best;
            if (m_nearest.empty()) continue;
            if (nearest != before) obstacleRow = rowOf(*nearest, y);
            m_nearest[static_cast<std::size_t>(x)] = packCell(nearest->column, obstacleRow);
        }
    }

    /** Row of the obstacle in a parabola's column; the lower one when two are equally near. */
    int rowOf(const Parabola& p, int y) const
    {
        const int below = y - m_columns.row(static_cast<std::size_t>(y))[p.column];
        if (below >= 0) {
            const CellState state = m_grid.at({p.column, below});
            if (m_obstacles == Obstacles::Occupied ? state == CellState::Occupied : state != CellState::Free)
                return below;
        }
        return y + m_columns.row(static_cast<std::size_t>(y))[p.column];
    }

    const ClassifiedGrid& m_grid;
    Obstacles m_obstacles;
    const ColumnDistances& m_columns;
    DistanceMap& m_map;
    const NearestObstacleRow& m_onRow;
    std::vector<std::uint32_t> m_nearest;  //!< of the current row; empty when nobody asks
    std::vector<Parabola> m_envelope;      //!< ends with a mark at kBeyond
};
}  // namespace

void measureDistances(const ClassifiedGrid& grid, Obstacles obstacles, DistanceMap& map,
                      const NearestObstacleRow& onRow)
{
    map.width = grid.width();
    map.height = grid.height();
    map.squared.assign(grid.size(), 0);
    const ColumnDistances columns(grid, obstacles);
    RowSweep rows(grid, obstacles, columns, map, onRow);
    for (int y = 0; y < grid.height(); ++y) rows.sweep(y);
}

DistanceMap measureDistances(const ClassifiedGrid& grid, Obstacles obstacles)
{
    DistanceMap map;
    measureDistances(grid, obstacles, map);
    return map;
}
}  // namespace gr2to
