#include "gr2to/grid/Thinning.h"

#include <algorithm>

namespace gr2to
{
namespace
{
constexpr std::uint16_t kFigure = 1;
constexpr std::uint16_t kAnchor = 2;
constexpr std::uint16_t kQueued = 4;
constexpr std::uint16_t kStateBits = kFigure | kAnchor | kQueued;
constexpr int kBucketShift = 3;
constexpr int kMaxBucket = 0xFFFF >> kBucketShift;

/** Clearances that differ by less are removed first come, first served: in waves, which keeps them in order
 * too. */
constexpr float kBucketCells = 2.0F;
/** Side of a tile [cells]: two bytes a cell, three rows of neighbours and the queue fit a 256 kB cache. */
constexpr int kTileSide = 256;

/** Runs around the ring of neighbours; a 4-connected run counts when it holds a cell that shares a side. */
int figureRuns(std::uint8_t ring)
{
    if (ring == 0xFF) return 1;
    int start = 0;
    while ((ring >> start) & 1) ++start;
    int runs = 0;
    bool touchesSide = false;
    for (int k = 1; k <= 8; ++k) {
        const int i = (start + k) % 8;
        if ((ring >> i) & 1)
            touchesSide = touchesSide || i % 2 == 0;
        else {
            runs += touchesSide ? 1 : 0;
            touchesSide = false;
        }
    }
    return runs;
}

/** Components of the ground among the neighbours, corners joined by sides (8-connected). */
int groundRuns(std::uint8_t ring)
{
    const auto ground = static_cast<std::uint8_t>(~ring);
    if (ground == 0) return 0;
    const std::uint8_t sides = ground & 0x55U;
    if (sides == 0) return __builtin_popcount(ground);
    // Two ground sides next to each other share a corner and touch across it even when that corner is figure.
    std::uint8_t joined = ground;
    for (int corner = 1; corner < 8; corner += 2) {
        const int before = corner - 1, after = (corner + 1) % 8;
        if (((ground >> before) & 1) && ((ground >> after) & 1))
            joined = static_cast<std::uint8_t>(joined | 1U << corner);
    }
    if (joined == 0xFF) return 1;
    int runs = 0;
    for (int i = 0; i < 8; ++i)
        if (((joined >> i) & 1) && !((joined >> ((i + 7) % 8)) & 1)) ++runs;
    return runs;
}

std::array<bool, 256> makeSimpleTable()
{
    std::array<bool, 256> table{};
    for (unsigned ring = 0; ring < 256; ++ring)
        table[ring] = figureRuns(static_cast<std::uint8_t>(ring)) == 1 &&
                      groundRuns(static_cast<std::uint8_t>(ring)) == 1;
    return table;
}

const std::array<bool, 256>& simpleTable()
{
    static const std::array<bool, 256> table = makeSimpleTable();
    return table;
}

/** The thinning in progress.
 *
 * Cells wait in buckets of similar clearance, one set of buckets for each square tile of the grid. All tiles
 * finish a bucket before the next begins, but one tile after the other, so that a tile's cells stay in the
 * processor's cache.
 */
class Thinner
{
 public:
    Thinner(const ClassifiedGrid& grid, const DistanceMap& distances)
        : m_cells(grid.width(), grid.height()),
          m_steps(m_cells.neighbourSteps()),
          m_simple(simpleTable()),
          m_tileColumns((grid.width() + 2) / kTileSide + 1)
    {
        for (int y = 0; y < grid.height(); ++y) {
            const CellState* cells = grid.row(y);
            const std::int32_t* squared = distances.squared.data() + grid.index({0, y});
            std::uint16_t* out = &m_cells[m_cells.index({0, y})];
            for (int x = 0; x < grid.width(); ++x)
                out[x] = cells[x] == CellState::Free
                             ? static_cast<std::uint16_t>(bucketOf(squared[x]) | kFigure)
                             : std::uint16_t{0};
        }
        m_queues.resize(static_cast<std::size_t>(m_tileColumns) *
                        ((static_cast<std::size_t>(grid.height()) + 2) / kTileSide + 1));
    }

    void protect(const std::vector<Cell>& anchors)
    {
        for (const Cell c : anchors) m_cells[m_cells.index(c)] |= kAnchor;
    }

    /** Removes all that is no anchor and not needed for the topology. */
    void thinAroundAnchors()
    {
        for (int y = 0; y < m_cells.height(); ++y) {
            const std::size_t row = m_cells.index({0, y});
            for (std::size_t i = row; i < row + static_cast<std::size_t>(m_cells.width()); ++i)
                if ((m_cells[i] & kStateBits) == kFigure && ring(i) != 0xFF) enqueue(i);
        }
        drain([](std::uint8_t) { return false; });
    }

    /** Thins the anchors too, but keeps the ends of curves.
     * \param anchors  in the order in which they shall be tried
     */
    void thinAnchors(const std::vector<Cell>& anchors)
    {
        for (const Cell c : anchors)
        {
            std::uint16_t& cell = m_cells[m_cells.index(c)];
            cell = static_cast<std::uint16_t>(cell & ~kAnchor);
        }
        for (const Cell c : anchors)
            if ((m_cells[m_cells.index(c)] & kStateBits) == kFigure) enqueue(m_cells.index(c));
        drain(isEnd);
    }

    Mask result() const
    {
        Mask mask(m_cells.width(), m_cells.height());
        for (int y = 0; y < mask.height(); ++y) {
            const std::size_t row = m_cells.index({0, y});
            for (std::size_t i = row; i < row + static_cast<std::size_t>(mask.width()); ++i)
                mask[i] = static_cast<std::uint8_t>(m_cells[i] & kFigure);
        }
        return mask;
    }

 private:
    struct Tile
    {
        std::vector<std::vector<std::uint32_t>> buckets;
        std::vector<std::uint32_t> working;  //!< cells of the current bucket
    };

    static std::uint16_t bucketOf(std::int32_t squaredClearance)
    {
        const float bucket = std::sqrt(static_cast<float>(squaredClearance)) / kBucketCells;
        return static_cast<std::uint16_t>(std::min(static_cast<int>(bucket), kMaxBucket) << kBucketShift);
    }

    /** One side neighbour, and no other cell of the figure but one of the corners beside it. */
    static bool isEnd(std::uint8_t ring)
    {
        if (__builtin_popcount(ring & 0x55U) != 1 || __builtin_popcount(ring) > 2) return false;
        const int side = __builtin_ctz(ring & 0x55U);
        return (ring & ~(1U << side | 1U << (side + 1) % 8 | 1U << (side + 7) % 8)) == 0;
    }

    std::uint8_t ring(std::size_t i) const
    {
        const std::uint16_t* at = &m_cells[i];
        unsigned bits = 0;
        for (unsigned k = 0; k < 8; ++k) bits |= (at[m_steps[k]] & kFigure) << k;
        return static_cast<std::uint8_t>(bits);
    }

    void enqueue(std::size_t i)
    {
        m_cells[i] |= kQueued;
        Tile& tile = m_queues[tileOf(i)];
        const std::size_t bucket = m_cells[i] >> kBucketShift;
        if (bucket <= m_current) {
            if (tile.working.empty())
                m_waiting.push_back(static_cast<std::uint32_t>(&tile - m_queues.data()));
            tile.working.push_back(static_cast<std::uint32_t>(i));
            return;
        }
        if (bucket >= tile.buckets.size()) tile.buckets.resize(bucket + 1);
        tile.buckets[bucket].push_back(static_cast<std::uint32_t>(i));
        m_highest = std::max(m_highest, bucket);
    }

    std::size_t tileOf(std::size_t i) const
    {
        const auto index = static_cast<std::uint32_t>(i);
        const auto stride = static_cast<std::uint32_t>(m_cells.stride());
        const std::uint32_t row = index / stride, column = index - row * stride;
        return row / kTileSide * static_cast<std::uint32_t>(m_tileColumns) + column / kTileSide;
    }

    template <class Keep>
    void drain(const Keep& keep)
    {
        for (m_current = 0; m_current <= m_highest; ++m_current) {
            for (std::size_t t = 0; t < m_queues.size(); ++t) takeBucket(t);
            while (!m_waiting.empty()) {
                std::vector<std::uint32_t> tiles;
                tiles.swap(m_waiting);
                for (const std::uint32_t t : tiles) drainTile(t, keep);
            }
        }
        m_current = 0;
        m_highest = 0;
    }

    void takeBucket(std::size_t t)
    {
        Tile& tile = m_queues[t];
        if (m_current >= tile.buckets.size() || tile.buckets[m_current].empty()) return;
        if (tile.working.empty()) m_waiting.push_back(static_cast<std::uint32_t>(t));
        auto& bucket = tile.buckets[m_current];
        tile.working.insert(tile.working.end(), bucket.begin(), bucket.end());
        std::vector<std::uint32_t>().swap(bucket);
    }

    template <class Keep>
    void drainTile(std::size_t t, const Keep& keep)
    {
        Tile& tile = m_queues[t];
        for (std::size_t k = 0; k < tile.working.size(); ++k) {
            const std::size_t i = tile.working[k];
            m_cells[i] = static_cast<std::uint16_t>(m_cells[i] & ~kQueued);
            const std::uint8_t around = ring(i);
            if (!m_simple[around] || keep(around)) continue;
            m_cells[i] = 0;
            for (const std::ptrdiff_t step : m_steps) {
                const auto j = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + step);
                if ((m_cells[j] & kStateBits) == kFigure) enqueue(j);
            }
        }
        tile.working.clear();
    }

    Padded<std::uint16_t> m_cells;  //!< figure, anchor and queued bits, and the bucket above them
    std::array<std::ptrdiff_t, 8> m_steps;
    const std::array<bool, 256>& m_simple;
    int m_tileColumns;
    std::vector<Tile> m_queues;
    std::vector<std::uint32_t> m_waiting;  //!< tiles with cells of the current bucket
    std::size_t m_current = 0;
    std::size_t m_highest = 0;
};
}  // namespace

bool isSimple(std::uint8_t neighbours)
{
    return simpleTable()[neighbours];
}

std::vector<Cell> separatingCells(const ClassifiedGrid& grid, const DistanceMap& distances,
                                  const NearestObstacles& nearest, double minSeparation_cells)
{
    const auto minSquared = static_cast<std::int64_t>(std::ceil(minSeparation_cells * minSeparation_cells));
    std::vector<Cell> cells;
    const auto width = static_cast<std::size_t>(grid.width());
    const auto separated = [&](std::size_t i, std::size_t j) {
        if (nearest.packed[i] == nearest.packed[j]) return false;
        const Cell a = nearest.at(i), b = nearest.at(j);
        const std::int64_t dx = a.x - b.x, dy = a.y - b.y;
        return dx * dx + dy * dy >= minSquared;
    };
    std::vector<std::uint8_t> above(width, 0), current(width, 0);
    for (int y = 0; y < grid.height(); ++y) {
        current.swap(above);
        std::fill(above.begin(), above.end(), std::uint8_t{0});
        const CellState* row = grid.row(y);
        const std::size_t start = grid.index({0, y});
        const bool hasAbove = y + 1 < grid.height();
        for (std::size_t x = 0; x < width; ++x) {
            if (row[x] != CellState::Free) continue;
            const std::size_t i = start + x;
            if (x + 1 < width && row[x + 1] == CellState::Free && separated(i, i + 1))
                current[distances.squared[i + 1] > distances.squared[i] ? x + 1 : x] = 1;
            if (hasAbove && row[x + width] == CellState::Free && separated(i, i + width))
                (distances.squared[i + width] > distances.squared[i] ? above : current)[x] = 1;
        }
        for (std::size_t x = 0; x < width; ++x)
            if (current[x]) cells.push_back({static_cast<int>(x), y});
    }
    return cells;
}

Mask thin(const ClassifiedGrid& grid, const DistanceMap& distances, const std::vector<Cell>& anchors)
{
    Thinner thinner(grid, distances);
    thinner.protect(anchors);
    thinner.thinAroundAnchors();
    std::vector<Cell> byClearance = anchors;
    std::stable_sort(byClearance.begin(), byClearance.end(), [&](Cell a, Cell b) {
        return distances.squared[distances.index(a)] < distances.squared[distances.index(b)];
    });
    thinner.thinAnchors(byClearance);
    return thinner.result();
}
}  // namespace gr2to
