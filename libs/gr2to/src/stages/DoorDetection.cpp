#include "gr2to/stages/DoorDetection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

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
        for (int y = 0; y < m_distances.height; ++y) {
            const std::int32_t* row = m_distances.squared.data() + m_distances.index({0, y});
            const bool innerRow = y >= m_reach && y + m_reach < m_distances.height;
            for (int x = 0; x < m_distances.width; ++x) {
                if (row[x] <= m_minSquared || row[x] >= m_maxSquared) continue;
                const bool inner = innerRow && x >= m_reach && x + m_reach < m_distances.width;
                if (m_hasOpposite[inner ? fartherAround(row + x) : fartherWithin({x, y})])
                    likely.push_back({x, y});
            }
        }
        return likely;
    }

 private:
    /** Which samples are farther from obstacles than the cell, a bit each; none may lie beyond the border. */
    unsigned fartherAround(const std::int32_t* here) const
    {
        unsigned farther = 0;
        for (unsigned i = 0; i < kSamples; ++i) farther |= (here[m_steps[i]] > *here ? 1U : 0U) << i;
        return farther;
    }

    /** The same near the border: samples beyond it are not farther. */
    unsigned fartherWithin(Cell c) const
    {
        const std::int32_t here = m_distances.squared[m_distances.index(c)];
        unsigned farther = 0;
        for (unsigned i = 0; i < kSamples; ++i) {
            const Cell sample{c.x + m_offsets[i].x, c.y + m_offsets[i].y};
            const bool inside = sample.x >= 0 && sample.y >= 0 && sample.x < m_distances.width &&
                                sample.y < m_distances.height;
            if (inside && m_distances.squared[m_distances.index(sample)] > here) farther |= 1U << i;
        }
        return farther;
    }

    const DistanceMap& m_distances;
    std::array<Cell, kSamples> m_offsets;
    int m_reach;
    std::array<bool, 1 << kSamples> m_hasOpposite;
    std::array<std::ptrdiff_t, kSamples> m_steps{};
    std::int32_t m_minSquared;  //!< cells with at most this are too narrow
    std::int32_t m_maxSquared;  //!< cells with at least this are too wide
};

/** Groups points whose chains of steps are closer than a radius, through square buckets. */
class Linker
{
 public:
    Linker(const std::vector<Cell>& cells, double radius)
        : m_cells(cells),
          m_squaredRadius(radius * radius),
          m_side(std::max(1, static_cast<int>(std::floor(radius / std::sqrt(2.0))))),
          m_reach(static_cast<int>(std::ceil(radius / m_side))),
          m_parent(cells.size())
    {
        std::iota(m_parent.begin(), m_parent.end(), std::size_t{0});
        for (std::size_t i = 0; i < cells.size(); ++i) m_buckets[key(cells[i])].push_back(i);
    }

    std::vector<std::vector<std::size_t>> groups()
    {
        for (std::size_t i = 0; i < m_cells.size(); ++i)
            if (const auto& bucket = m_buckets.at(key(m_cells[i])); bucket.front() == i) linkBucket(bucket);
        std::unordered_map<std::size_t, std::size_t> numberOf;
        std::vector<std::vector<std::size_t>> result;
        for (std::size_t i = 0; i < m_cells.size(); ++i) {
            const auto [entry, isNew] = numberOf.emplace(find(i), result.size());
            if (isNew) result.emplace_back();
            result[entry->second].push_back(i);
        }
        return result;
    }

 private:
    std::int64_t key(int bucketX, int bucketY) const
    {
        return std::int64_t{bucketY} * (std::int64_t{1} << 32) + bucketX;
    }
    std::int64_t key(Cell c) const { return key(c.x / m_side, c.y / m_side); }

    struct Box
    {
        int left, right, bottom, top;

        double squaredDistance(Cell c) const
        {
            const double dx = std::max({left - c.x, 0, c.x - right}),
                         dy = std::max({bottom - c.y, 0, c.y - top});
            return dx * dx + dy * dy;
        }
    };

    Box boxOf(const std::vector<std::size_t>& bucket) const
    {
        const Cell first = m_cells[bucket.front()];
        Box box{first.x, first.x, first.y, first.y};
        for (const std::size_t i : bucket) {
            box.left = std::min(box.left, m_cells[i].x);
            box.right = std::max(box.right, m_cells[i].x);
            box.top = std::max(box.top, m_cells[i].y);
        }
        return box;
    }

    std::size_t find(std::size_t i)
    {
        while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }

    bool close(std::size_t i, std::size_t j) const
    {
        const double dx = m_cells[i].x - m_cells[j].x, dy = m_cells[i].y - m_cells[j].y;
        return dx * dx + dy * dy < m_squaredRadius;
    }

    void linkBucket(const std::vector<std::size_t>& bucket)
    {
        const Cell at{m_cells[bucket.front()].x / m_side, m_cells[bucket.front()].y / m_side};
        for (int dy = 0; dy <= m_reach; ++dy)
            for (int dx = dy == 0 ? 0 : -m_reach; dx <= m_reach; ++dx) {
                const auto other = m_buckets.find(key(at.x + dx, at.y + dy));
                if (other != m_buckets.end()) linkPair(bucket, other->second);
            }
    }

    /** The cells of one bucket are all close to one another, so one close pair links two buckets whole. */
    void linkPair(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b)
    {
        if (&a == &b) {
            for (const std::size_t i : a) unite(a.front(), i);
            return;
        }
        if (find(a.front()) == find(b.front())) return;
        const Box box = boxOf(b);
        for (const std::size_t i : a) {
            if (box.squaredDistance(m_cells[i]) >= m_squaredRadius) continue;
            for (const std::size_t j : b)
                if (close(i, j)) return unite(i, j);
        }
    }

    void unite(std::size_t i, std::size_t j)
    {
        i = find(i);
        j = find(j);
        m_parent[std::max(i, j)] = std::min(i, j);
    }

    const std::vector<Cell>& m_cells;
    double m_squaredRadius;
    int m_side;
    int m_reach;
    std::vector<std::size_t> m_parent;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> m_buckets;
};

DoorCandidate makeCandidate(const std::vector<Cell>& cells, const std::vector<std::size_t>& members)
{
    DoorCandidate candidate;
    double meanX = 0, meanY = 0;
    for (const std::size_t i : members) {
        candidate.cells.push_back(cells[i]);
        meanX += cells[i].x;
        meanY += cells[i].y;
    }
    meanX /= static_cast<double>(members.size());
    meanY /= static_cast<double>(members.size());
    const auto distance = [&](Cell c) { return std::hypot(c.x - meanX, c.y - meanY); };
    candidate.center = *std::min_element(candidate.cells.begin(), candidate.cells.end(),
                                         [&](Cell a, Cell b) { return distance(a) < distance(b); });
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
        throw std::invalid_argument("door.max_width = " + std::to_string(max_width) +
                                    " m must exceed door.min_width = " + std::to_string(min_width) + " m");
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
    for (const auto& group : Linker(likely, minClearance).groups())
        candidates.push_back(makeCandidate(likely, group));
    return candidates;
}
}  // namespace gr2to
