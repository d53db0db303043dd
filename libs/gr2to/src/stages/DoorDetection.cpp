#include "gr2to/stages/DoorDetection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "base/forEachMarked.h"
#include "base/vectorised.h"
#include "gr2to/base/text.h"

namespace gr2to
{
namespace
{
constexpr int kSamples = 8;  // eq. (8)
constexpr double kPi = 3.14159265358979323846;

/** Offsets of the eight samples of eq. (8) to the nearest cell, symmetric under quarter turns and mirrors. */
std::array<Cell, kSamples> sampleOffsets(double radius_cells)
{
    std::array<Cell, kSamples> offsets;
    for (int i = 0; i < kSamples; ++i) {
        const double angle = 2.0 * kPi * i / kSamples;
        offsets[static_cast<std::size_t>(i)] = {
            static_cast<int>(std::lround(radius_cells * std::cos(angle))),
            static_cast<int>(std::lround(radius_cells * std::sin(angle)))};
    }
    return offsets;
}

/** For every set of samples (a bit each) whether two of it satisfy 2 < |i - j| < 6. */
std::array<bool, 1 << kSamples> makeOppositeTable()
{
    std::array<bool, 1 << kSamples> table{};
    for (unsigned set = 0; set < table.size(); ++set)
        for (int i = 0; i < kSamples; ++i)
            for (int j = i + 3; j < std::min(kSamples, i + 6); ++j)
                if ((set >> i & 1U) && (set >> j & 1U)) table[set] = true;
    return table;
}

/** For the cells from first to last of a row, which samples are farther from obstacles than they, a bit each.
 */
GR2TO_VECTORISED
void compareSamples(const std::int32_t* row, const std::array<std::ptrdiff_t, kSamples>& steps, int first,
                    int last, std::uint8_t* farther)
{
    for (int x = first; x < last; ++x) farther[x] = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {  // one sample at a time, to be vectorised
        const std::int32_t* sample = row + steps[i];
        const auto bit = static_cast<std::uint8_t>(1U << i);
        for (int x = first; x < last; ++x)
            farther[x] = static_cast<std::uint8_t>(farther[x] | (sample[x] > row[x] ? bit : 0));
    }
}

/** Clears the bits of cells that are too narrow or too wide for a door. */
GR2TO_VECTORISED
void keepBetween(const std::int32_t* row, int width, std::int32_t min, std::int32_t max,
                 std::uint8_t* farther)
{
    for (int x = 0; x < width; ++x) {
        const bool fits = static_cast<int>(row[x] > min) & static_cast<int>(row[x] < max);
        farther[x] = static_cast<std::uint8_t>(fits ? farther[x] : 0);
    }
}

/** The cells that satisfy eq. (8). */
class LikelyCells
{
 public:
    LikelyCells(const DistanceMap& distances, double minClearance, double maxClearance)
        : m_distances(distances),
          m_offsets(sampleOffsets(minClearance)),
          m_reach(std::max(m_offsets[0].x, m_offsets[1].x)),
          m_hasOpposite(makeOppositeTable()),
          m_minSquared(static_cast<std::int32_t>(std::floor(minClearance * minClearance))),
          m_maxSquared(
              static_cast<std::int32_t>(std::min<double>(std::ceil(maxClearance * maxClearance), INT32_MAX)))
    {
        for (std::size_t i = 0; i < kSamples; ++i)
            m_steps[i] = static_cast<std::ptrdiff_t>(m_offsets[i].y) * distances.width + m_offsets[i].x;
    }

    std::vector<Cell> find() const
    {
        std::vector<Cell> likely;
        std::vector<std::uint8_t> farther(static_cast<std::size_t>(m_distances.width));
        for (int y = 0; y < m_distances.height; ++y) {
            compareRow(y, farther);
            forEachMarked(farther.data(), farther.size(), [&](std::size_t x) {
                if (m_hasOpposite[farther[x]]) likely.push_back({static_cast<int>(x), y});
            });
        }
        return likely;
    }

 private:
    /** For each cell of a row, which samples are farther from obstacles than it, a bit each; none for cells
     * that are too narrow or too wide for a door. */
    void compareRow(int y, std::vector<std::uint8_t>& farther) const
    {
        const bool innerRow = y >= m_reach && y + m_reach < m_distances.height;
        const int first = innerRow ? std::min(m_reach, m_distances.width) : m_distances.width;
        const int last = std::max(first, m_distances.width - m_reach);
        for (int x = 0; x < first; ++x) farther[static_cast<std::size_t>(x)] = fartherWithin({x, y});
        const std::int32_t* row = m_distances.squared.data() + m_distances.index({0, y});
        compareSamples(row, m_steps, first, last, farther.data());
        for (int x = last; x < m_distances.width; ++x)
            farther[static_cast<std::size_t>(x)] = fartherWithin({x, y});
        keepBetween(row, m_distances.width, m_minSquared, m_maxSquared, farther.data());
    }

    /** The same for one cell near the border: samples beyond it are not farther. */
    std::uint8_t fartherWithin(Cell c) const
    {
        const std::int32_t here = m_distances.squared[m_distances.index(c)];
        unsigned farther = 0;
        for (unsigned i = 0; i < kSamples; ++i) {
            const Cell sample{c.x + m_offsets[i].x, c.y + m_offsets[i].y};
            const bool inside = sample.x >= 0 && sample.y >= 0 && sample.x < m_distances.width &&
                                sample.y < m_distances.height;
            if (inside && m_distances.squared[m_distances.index(sample)] > here) farther |= 1U << i;
        }
        return static_cast<std::uint8_t>(farther);
    }

    const DistanceMap& m_distances;
    std::array<Cell, kSamples> m_offsets;
    int m_reach;
    std::array<bool, 1 << kSamples> m_hasOpposite;
    std::array<std::ptrdiff_t, kSamples> m_steps{};
    std::int32_t m_minSquared;  //!< cells with at most this are too narrow
    std::int32_t m_maxSquared;  //!< cells with at least this are too wide
};

/** Groups cells that chains of steps shorter than a radius join, through square buckets. */
class Linker
{
 public:
    Linker(const std::vector<Cell>& cells, double radius, int width, int height)
        : m_cells(cells),
          m_squaredRadius(radius * radius),
          m_side(std::max(1, static_cast<int>(std::floor(radius / std::sqrt(2.0))))),
          m_reach(static_cast<int>(std::ceil(radius / m_side))),
          m_columns(width / m_side + 1),
          m_rows(height / m_side + 1),
          m_first(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows), -1),
          m_next(cells.size(), -1),
          m_parent(cells.size())
    {
        std::iota(m_parent.begin(), m_parent.end(), 0);
        for (std::size_t i = cells.size(); i-- > 0;) {
            int& first = m_first[bucket(cells[i].x / m_side, cells[i].y / m_side)];
            m_next[i] = std::exchange(first, static_cast<int>(i));
        }
    }

    std::vector<std::vector<std::size_t>> groups()
    {
        for (std::size_t i = 0; i < m_cells.size(); ++i) {
            const Cell at{m_cells[i].x / m_side, m_cells[i].y / m_side};
            if (m_first[bucket(at.x, at.y)] == static_cast<int>(i)) linkBucket(at);
        }
        std::vector<int> numberOf(m_cells.size(), -1);
        std::vector<std::vector<std::size_t>> result;
        for (std::size_t i = 0; i < m_cells.size(); ++i) {
            int& number = numberOf[index(find(static_cast<int>(i)))];
            if (number < 0) {
                number = static_cast<int>(result.size());
                result.emplace_back();
            }
            result[index(number)].push_back(i);
        }
        return result;
    }

 private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    std::size_t bucket(int x, int y) const { return index(y) * index(m_columns) + index(x); }
    const Cell& cell(int i) const { return m_cells[index(i)]; }

    int find(int i)
    {
        while (m_parent[index(i)] != i) i = m_parent[index(i)] = m_parent[index(m_parent[index(i)])];
        return i;
    }

    void unite(int i, int j)
    {
        i = find(i);
        j = find(j);
        m_parent[index(std::max(i, j))] = std::min(i, j);
    }

    bool close(Cell a, Cell b) const
    {
        const double dx = a.x - b.x, dy = a.y - b.y;
        return dx * dx + dy * dy < m_squaredRadius;
    }

    /** The cells of one bucket are all close to one another. */
    void linkBucket(Cell at)
    {
        const int first = m_first[bucket(at.x, at.y)];
        for (int i = m_next[index(first)]; i >= 0; i = m_next[index(i)]) unite(first, i);
        for (int dy = -m_reach; dy <= 0; ++dy)
            for (int dx = -m_reach; dx <= (dy == 0 ? -1 : m_reach); ++dx) {
                const Cell other{at.x + dx, at.y + dy};
                if (other.x < 0 || other.y < 0 || other.x >= m_columns) continue;
                const int there = m_first[bucket(other.x, other.y)];
                if (there >= 0 && find(there) != find(first)) linkPair(first, there, other);
            }
    }

    /** One close pair links two buckets whole. */
    void linkPair(int a, int b, Cell bucketOfB)
    {
        const int left = bucketOfB.x * m_side, bottom = bucketOfB.y * m_side;
        for (int i = a; i >= 0; i = m_next[index(i)]) {
            const Cell c = cell(i);
            const Cell nearest{std::clamp(c.x, left, left + m_side - 1),
                               std::clamp(c.y, bottom, bottom + m_side - 1)};
            if (!close(c, nearest)) continue;
            for (int j = b; j >= 0; j = m_next[index(j)])
                if (close(c, cell(j))) return unite(i, j);
        }
    }

    const std::vector<Cell>& m_cells;
    double m_squaredRadius;
    int m_side;
    int m_reach;
    int m_columns;
    int m_rows;
    std::vector<int> m_first;  //!< first cell of each bucket, -1 for none
    std::vector<int> m_next;   //!< next cell of the same bucket
    std::vector<int> m_parent;
};

DoorCandidate makeCandidate(const std::vector<Cell>& cells, const std::vector<std::size_t>& members,
                            double maxClearance)
{
    DoorCandidate candidate;
    candidate.maxClearance_cells = maxClearance;
    double meanX = 0, meanY = 0;
    for (const std::size_t i : members) {
        candidate.cells.push_back(cells[i]);
        meanX += cells[i].x;
        meanY += cells[i].y;
    }
    meanX /= static_cast<double>(members.size());
    meanY /= static_cast<double>(members.size());
    const auto squared = [&](Cell c) {
        return (c.x - meanX) * (c.x - meanX) + (c.y - meanY) * (c.y - meanY);
    };
    double nearest = std::numeric_limits<double>::infinity();
    for (const Cell c : candidate.cells)
        if (squared(c) < nearest) {
            nearest = squared(c);
            candidate.center = c;
        }
    return candidate;
}
}  // namespace

std::vector<OptionField> TDoorOptions::fields()
{
    return {{"min_width", &min_width, "m", "Narrowest door, Door_min of the paper.", 0.1, 5},
            {"max_width", &max_width, "m", "Widest door, Door_max of the paper.", 0.1, 20}};
}

void TDoorOptions::checkRules() const
{
    if (max_width <= min_width)
        throw std::invalid_argument("door.max_width = " + numberText(max_width) +
                                    " m must exceed door.min_width = " + numberText(min_width) + " m");
}

DoorDetector::DoorDetector(TDoorOptions options) : m_options(std::move(options))
{
    m_options.check();
}

std::vector<DoorCandidate> DoorDetector::detect(const ClassifiedGrid& grid,
                                                const DistanceMap& distances) const
{
    const double minClearance = m_options.min_width / (2 * grid.resolution_m());
    const double maxClearance = m_options.max_width / (2 * grid.resolution_m());
    const std::vector<Cell> likely = LikelyCells(distances, minClearance, maxClearance).find();
    std::vector<DoorCandidate> candidates;
    for (const auto& group : Linker(likely, minClearance, grid.width(), grid.height()).groups())
        candidates.push_back(makeCandidate(likely, group, maxClearance));
    return candidates;
}
}  // namespace gr2to
