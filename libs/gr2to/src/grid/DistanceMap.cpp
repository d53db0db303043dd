#include "gr2to/grid/DistanceMap.h"

#include <algorithm>

namespace gr2to
{
namespace
{
constexpr std::uint16_t kNoObstacle = 0xFFFF;

/** Obstacle of a row's envelope: its column and the square of its vertical distance to the row. */
struct Parabola
{
    std::int32_t column;
    std::int32_t height;
};

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
            sweepUp(grid.row(static_cast<int>(y)), obstacles, y ? row(y - 1) : beyond.data(), rowToWrite(y));
        for (std::size_t y = height - 1; y-- > 0;) sweepDown(row(y + 1), rowToWrite(y));
    }

    const std::uint16_t* row(std::size_t y) const { return m_distance.data() + y * m_width; }

 private:
    static std::uint16_t next(std::uint16_t d)
    {
        return static_cast<std::uint16_t>(d + (d != kNoObstacle ? 1 : 0));
    }
    std::uint16_t* rowToWrite(std::size_t y) { return m_distance.data() + y * m_width; }

    void sweepUp(const CellState* cells, Obstacles obstacles, const std::uint16_t* below,
                 std::uint16_t* out) const
    {
        if (obstacles == Obstacles::Occupied)
            for (std::size_t x = 0; x < m_width; ++x)
                out[x] = cells[x] == CellState::Occupied ? std::uint16_t{0} : next(below[x]);
        else
            for (std::size_t x = 0; x < m_width; ++x)
                out[x] = cells[x] != CellState::Free ? std::uint16_t{0} : next(below[x]);
    }

    void sweepDown(const std::uint16_t* above, std::uint16_t* out) const
    {
        for (std::size_t x = 0; x < m_width; ++x) out[x] = std::min(out[x], next(above[x]));
    }

    std::size_t m_width;
    std::vector<std::uint16_t> m_distance;
};

/** Whether b lies nowhere below both a and c, with a, b, c from left to right. */
bool hidden(const Parabola& a, const Parabola& b, const Parabola& c)
{
    const std::int64_t ab = b.column - a.column, bc = c.column - b.column, ac = ab + bc;
    return ac * b.height - bc * a.height - ab * c.height > ab * bc * ac;
}

/** Lower envelope of a row's parabolas, from left to right. */
void buildEnvelope(const std::uint16_t* columnDistance, int width, std::vector<Parabola>& envelope)
{
    envelope.clear();
    for (int x = 0; x < width; ++x) {
        const std::uint16_t d = columnDistance[x];
        if (d == kNoObstacle) continue;
        const Parabola parabola{x, std::int32_t{d} * d};
        while (envelope.size() >= 2 && hidden(envelope[envelope.size() - 2], envelope.back(), parabola))
            envelope.pop_back();
        envelope.push_back(parabola);
    }
}

/** Row of the obstacle that is `distance` cells above or below row y in column x; the lower one when both
 * are. */
int obstacleRow(const ClassifiedGrid& grid, Obstacles obstacles, int x, int y, int distance)
{
    const auto isObstacle = [&](int row) {
        if (row < 0) return false;
        const CellState state = grid.at({x, row});
        return obstacles == Obstacles::Occupied ? state == CellState::Occupied : state != CellState::Free;
    };
    return isObstacle(y - distance) ? y - distance : y + distance;
}
}  // namespace

DistanceMap measureDistances(const ClassifiedGrid& grid, Obstacles obstacles, NearestObstacles* nearest)
{
    const int width = grid.width(), height = grid.height();
    DistanceMap map{width, height, std::vector<std::int32_t>(grid.size(), 0)};
    if (nearest) nearest->packed.assign(grid.size(), 0);
    const ColumnDistances columns(grid, obstacles);
    std::vector<Parabola> envelope;
    envelope.reserve(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        const CellState* cells = grid.row(y);
        if (std::find(cells, cells + width, CellState::Free) == cells + width) continue;
        const std::uint16_t* columnDistance = columns.row(static_cast<std::size_t>(y));
        buildEnvelope(columnDistance, width, envelope);
        std::int32_t* squared = map.squared.data() + grid.index({0, y});
        std::size_t k = 0;
        for (int x = 0; x < width; ++x) {
            if (cells[x] != CellState::Free) continue;
            if (envelope.empty()) {
                squared[x] = DistanceMap::unreachable();
                continue;
            }
            const auto at = [&](std::size_t i) {
                const std::int32_t dx = x - envelope[i].column;
                return dx * dx + envelope[i].height;
            };
            std::int32_t best = at(k);
            while (k + 1 < envelope.size()) {
                const std::int32_t candidate = at(k + 1);
                if (candidate >= best) break;
                best = candidate;
                ++k;
            }
            squared[x] = best;
            if (!nearest) continue;
            const int column = envelope[k].column;
            const int row = obstacleRow(grid, obstacles, column, y, columnDistance[column]);
            nearest->packed[grid.index({x, y})] = NearestObstacles::pack(column, row);
        }
    }
    return map;
}
}  // namespace gr2to
