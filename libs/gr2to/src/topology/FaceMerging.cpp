#include "gr2to/topology/FaceMerging.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

#include "gr2to/topology/RegionContacts.h"
#include "gr2to/topology/RegionSets.h"

namespace gr2to
{
namespace
{
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
          m_resolution_m(grid.resolution_m()),
          m_sets(m_faces, distances, rules.directions),
          m_contacts(m_faces, grid.width()),
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
        mergeWeak();
        mergeSmall(m_rules.minPlace_cells, m_rules.minRadius_cells);
        mergeWeak();
        Regions regions;
        regions.ofCell.resize(m_faces.ofCell().size());
        std::vector<int> number(static_cast<std::size_t>(m_sets.size()), 0), numberOfFace = number;
        for (std::size_t i = 0; i < regions.ofCell.size(); ++i) {
            const int face = m_faces.ofCell()[i];
            if (face == 0) continue;
            int& n = numberOfFace[static_cast<std::size_t>(face)];
            if (n == 0) {
                int& ofRegion = number[static_cast<std::size_t>(m_sets.find(face))];
                if (ofRegion == 0) ofRegion = ++regions.count;
                n = ofRegion;
            }
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
        for (const auto& [other, contact] : m_contacts.of(region)) result[other];
        for (const std::size_t p : m_piecesOf[static_cast<std::size_t>(region)]) {
            const int a = m_sets.find(m_pieces[p].below), b = m_sets.find(m_pieces[p].above);
            if (const auto touched = result.find(a == region ? b : a); touched != result.end())
                touched->second.push_back(p);
        }
        return result;
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
            if (m_sets.isRegion(f) && isSmall(f)) queue.push({m_sets.cells(f), f});
        while (!queue.empty()) {
            const auto [cells, region] = queue.top();
            queue.pop();
            if (!m_sets.isRegion(region) || m_sets.cells(region) != cells) continue;
            int closest = 0;
            double longest = 0;
            for (const auto& [other, contact] : m_contacts.of(region))
                if (const double length = contact.length_cells(); length > longest) {
                    longest = length;
                    closest = other;
                }
            if (closest == 0) continue;
            const int merged = unite(region, closest);
            if (isSmall(merged)) queue.push({m_sets.cells(merged), merged});
        }
    }

    /** Merges across borders with too little evidence, the weakest first; whatever changed is measured anew.
     */
    void mergeWeak()
    {
        using Entry = std::tuple<double, int, int, int, int>;  // lack of evidence, regions, their versions
        std::priority_queue<Entry> queue;
        std::vector<int> version(static_cast<std::size_t>(m_sets.size()), 0);
        const auto versionOf = [&](int region) -> int& { return version[static_cast<std::size_t>(region)]; };
        const auto push = [&](int a, int b, const std::vector<std::size_t>& pieces) {
            if (const double lack = lackOfEvidence(a, b, pieces); lack > 0)
                queue.push({lack, -a, -b, versionOf(a), versionOf(b)});
        };
        for (int f = 1; f < m_sets.size(); ++f)
            if (m_sets.isRegion(f))
                for (const auto& [other, pieces] : neighboursOf(f))
                    if (f < other) push(f, other, pieces);
        while (!queue.empty()) {
            const auto [lack, minusA, minusB, versionA, versionB] = queue.top();
            queue.pop();
            const int a = -minusA, b = -minusB;
            if (!m_sets.isRegion(a) || !m_sets.isRegion(b) || versionOf(a) != versionA ||
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
        m_contacts.join(a, b);
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
        std::size_t cut = 0;
        bool aIsAbove = false;
        int length = 0, begin = INT32_MAX, end = INT32_MIN;  // steps
        double length_cells = 0;
    };

    /** The longest straight part of a border between two regions, and the length of all of it. */
    CutPart longestPart(int a, const std::vector<std::size_t>& pieces, double& total_cells)
    {
        std::map<std::pair<std::size_t, bool>, CutPart> parts;
        CutPart longest;
        total_cells = 0;
        for (const std::size_t p : pieces) {
            const CutPiece& piece = m_pieces[p];
            const bool aIsAbove = m_sets.find(piece.above) == a;
            CutPart& part = parts[{piece.cut, aIsAbove}];
            part.cut = piece.cut;
            part.aIsAbove = aIsAbove;
            part.length += piece.end - piece.begin;
            part.begin = std::min(part.begin, piece.begin);
            part.end = std::max(part.end, piece.end);
            part.length_cells = part.length * m_cuts[piece.cut].direction.stretch();
            total_cells += (piece.end - piece.begin) * m_cuts[piece.cut].direction.stretch();
            if (part.length_cells > longest.length_cells) longest = part;
        }
        return longest;
    }

    /** How much evidence a border is short of. Where regions touch without a cut between them nothing speaks
     * for one, but a spot where cuts cross is no border either. */
    double lackOfEvidence(int a, int b, const std::vector<std::size_t>& pieces)
    {
        constexpr double none = 1000;
        if (pieces.empty())
            return m_contacts.between(a, b).length_cells() > m_rules.walks.step_cells ? none : 0;
        return m_rules.minEvidence - borderEvidence(measure(a, b, pieces), m_rules.mouth);
    }

    BorderMeasures measure(int a, int b, const std::vector<std::size_t>& pieces)
    {
        BorderMeasures border;
        double total_cells = 0;
        const CutPart part = longestPart(a, pieces, total_cells);
        // Cuts side by side hide parts of each other: what the regions touch is longer then.
        const double hidden = std::max(1.0, m_contacts.between(a, b).length_cells() / total_cells);
        border.length_m = part.length_cells * hidden * m_resolution_m;
        border.total_m = total_cells * hidden * m_resolution_m;
        measureEnds(part, border);
        border.smaller = sideOf(a, part, part.aIsAbove, hidden);
        border.larger = sideOf(b, part, !part.aIsAbove, hidden);
        if (m_sets.cells(a) > m_sets.cells(b)) std::swap(border.smaller, border.larger);
        border.unionRectangularity = m_sets.rectangularity(a, b);
        return border;
    }

    BorderSide sideOf(int region, const CutPart& part, bool above, double hidden)
    {
        BorderSide side;
        const int walk = m_surroundings[part.cut].longestWalk(
            above, part.begin, part.end, [&](int face) { return m_sets.find(face) == region; });
        side.openness = hidden * part.length / std::max(hidden * part.length, static_cast<double>(walk));
        side.area_m2 = static_cast<double>(m_sets.cells(region)) * m_resolution_m * m_resolution_m;
        side.radius_m = m_sets.radius_cells(region) * m_resolution_m;
        side.rectangularity = m_sets.rectangularity(region);
        return side;
    }

    /** What stands at the ends of a part of a border: nothing of it where the part ends at another cut. */
    void measureEnds(const CutPart& part, BorderMeasures& border) const
    {
        constexpr int slack =
            3;  // steps: cells of a cut next to its ends may have the same face on both sides
        const CandidateCut& cut = m_cuts[part.cut];
        const auto [first, last] =
            std::minmax({cut.direction.step(cut.cells.front()), cut.direction.step(cut.cells.back())});
        const CutEnd low = part.begin <= first + slack ? cut.ends[0] : CutEnd();
        const CutEnd high = part.end > last - slack ? cut.ends[1] : CutEnd();
        border.shorterFin_m = std::min(low.fin_cells, high.fin_cells) * m_resolution_m;
        border.longerFin_m = std::max(low.fin_cells, high.fin_cells) * m_resolution_m;
        border.solidEnd = low.solid || high.solid;
        border.lintel = cut.lintel;
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
            if (pair.first == pair.second) continue;
            RegionBorder border = borderOn(m_cuts[first.cut], pair.first, pair.second, first.begin, end);
            if (!border.cells.empty()) regions.borders.push_back(std::move(border));
        }
    }

    static RegionBorder borderOn(const CandidateCut& cut, int from, int to, int begin, int end)
    {
        const LineDirection& d = cut.direction;
        RegionBorder border{
            from, to, d.cell(begin - 1, cut.row), d.cell(end, cut.row), {}, (end - begin) * d.stretch(), {}};
        for (const Cell c : cut.cells)
            if (d.step(c) >= begin && d.step(c) < end) border.cells.push_back(c);
        if (!border.cells.empty()) border.middle = border.cells[border.cells.size() / 2];
        border.lintel = cut.lintel;
        return border;
    }

    const std::vector<CandidateCut>& m_cuts;
    FaceMergingRules m_rules;
    FaceMap m_faces;
    double m_resolution_m;
    RegionSets m_sets;
    RegionContacts m_contacts;
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
