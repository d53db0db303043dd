#include "gr2to/grid/Thinning.h"

#include <algorithm>
#include <numeric>

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
/** Cells of a band of rows: at two bytes a cell a band and its queue fit a cache of half a megabyte. */
constexpr std::size_t kBandCells = 1U << 17U;

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
 * Cells wait in buckets of similar clearance, one set of buckets for each band of rows. All bands finish a
 * wave before the next begins, but one band after the other, so that a band's cells stay in the processor's
 * cache. A band that ran ahead by more than a wave would leave curves along its border.
 */
class Thinner
{
 public:
    Thinner(const ClassifiedGrid& grid, const DistanceMap& distances)
        : m_cells(grid.width(), grid.height()), m_steps(m_cells.neighbourSteps()), m_simple(simpleTable())
    {
        for (int y = 0; y < grid.height(); ++y) {
            const CellState* cells = grid.row(y);
            const std::int32_t* squared = distances.squared.data() + grid.index({0, y});
            std::uint16_t* out = &m_cells[m_cells.index({0, y})];
            // The distance of cells that are not free is 0, and so is their bucket.
            for (int x = 0; x < grid.width(); ++x) out[x] = bucketOf(squared[x]);
            for (int x = 0; x < grid.width(); ++x)
                out[x] = static_cast<std::uint16_t>(out[x] | (cells[x] == CellState::Free ? kFigure : 0));
        }
        m_bandCells = m_cells.stride() * std::max<std::size_t>(1, kBandCells / m_cells.stride());
        m_bands.resize(m_cells.size() / m_bandCells + 1);
    }

    void protect(const std::vector<Cell>& anchors)
    {
        for (const Cell c : anchors) m_cells[m_cells.index(c)] |= kAnchor;
    }

    /** Removes all that is no anchor and not needed for the topology. */
    void thinAroundAnchors()
    {
        std::vector<std::uint16_t> inner(static_cast<std::size_t>(m_cells.width()));
        for (int y = 0; y < m_cells.height(); ++y) {
            const std::size_t row = m_cells.index({0, y});
            markInner(row, inner);
            for (std::size_t x = 0; x < inner.size(); ++x)
                if (!(inner[x] & kFigure) && (m_cells[row + x] & kStateBits) == kFigure)
                    enqueue(row + x, row / m_bandCells);
        }
        drain([](std::uint8_t) { return false; });
    }

    /** Thins the anchors too, but keeps the ends of curves.
     * \param anchors  in the order in which they shall be tried
     */
    void thinAnchors(const std::vector<Cell>& anchors)
    {
        for (const Cell c : anchors) {
            std::uint16_t& cell = m_cells[m_cells.index(c)];
            cell = static_cast<std::uint16_t>(cell & ~kAnchor);
        }
        for (const Cell c : anchors)
            if (const std::size_t i = m_cells.index(c); (m_cells[i] & kStateBits) == kFigure)
                enqueue(i, i / m_bandCells);
        drain(isEnd);
    }

    Mask result() const
    {
        Mask mask(m_cells.width(), m_cells.height());
        for (int y = 0; y < mask.height(); ++y) {
            const std::uint16_t* row = &m_cells[m_cells.index({0, y})];
            std::uint8_t* out = &mask[mask.index({0, y})];
            for (int x = 0; x < mask.width(); ++x) out[x] = static_cast<std::uint8_t>(row[x] & kFigure);
        }
        return mask;
    }

 private:
    struct Band
    {
        std::vector<std::vector<std::uint32_t>> buckets;
        std::vector<std::uint32_t> working;  //!< cells of the current wave
        std::vector<std::uint32_t> next;     //!< cells of the next wave
    };

    static std::uint16_t bucketOf(std::int32_t squaredClearance)
    {
        const float bucket = std::sqrt(static_cast<float>(squaredClearance)) * (1.0F / kBucketCells);
        return static_cast<std::uint16_t>(std::min(static_cast<int>(bucket), kMaxBucket) << kBucketShift);
    }

    /** One side neighbour, and no other cell of the figure but one of the corners beside it. */
    static bool isEnd(std::uint8_t ring)
    {
        if (__builtin_popcount(ring & 0x55U) != 1 || __builtin_popcount(ring) > 2) return false;
        const int side = __builtin_ctz(ring & 0x55U);
        return (ring & ~(1U << side | 1U << (side + 1) % 8 | 1U << (side + 7) % 8)) == 0;
    }

    /** Sets the figure bit of `inner` for the cells of a row whose eight neighbours all belong to the figure.
     */
    void markInner(std::size_t row, std::vector<std::uint16_t>& inner) const
    {
        const std::uint16_t* middle = &m_cells[row];
        const std::uint16_t* below = middle - m_cells.stride();
        const std::uint16_t* above = middle + m_cells.stride();
        for (std::size_t x = 0; x < inner.size(); ++x)
            inner[x] =
                static_cast<std::uint16_t>(*(below + x - 1) & below[x] & below[x + 1] & *(middle + x - 1) &
                                           middle[x + 1] & *(above + x - 1) & above[x] & above[x + 1]);
    }

    std::uint8_t ring(std::size_t i) const
    {
        const std::uint16_t* at = &m_cells[i];
        unsigned bits = 0;
        for (unsigned k = 0; k < 8; ++k) bits |= (at[m_steps[k]] & kFigure) << k;
        return static_cast<std::uint8_t>(bits);
    }

    void enqueue(std::size_t i, std::size_t b)
    {
        m_cells[i] |= kQueued;
        Band& band = m_bands[b];
        const std::size_t bucket = m_cells[i] >> kBucketShift;
        if (bucket <= m_current) {
            if (band.next.empty()) m_waiting.push_back(b);
            band.next.push_back(static_cast<std::uint32_t>(i));
            return;
        }
        if (bucket >= band.buckets.size()) band.buckets.resize(bucket + 1);
        band.buckets[bucket].push_back(static_cast<std::uint32_t>(i));
        m_highest = std::max(m_highest, bucket);
    }

    template <class Keep>
    void drain(const Keep& keep)
    {
        for (m_current = 0; m_current <= m_highest; ++m_current) {
            for (std::size_t b = 0; b < m_bands.size(); ++b) takeBucket(b);
            while (!m_waiting.empty()) {
                std::vector<std::size_t> bands;
                bands.swap(m_waiting);
                for (const std::size_t b : bands) m_bands[b].working.swap(m_bands[b].next);
                for (const std::size_t b : bands) drainBand(b, keep);
            }
        }
        m_current = 0;
        m_highest = 0;
    }

    void takeBucket(std::size_t b)
    {
        Band& band = m_bands[b];
        if (m_current >= band.buckets.size() || band.buckets[m_current].empty()) return;
        if (band.next.empty()) m_waiting.push_back(b);
        auto& bucket = band.buckets[m_current];
        band.next.insert(band.next.end(), bucket.begin(), bucket.end());
        std::vector<std::uint32_t>().swap(bucket);
    }

    template <class Keep>
    void drainBand(std::size_t b, const Keep& keep)
    {
        Band& band = m_bands[b];
        const std::size_t first = b * m_bandCells, last = first + m_bandCells;
        // The queue grows while it is walked.
        for (const std::size_t i : band.working) {
            m_cells[i] = static_cast<std::uint16_t>(m_cells[i] & ~kQueued);
            const std::uint8_t around = ring(i);
            if (!m_simple[around] || keep(around)) continue;
            m_cells[i] = 0;
            for (unsigned left = around; left != 0; left &= left - 1) {
                const std::ptrdiff_t step = m_steps[static_cast<unsigned>(__builtin_ctz(left))];
                const auto j = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + step);
                if ((m_cells[j] & kStateBits) == kFigure)
                    enqueue(j, j < first ? b - 1 : j < last ? b : b + 1);
            }
        }
        band.working.clear();
    }

    Padded<std::uint16_t> m_cells;  //!< figure, anchor and queued bits, and the bucket above them
    std::array<std::ptrdiff_t, 8> m_steps;
    const std::array<bool, 256>& m_simple;
    std::size_t m_bandCells = 0;
    std::vector<Band> m_bands;
    std::vector<std::size_t> m_waiting;  //!< bands with cells of the current bucket
    std::size_t m_current = 0;
    std::size_t m_highest = 0;
};
/** Cells by whole cells of clearance, in the given order where it is the same. */
std::vector<Cell> sortedByClearance(const std::vector<Cell>& cells, const DistanceMap& distances)
{
    const auto rank = [&](Cell c) { return static_cast<std::size_t>(distances.clearance_cells(c)); };
    std::vector<std::size_t> start(2, 0);
    for (const Cell c : cells) {
        if (rank(c) + 2 > start.size()) start.resize(rank(c) + 2, 0);
        ++start[rank(c) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<Cell> sorted(cells.size());
    for (const Cell c : cells) sorted[start[rank(c)]++] = c;
    return sorted;
}
}  // namespace

bool isSimple(std::uint8_t neighbours)
{
    return simpleTable()[neighbours];
}

Mask thin(const ClassifiedGrid& grid, const DistanceMap& distances, const std::vector<Cell>& anchors)
{
    Thinner thinner(grid, distances);
    thinner.protect(anchors);
    thinner.thinAroundAnchors();
    thinner.thinAnchors(sortedByClearance(anchors, distances));
    return thinner.result();
}
}  // namespace gr2to
