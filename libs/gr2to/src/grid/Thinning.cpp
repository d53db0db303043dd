#include "gr2to/grid/Thinning.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/forEachMarked.h"
#include "base/vectorised.h"
#include "gr2to/grid/SimpleCells.h"

namespace gr2to
{
namespace
{
/** Eight shifts apart, so that the bits of eight neighbours gather in two bytes of one number. */
constexpr std::uint16_t kFigure = 1U << 0U;
constexpr std::uint16_t kBusy = 1U << 8U;  //!< an anchor, or queued
constexpr std::uint16_t kStateBits = kFigure | kBusy;
constexpr int kMaxBucket = 0x3FFF;  // in the 14 other bits

/** Clearances that differ by less are removed first come, first served: in waves, which keeps them in order
 * too. */
constexpr float kBucketCells = 2.0F;
/** A wave takes a layer of one cell; a bucket opens when the one before has had time for its two layers and
 * for cells that had to wait for a neighbour. */
constexpr std::size_t kWavesPerBucket = 3;
/** Cells of a band of rows, and waves that follow one another closely from band to band: at two bytes a cell
 * the bands at work fit a cache of half a megabyte. */
constexpr std::size_t kBandCells = 1U << 15U, kWavesPerSweep = 8;

/** The bits of a cell that tell its bucket: seven above either state bit. */
std::uint16_t bucketBits(std::int32_t squaredClearance)
{
    const float clearance = std::sqrt(static_cast<float>(squaredClearance));
    const int bucket = std::min(static_cast<int>(clearance * (1.0F / kBucketCells)), kMaxBucket);
    return static_cast<std::uint16_t>((bucket & 0x7F) << 1 | (bucket & 0x3F80) << 2);
}

std::size_t bucketOf(unsigned cell)
{
    return (cell >> 1U & 0x7FU) | (cell >> 2U & 0x3F80U);
}

/** Buckets and figure bits of a row. The distance of cells that are not free is 0, and so is their bucket. */
GR2TO_VECTORISED
void startRow(const CellState* cells, const std::int32_t* squared, int width, std::uint16_t* out)
{
    for (int x = 0; x < width; ++x) out[x] = bucketBits(squared[x]);
    for (int x = 0; x < width; ++x)
        out[x] = static_cast<std::uint16_t>(out[x] | (cells[x] == CellState::Free ? kFigure : 0));
}

/** Marks the cells of a row that may be removed and have a neighbour that does not belong to the figure. */
GR2TO_VECTORISED
void markOuter(const std::uint16_t* middle, std::size_t stride, std::size_t width, std::uint8_t* outer)
{
    const std::uint16_t* below = middle - stride;
    const std::uint16_t* above = middle + stride;
    for (std::size_t x = 0; x < width; ++x) {
        const unsigned inner = *(below + x - 1) & below[x] & below[x + 1] & *(middle + x - 1) &
                               middle[x + 1] & *(above + x - 1) & above[x] & above[x + 1];
        const unsigned idle = middle[x] & ~(middle[x] >> 8U);  // bit kFigure, unless busy
        outer[x] = static_cast<std::uint8_t>(idle & ~inner & kFigure);
    }
}

/** The thinning in progress.
 *
 * Cells wait in buckets of similar clearance and are removed in waves, one set of buckets and queues for each
 * band of rows, so that the cells at work stay in the processor's cache.
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
            startRow(cells, squared, grid.width(), out);
        }
        m_bandCells = m_cells.stride() * std::max<std::size_t>(1, kBandCells / m_cells.stride());
        m_bands.resize(m_cells.size() / m_bandCells + 1);
    }

    void protect(const std::vector<Cell>& anchors)
    {
        for (const Cell c : anchors) m_cells[m_cells.index(c)] |= kBusy;
    }

    /** Removes all that is no anchor and not needed for the topology. */
    void thinAroundAnchors()
    {
        std::vector<std::uint8_t> outer(static_cast<std::size_t>(m_cells.width()));
        for (int y = 0; y < m_cells.height(); ++y) {
            const std::size_t row = m_cells.index({0, y});
            markOuter(&m_cells[row], m_cells.stride(), outer.size(), outer.data());
            forEachMarked(outer.data(), outer.size(),
                          [&](std::size_t x) { enqueue(row + x, row / m_bandCells, 0); });
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
            cell = static_cast<std::uint16_t>(cell & ~kBusy);
        }
        for (const Cell c : anchors)
            if (const std::size_t i = m_cells.index(c); (m_cells[i] & kStateBits) == kFigure)
                enqueue(i, i / m_bandCells, 0);
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
        std::vector<std::vector<std::uint32_t>> buckets;   //!< cells whose bucket is not open yet
        std::array<std::vector<std::uint32_t>, 2> queues;  //!< cells of even and of odd waves
    };

    /** One side neighbour, and no other cell of the figure but one of the corners beside it. */
    static bool isEnd(std::uint8_t ring)
    {
        if (__builtin_popcount(ring & 0x55U) != 1 || __builtin_popcount(ring) > 2) return false;
        const int side = __builtin_ctz(ring & 0x55U);
        return (ring & ~(1U << side | 1U << (side + 1) % 8 | 1U << (side + 7) % 8)) == 0;
    }

    /** Neighbours of a cell, a bit each around it. */
    struct Ring
    {
        unsigned figure = 0;  //!< those that belong to the figure
        unsigned idle = 0;    //!< those of them that may be queued and are not
    };

    Ring ring(std::size_t i) const
    {
        const std::uint16_t* at = &m_cells[i];
        unsigned bits = 0;
        for (unsigned k = 8; k-- > 0;) bits = 2 * bits + (at[m_steps[k]] & kStateBits);
        return {bits & 0xFFU, bits & ~(bits >> 8U) & 0xFFU};
    }

    /** Puts a cell into the queue of a wave, or into its bucket when that opens later. */
    void enqueue(std::size_t i, std::size_t b, std::size_t wave)
    {
        m_cells[i] |= kBusy;
        ++m_queued;
        Band& band = m_bands[b];
        const std::size_t bucket = bucketOf(m_cells[i]);
        const bool later = bucket > wave / kWavesPerBucket;
        if (later && bucket >= band.buckets.size()) band.buckets.resize(bucket + 1);
        auto& cells = later ? band.buckets[bucket] : band.queues[wave % 2];
        cells.push_back(static_cast<std::uint32_t>(i));
    }

    /** Runs waves until no cell is queued, a few of them in each sweep over the bands.
     *
     * A band takes its next wave as soon as the bands beside it have taken the last one: the result is the
     * same as if all bands took one wave after the other.
     */
    template <class Keep>
    void drain(const Keep& keep)
    {
        for (std::size_t firstWave = 0; m_queued > 0; firstWave += kWavesPerSweep)
            for (std::size_t step = 0; step < m_bands.size() + kWavesPerSweep - 1; ++step)
                for (std::size_t k = 0; k < std::min(step + 1, kWavesPerSweep); ++k)
                    if (step - k < m_bands.size()) runWave(step - k, firstWave + k, keep);
    }

    template <class Keep>
    void runWave(std::size_t b, std::size_t wave, const Keep& keep)
    {
        Band& band = m_bands[b];
        auto& queue = band.queues[wave % 2];
        if (const std::size_t bucket = wave / kWavesPerBucket;
            wave % kWavesPerBucket == 0 && bucket < band.buckets.size())
        {
            auto& opened = band.buckets[bucket];
            queue.insert(queue.end(), opened.begin(), opened.end());
            std::vector<std::uint32_t>().swap(opened);
        }
        const std::size_t first = b * m_bandCells, last = first + m_bandCells;
        for (const std::size_t i : queue) {
            m_cells[i] = static_cast<std::uint16_t>(m_cells[i] & ~kBusy);
            const Ring around = ring(i);
            const auto figure = static_cast<std::uint8_t>(around.figure);
            if (!m_simple[figure] || keep(figure)) continue;
            m_cells[i] = 0;
            for (unsigned left = around.idle; left != 0; left &= left - 1) {
                const std::ptrdiff_t step = m_steps[static_cast<unsigned>(__builtin_ctz(left))];
                const auto j = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + step);
                enqueue(j, j < first ? b - 1 : j < last ? b : b + 1, wave + 1);
            }
        }
        m_queued -= queue.size();
        queue.clear();
    }

    Padded<std::uint16_t> m_cells;  //!< figure and busy bits, and the bucket
    std::array<std::ptrdiff_t, 8> m_steps;
    const std::array<bool, 256>& m_simple;
    std::size_t m_bandCells = 0;
    std::vector<Band> m_bands;
    std::size_t m_queued = 0;  //!< cells in queues and buckets
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

Mask thin(const ClassifiedGrid& grid, const DistanceMap& distances, const std::vector<Cell>& anchors)
{
    Thinner thinner(grid, distances);
    thinner.protect(anchors);
    thinner.thinAroundAnchors();
    thinner.thinAnchors(sortedByClearance(anchors, distances));
    return thinner.result();
}
}  // namespace gr2to
