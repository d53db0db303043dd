#include "gr2to/topology/FaceMerging.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>

namespace gr2to
{
namespace
{
/** Faces merged to regions; a region is named by one of its faces. */
class RegionSets
{
 public:
    RegionSets(const FaceMap& faces, const DistanceMap& distances)
        : m_parent(static_cast<std::size_t>(faces.count()) + 1),
          m_cells(m_parent.size()),
          m_squaredRadius(m_parent.size())
    {
        std::iota(m_parent.begin(), m_parent.end(), 0);
        const std::vector<int>& ofCell = faces.ofCell();
        for (std::size_t i = 0; i < ofCell.size(); ++i) {
            if (ofCell[i] == 0) continue;
            const auto f = static_cast<std::size_t>(ofCell[i]);
            ++m_cells[f];
            m_squaredRadius[f] = std::max(m_squaredRadius[f], distances.squared[i]);
        }
    }

    int size() const { return static_cast<int>(m_parent.size()); }
    int find(int face)
    {
        auto f = static_cast<std::size_t>(face);
        while (m_parent[f] != static_cast<int>(f))
            f = static_cast<std::size_t>(m_parent[f] = m_parent[static_cast<std::size_t>(m_parent[f])]);
        return static_cast<int>(f);
    }
    void join(int region, int other)
    {
        const auto a = static_cast<std::size_t>(region), b = static_cast<std::size_t>(other);
        m_parent[b] = region;
        m_cells[a] += m_cells[b];
        m_squaredRadius[a] = std::max(m_squaredRadius[a], m_squaredRadius[b]);
    }
    std::int64_t cells(int region) const { return m_cells[static_cast<std::size_t>(region)]; }
    double radius_cells(int region) const
    {
        return std::sqrt(static_cast<double>(m_squaredRadius[static_cast<std::size_t>(region)]));
    }

 private:
    std::vector<int> m_parent;
    std::vector<std::int64_t> m_cells;
    std::vector<std::int32_t> m_squaredRadius;
};

/** A piece of a cut between two faces. */
struct CutPiece : FaceMap::Piece
{
    std::size_t cut = 0;
};

class Merger
{
 public:
    Merger(const ClassifiedGrid& grid, const DistanceMap& distances, const std::vector<CandidateCut>& cuts,
           const FaceMergingRules& rules)
        : m_cuts(cuts),
          m_rules(rules),
          m_faces(grid, cuts),
          m_sets(m_faces, distances),
          m_piecesOf(static_cast<std::size_t>(m_sets.size()))
    {
        m_surroundings.reserve(cuts.size());
        for (std::size_t k = 0; k < cuts.size(); ++k) {
            m_surroundings.emplace_back(m_faces, cuts[k], rules.walks);
            for (const FaceMap::Piece& piece : m_faces.piecesOf(cuts[k])) {
                m_piecesOf[static_cast<std::size_t>(piece.below)].push_back(m_pieces.size());
                m_piecesOf[static_cast<std::size_t>(piece.above)].push_back(m_pieces.size());
                m_pieces.push_back({piece, k});
            }
        }
    }

    Regions merge()
    {
        mergeSmall(m_rules.minFace_cells, 0);
        mergeOpen();
        mergeSmall(m_rules.minPlace_cells, m_rules.minRadius_cells);
        mergeOpen();
        Regions regions;
        regions.ofCell.resize(m_faces.ofCell().size());
        std::vector<int> number(static_cast<std::size_t>(m_sets.size()), 0);
        for (std::size_t i = 0; i < regions.ofCell.size(); ++i) {
            if (m_faces.ofCell()[i] == 0) continue;
            int& n = number[static_cast<std::size_t>(m_sets.find(m_faces.ofCell()[i]))];
            if (n == 0) n = ++regions.count;
            regions.ofCell[i] = n;
        }
        addBorders(number, regions);
        return regions;
    }

 private:
    using Neighbours = std::map<int, std::vector<std::size_t>>;  // region, pieces of cuts towards it

    Neighbours neighboursOf(int region)
    {
        Neighbours result;
        for (const std::size_t p : m_piecesOf[static_cast<std::size_t>(region)]) {
            const int a = m_sets.find(m_pieces[p].below), b = m_sets.find(m_pieces[p].above);
            if (a != b) result[a == region ? b : a].push_back(p);
        }
        return result;
    }

    double length_cells(const CutPiece& piece) const
    {
        return (piece.end - piece.begin) * m_cuts[piece.cut].direction.stretch();
    }

    /** Small and narrow regions, from the smallest, join the neighbour that they touch most. */
    void mergeSmall(double minCells, double minRadius)
    {
        const auto isSmall = [&](int region) {
            return static_cast<double>(m_sets.cells(region)) < minCells ||
                   m_sets.radius_cells(region) < minRadius;
        };
        using Entry = std::pair<std::int64_t, int>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        for (int f = 1; f < m_sets.size(); ++f)
            if (m_sets.find(f) == f && isSmall(f)) queue.push({m_sets.cells(f), f});
        while (!queue.empty()) {
            const auto [cells, region] = queue.top();
            queue.pop();
            if (m_sets.find(region) != region || m_sets.cells(region) != cells) continue;
            int closest = 0;
            double longest = 0;
            for (const auto& [other, pieces] : neighboursOf(region)) {
                double length = 0;
                for (const std::size_t p : pieces) length += length_cells(m_pieces[p]);
                if (length > longest) {
                    longest = length;
                    closest = other;
                }
            }
            if (closest == 0) continue;
            const int merged = unite(region, closest);
            if (isSmall(merged)) queue.push({m_sets.cells(merged), merged});
        }
    }

    /** Merges across open borders, the most open first; whatever changed is measured anew. */
    void mergeOpen()
    {
        using Entry = std::tuple<double, int, int, int, int>;  // openness, regions and their versions
        std::priority_queue<Entry> queue;
        std::vector<int> version(static_cast<std::size_t>(m_sets.size()), 0);
        const auto versionOf = [&](int region) -> int& { return version[static_cast<std::size_t>(region)]; };
        const auto push = [&](int a, int b, const std::vector<std::size_t>& pieces) {
            if (const double openness = opennessIfOpen(a, b, pieces); openness > 0)
                queue.push({openness, -a, -b, versionOf(a), versionOf(b)});
        };
        for (int f = 1; f < m_sets.size(); ++f)
            if (m_sets.find(f) == f)
                for (const auto& [other, pieces] : neighboursOf(f))
                    if (f < other) push(f, other, pieces);
        while (!queue.empty()) {
            const auto [openness, minusA, minusB, versionA, versionB] = queue.top();
            queue.pop();
            const int a = -minusA, b = -minusB;
            if (m_sets.find(a) != a || m_sets.find(b) != b || versionOf(a) != versionA ||
                versionOf(b) != versionB)
                continue;
            const int merged = unite(a, b);
            ++versionOf(merged);
            for (const auto& [other, pieces] : neighboursOf(merged)) push(merged, other, pieces);
        }
    }

    int unite(int a, int b)
    {
        if (m_piecesOf[static_cast<std::size_t>(a)].size() < m_piecesOf[static_cast<std::size_t>(b)].size())
            std::swap(a, b);
        std::vector<std::size_t>& kept = m_piecesOf[static_cast<std::size_t>(a)];
        std::vector<std::size_t>& added = m_piecesOf[static_cast<std::size_t>(b)];
        m_sets.join(a, b);
        kept.insert(kept.end(), added.begin(), added.end());
        added.clear();
        kept.erase(std::remove_if(kept.begin(), kept.end(),
                                  [&](std::size_t p) {
                                      return m_sets.find(m_pieces[p].below) == m_sets.find(m_pieces[p].above);
                                  }),
                   kept.end());
        return a;
    }

    /** The part of a border that lies on one cut. */
    struct CutPart
    {
        int length = 0, begin = INT32_MAX, end = INT32_MIN;  // steps
    };

    /** Largest openness of the cuts along a border that are open; 0 when none is. Short parts of a border do
     * not count. */
    double opennessIfOpen(int a, int b, const std::vector<std::size_t>& pieces)
    {
        std::map<std::pair<std::size_t, bool>, CutPart> parts;  // by cut, and whether a is above
        double longest = 0;
        for (const std::size_t p : pieces) {
            const CutPiece& piece = m_pieces[p];
            CutPart& part = parts[{piece.cut, m_sets.find(piece.above) == a}];
            part.length += piece.end - piece.begin;
            part.begin = std::min(part.begin, piece.begin);
            part.end = std::max(part.end, piece.end);
            longest = std::max(longest, part.length * m_cuts[piece.cut].direction.stretch());
        }
        double openness = 0;
        for (const auto& [key, part] : parts) {
            const auto& [cut, aIsAbove] = key;
            if (part.length * m_cuts[cut].direction.stretch() < 0.5 * longest) continue;
            const double towardsA = opennessTowards(a, cut, aIsAbove, part),
                         towardsB = opennessTowards(b, cut, !aIsAbove, part);
            if (isOpen(m_cuts[cut].kind, towardsA, towardsB, m_sets.radius_cells(a), m_sets.radius_cells(b)))
                openness = std::max(openness, towardsA + towardsB);
        }
        return openness;
    }

    double opennessTowards(int region, std::size_t cut, bool above, const CutPart& part)
    {
        const int walk = m_surroundings[cut].longestWalk(
            above, part.begin, part.end, [&](int face) { return m_sets.find(face) == region; });
        return static_cast<double>(part.length) / std::max(part.length, walk);
    }

    bool isOpen(CutKind kind, double towardsA, double towardsB, double radiusA, double radiusB) const
    {
        const double maxSum = kind == CutKind::WallRay      ? m_rules.maxSumRay
                              : kind == CutKind::WallToWall ? m_rules.maxSumWall
                                                            : m_rules.maxSumCritical;
        if (std::max(towardsA, towardsB) <= m_rules.maxSide && towardsA + towardsB <= maxSum) return false;
        const bool isMouth = std::min(towardsA, towardsB) <= m_rules.mouthOpenness &&
                             std::min(radiusA, radiusB) <= m_rules.mouthContrast * std::max(radiusA, radiusB);
        return !isMouth;
    }

    /** Pieces of a cut that go on between the same two regions are one border. */
    void addBorders(const std::vector<int>& number, Regions& regions)
    {
        constexpr int gap = 2;  // steps
        const auto pairOf = [&](const CutPiece& piece) {
            const auto numberOf = [&](int face) {
                return number[static_cast<std::size_t>(m_sets.find(face))];
            };
            return std::minmax({numberOf(piece.below), numberOf(piece.above)});
        };
        for (std::size_t p = 0, next = 0; p < m_pieces.size(); p = next) {
            const CutPiece& first = m_pieces[p];
            const auto pair = pairOf(first);
            int end = first.end;
            for (next = p + 1; next < m_pieces.size() && m_pieces[next].cut == first.cut &&
                               m_pieces[next].begin <= end + gap && pairOf(m_pieces[next]) == pair;
                 ++next)
                end = m_pieces[next].end;
            if (pair.first != pair.second)
                regions.borders.push_back(
                    borderOn(m_cuts[first.cut], pair.first, pair.second, first.begin, end));
        }
    }

    static RegionBorder borderOn(const CandidateCut& cut, int from, int to, int begin, int end)
    {
        const LineDirection& d = cut.direction;
        RegionBorder border{
            from, to, d.cell(begin - 1, cut.row), d.cell(end, cut.row), {}, (end - begin) * d.stretch(), {}};
        for (const Cell c : cut.cells)
            if (d.step(c) >= begin && d.step(c) < end) border.cells.push_back(c);
        border.middle = border.cells[border.cells.size() / 2];
        return border;
    }

    const std::vector<CandidateCut>& m_cuts;
    FaceMergingRules m_rules;
    FaceMap m_faces;
    RegionSets m_sets;
    std::vector<CutSurroundings> m_surroundings;       // of each cut
    std::vector<CutPiece> m_pieces;                    // in the order of cuts and steps
    std::vector<std::vector<std::size_t>> m_piecesOf;  // of each region
};
}  // namespace

Regions mergeFaces(const ClassifiedGrid& grid, const DistanceMap& distances,
                   const std::vector<CandidateCut>& cuts, const FaceMergingRules& rules)
{
    return Merger(grid, distances, cuts, rules).merge();
}
}  // namespace gr2to
