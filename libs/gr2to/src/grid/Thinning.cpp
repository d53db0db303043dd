#include "gr2to/grid/Thinning.h"

#include <algorithm>

namespace gr2to
{
namespace
{
constexpr std::uint8_t kFigure = 1;
constexpr std::uint8_t kAnchor = 2;
constexpr std::uint8_t kQueued = 4;

/** Buckets per cell of clearance: removal in the order of clearance to a quarter of a cell. */
constexpr float kBucketsPerCell = 4.0F;

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

/** The thinning in progress: cells wait in buckets of equal clearance. */
class Thinner
{
 public:
    Thinner(const ClassifiedGrid& grid, const DistanceMap& distances)
        : m_distances(distances),
          m_mask(grid.width(), grid.height()),
          m_steps(m_mask.neighbourSteps()),
          m_simple(simpleTable())
    {
        for (int y = 0; y < grid.height(); ++y) {
            const CellState* cells = grid.row(y);
            std::uint8_t* out = &m_mask[m_mask.index({0, y})];
            for (int x = 0; x < grid.width(); ++x)
                out[x] = cells[x] == CellState::Free ? kFigure : std::uint8_t{0};
        }
    }

    void protect(const std::vector<Cell>& anchors)
    {
        for (const Cell c : anchors) m_mask[m_mask.index(c)] |= kAnchor;
    }

    /** Removes all that is no anchor and not needed for the topology. */
    void thinAroundAnchors()
    {
        for (int y = 0; y < m_mask.height(); ++y) {
            const std::size_t row = m_mask.index({0, y});
            for (std::size_t i = row; i < row + static_cast<std::size_t>(m_mask.width()); ++i)
                if (m_mask[i] == kFigure && ring(i) != 0xFF) enqueue(i);
        }
        drain([](std::uint8_t) { return false; });
    }

    /** Thins the anchors too, but keeps the ends of curves. */
    void thinAnchors(const std::vector<Cell>& anchors)
    {
        for (const Cell c : anchors) m_mask[m_mask.index(c)] = kFigure;
        for (const Cell c : anchors) enqueue(m_mask.index(c));
        drain([](std::uint8_t ring) { return __builtin_popcount(ring & 0x55U) == 1 && isEnd(ring); });
    }

    Mask take() { return std::move(m_mask); }

 private:
    /** One side neighbour, and no other cell of the figure but the two corners beside it. */
    static bool isEnd(std::uint8_t ring)
    {
        for (int side = 0; side < 8; side += 2) {
            const unsigned allowed = 1U << side | 1U << (side + 1) % 8 | 1U << (side + 7) % 8;
            if ((ring >> side) & 1) return (ring & ~allowed) == 0 && __builtin_popcount(ring) <= 2;
        }
        return false;
    }

    std::uint8_t ring(std::size_t i) const
    {
        unsigned bits = 0;
        for (unsigned k = 0; k < 8; ++k)
            bits |= (m_mask[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + m_steps[k])] & kFigure)
                    << k;
        return static_cast<std::uint8_t>(bits);
    }

    void enqueue(std::size_t i)
    {
        const Cell c = m_mask.cell(i);
        const std::int32_t squared = m_distances.squared[m_distances.index(c)];
        const auto key = static_cast<std::size_t>(std::sqrt(static_cast<float>(squared)) * kBucketsPerCell);
        const std::size_t bucket = std::max(key, m_current);
        if (bucket >= m_buckets.size()) m_buckets.resize(bucket + 1);
        m_buckets[bucket].push_back(static_cast<std::uint32_t>(i));
        m_mask[i] |= kQueued;
    }

    template <class Keep>
    void drain(const Keep& keep)
    {
        for (m_current = 0; m_current < m_buckets.size(); ++m_current) {
            for (std::size_t k = 0; k < m_buckets[m_current].size(); ++k) {
                const std::size_t i = m_buckets[m_current][k];
                m_mask[i] = static_cast<std::uint8_t>(m_mask[i] & ~kQueued);
                const std::uint8_t around = ring(i);
                if (!m_simple[around] || keep(around)) continue;
                m_mask[i] = 0;
                for (const std::ptrdiff_t step : m_steps) {
                    const auto j = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + step);
                    if (m_mask[j] == kFigure) enqueue(j);
                }
            }
            std::vector<std::uint32_t>().swap(m_buckets[m_current]);
        }
        m_current = 0;
    }

    const DistanceMap& m_distances;
    Mask m_mask;
    std::array<std::ptrdiff_t, 8> m_steps;
    const std::array<bool, 256>& m_simple;
    std::vector<std::vector<std::uint32_t>> m_buckets;
    std::size_t m_current = 0;
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
    thinner.thinAnchors(anchors);
    return thinner.take();
}
}  // namespace gr2to
