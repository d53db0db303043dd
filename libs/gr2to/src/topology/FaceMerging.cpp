#include "gr2to/topology/FaceMerging.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <queue>

#include "gr2to/grid/Runs.h"

namespace gr2to
{
namespace
{
/** Faces: 4-connected parts of the free space without the cuts; the cuts' own cells then join a face beside them. */
std::vector<int> labelFaces(const ClassifiedGrid& grid, const std::vector<CandidateCut>& cuts, int* count)
{
    std::vector<std::uint8_t> isCut(grid.size(), 0);
    for (const CandidateCut& cut : cuts)
        for (const Cell c : cut.cells) isCut[grid.index(c)] = 1;
    Runs runs(grid.width(), grid.height(), Runs::Connectivity::Sides,
              [&](std::size_t i) { return grid[i] == CellState::Free && !isCut[i]; });
    std::vector<int> face(grid.size(), 0), number(runs.runs().size(), 0);
    *count = 0;
    for (std::size_t r = 0; r < number.size(); ++r) {
        const std::size_t root = runs.root(r);
        if (root == r) number[r] = ++*count;
        std::fill(face.begin() + runs.runs()[r].begin, face.begin() + runs.runs()[r].end, number[root]);
    }
    std::vector<Cell> rest;
    for (std::size_t i = 0; i < grid.size(); ++i)
        if (isCut[i]) rest.push_back(grid.cell(i));
    while (!rest.empty()) {
        std::vector<std::pair<std::size_t, int>> joins;
        std::vector<Cell> later;
        for (const Cell c : rest) {
            int f = 0;
            for (const Cell n : {Cell{c.x + 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x - 1, c.y}, Cell{c.x, c.y - 1}})
                if (f == 0 && grid.contains(n)) f = face[grid.index(n)];
            if (f) joins.emplace_back(grid.index(c), f);
            else later.push_back(c);
        }
        if (joins.empty()) {
            face[grid.index(later.front())] = ++*count;  // a spot of cut cells alone
            later.erase(later.begin());
        }
        for (const auto& [i, f] : joins) face[i] = f;
        rest.swap(later);
    }
    return face;
}

/** A stretch of a line of cells in one face. */
struct Stretch
{
    int begin, end;  // steps, end after the last
    int face;        // 0: not free
};

/** A cut as the merging sees it. */
struct CutView
{
    const CandidateCut* cut = nullptr;
    std::vector<Stretch> side[2];               // the faces just below and above, per step, over the cut
    std::vector<std::vector<Stretch>> rows[2];  // parallel lines below and above, by rising depth
    std::vector<int> shift[2];                  // of each parallel line
};

/** A piece of a cut between two faces. */
struct Piece
{
    std::size_t cut;
    int begin, end;
    int below, above;
};

class Merger
{
 public:
    Merger(const ClassifiedGrid& grid, const DistanceMap& distances, const std::vector<CandidateCut>& cuts, const FaceMergingRules& rules)
        : m_grid(grid), m_rules(rules)
    {
        int count = 0;
        m_face = labelFaces(grid, cuts, &count);
        m_parent.resize(static_cast<std::size_t>(count) + 1);
        std::iota(m_parent.begin(), m_parent.end(), 0);
        m_area.assign(m_parent.size(), 0);
        m_radius.assign(m_parent.size(), 0);
        for (std::size_t i = 0; i < m_face.size(); ++i)
            if (m_face[i]) {
                auto& r = m_radius[static_cast<std::size_t>(m_face[i])];
                if (m_rep.size() != m_parent.size()) m_rep.resize(m_parent.size());
                if (distances.squared[i] > r) m_rep[m_face[i]] = static_cast<int>(i);
                r = std::max(r, distances.squared[i]);
                ++m_area[static_cast<std::size_t>(m_face[i])];
            }
        m_piecesOf.resize(m_parent.size());
        for (const CandidateCut& cut : cuts) addCut(cut);
    }

    Regions merge()
    {
        mergeSmall(m_rules.minFace_m2, 0);
        mergeOpen();
        mergeSmall(m_rules.minPlace_m2, m_rules.minRadius_m);
        mergeOpen();
        if (std::getenv("MLOG")) for (int f = 1; f < static_cast<int>(m_parent.size()); ++f) if (find(f) == f) for (const auto& [o, ps] : neighbours(f)) if (f < o) log("K", f, o, score(f, o, ps));
        Regions regions;
        regions.ofCell.resize(m_face.size());
        std::vector<int> number(m_parent.size(), 0);
        for (std::size_t i = 0; i < m_face.size(); ++i) {
            if (!m_face[i]) continue;
            int& n = number[static_cast<std::size_t>(find(m_face[i]))];
            if (!n) n = ++regions.count;
            regions.ofCell[i] = n;
        }
        addBorders(number, regions);
        return regions;
    }

    /** Pieces of a cut that go on between the same two regions are one border. */
    void addBorders(const std::vector<int>& number, Regions& regions)
    {
        constexpr int gap = 2;
        for (std::size_t p = 0; p < m_pieces.size();) {
            const auto pairOf = [&](const Piece& piece) {
                return std::minmax({number[static_cast<std::size_t>(find(piece.below))], number[static_cast<std::size_t>(find(piece.above))]});
            };
            const Piece& first = m_pieces[p];
            const auto pair = pairOf(first);
            int end = first.end;
            std::size_t next = p + 1;
            while (next < m_pieces.size() && m_pieces[next].cut == first.cut && m_pieces[next].begin <= end + gap && pairOf(m_pieces[next]) == pair)
                end = m_pieces[next++].end;
            if (pair.first != pair.second) regions.borders.push_back(border(*m_cuts[first.cut].cut, pair.first, pair.second, first.begin, end));
            p = next;
        }
    }

    RegionBorder border(const CandidateCut& cut, int from, int to, int begin, int end) const
    {
        const LineDirection& d = cut.direction;
        RegionBorder result;
        result.from = from;
        result.to = to;
        result.jambA = d.cell(begin - 1, cut.row);
        result.jambB = d.cell(end, cut.row);
        result.length_cells = (end - begin) * d.stretch();
        for (const Cell c : cut.cells)
            if (d.step(c) >= begin && d.step(c) < end) result.cells.push_back(c);
        result.middle = result.cells[result.cells.size() / 2];
        return result;
    }

 private:
    int find(int f)
    {
        while (m_parent[static_cast<std::size_t>(f)] != f) {
            int& p = m_parent[static_cast<std::size_t>(f)];
            p = m_parent[static_cast<std::size_t>(p)];
            f = p;
        }
        return f;
    }

    int faceAt(const LineDirection& d, int step, int row) const
    {
        const Cell c = d.cell(step, row);
        return m_grid.contains(c) ? m_face[m_grid.index(c)] : 0;
    }

    std::vector<Stretch> stretches(const LineDirection& d, int row, int begin, int end) const
    {
        const int reach = static_cast<int>(20.0 / m_rules.resolution_m);
        int left = begin, right = end;
        while (begin - left < reach && faceAt(d, left - 1, row)) --left;
        while (right - end < reach && faceAt(d, right, row)) ++right;
        std::vector<Stretch> result;
        for (int t = left; t < right; ++t) {
            const int f = faceAt(d, t, row);
            if (!result.empty() && result.back().face == f) result.back().end = t + 1;
            else result.push_back({t, t + 1, f});
        }
        return result;
    }

    void addCut(const CandidateCut& cut)
    {
        const std::size_t index = m_cuts.size();
        const LineDirection& d = cut.direction;
        CutView view;
        view.cut = &cut;
        int begin = d.step(cut.cells.front()), end = begin;
        for (const Cell c : cut.cells) {
            begin = std::min(begin, d.step(c));
            end = std::max(end, d.step(c));
        }
        ++end;
        addPieces(index, cut, begin, end);
        const double rowsPerMetre = d.stretch() / m_rules.resolution_m;
        const double step = std::max(m_rules.minDepth_m, m_rules.resolution_m);
        for (int s = 0; s < 2; ++s)
            for (double depth = m_rules.minDepth_m; depth <= m_rules.maxDepth_m + 1e-9; depth += step) {
                const int rows = static_cast<int>(std::lround(depth * rowsPerMetre)) * (s ? 1 : -1);
                const int shift = static_cast<int>(std::lround(d.skew(rows)));
                view.rows[s].push_back(stretches(d, cut.row + rows, begin + shift, end + shift));
                view.shift[s].push_back(shift);
            }
        m_cuts.push_back(std::move(view));
    }

    /** Looks across the cut at each of its steps. */
    void addPieces(std::size_t index, const CandidateCut& cut, int begin, int end)
    {
        const LineDirection& d = cut.direction;
        constexpr int thickness = 3;
        Piece piece{index, begin, begin, 0, 0};
        const auto close = [&] {
            if (piece.below && piece.above && piece.below != piece.above && piece.end > piece.begin) {
                m_piecesOf[static_cast<std::size_t>(piece.below)].push_back(m_pieces.size());
                m_piecesOf[static_cast<std::size_t>(piece.above)].push_back(m_pieces.size());
                m_pieces.push_back(piece);
            }
        };
        for (int t = begin; t < end; ++t) {
            const int here = faceAt(d, t, cut.row);
            int below = 0, above = 0;
            // The cut's cells went to one of the sides; the first other face is the far side.
            for (int k = 1; k <= thickness && !(above = faceAt(d, t, cut.row + k)); ++k) {}
            for (int k = 1; k <= thickness && !(below = faceAt(d, t, cut.row - k)); ++k) {}
            if (above == below && here != above) above = 0;
            if (below != piece.below || above != piece.above) {
                close();
                piece = {index, t, t, below, above};
            }
            piece.end = t + 1;
        }
        close();
    }

    /** Longest walk in a region parallel to a cut, beside a piece of it [steps]. */
    int extent(const CutView& view, int s, int region, int begin, int end)
    {
        int longest = 0;
        for (std::size_t k = 0; k < view.rows[s].size(); ++k) {
            const int from = begin + view.shift[s][k], to = end + view.shift[s][k];
            int walkBegin = 0, walkEnd = 0;
            bool walking = false;
            const auto finish = [&] {
                if (walking && walkBegin < to && walkEnd > from) longest = std::max(longest, walkEnd - walkBegin);
                walking = false;
            };
            for (const Stretch& stretch : view.rows[s][k]) {
                if (stretch.face && find(stretch.face) == region) {
                    if (!walking) walkBegin = stretch.begin;
                    walking = true;
                    walkEnd = stretch.end;
                } else
                    finish();
            }
            finish();
        }
        return longest;
    }

    struct Score
    {
        double sum = 0;
        bool open = false;
        double ra = 0, rb = 0, length = 0;
        int kind = 0;
    };
    // RESEARCH
    void log(const char* what, int a, int b, const Score& s)
    {
        static const bool on = std::getenv("MLOG") != nullptr;
        if (on) std::fprintf(stderr, "D %s %d %d %d %.3f %.3f %.2f %.2f %.2f %.2f %.2f\n", what, m_rep[a], m_rep[b], s.kind, s.ra, s.rb, s.length * m_rules.resolution_m, m_area[a] * m_rules.resolution_m * m_rules.resolution_m, m_area[b] * m_rules.resolution_m * m_rules.resolution_m, radius(a) * m_rules.resolution_m, radius(b) * m_rules.resolution_m);
    }
    std::vector<int> m_rep;

    /** How open the border of two regions is: the most open of the cuts along it counts. */
    Score score(int a, int b, const std::vector<std::size_t>& pieces)
    {
        struct Along { int length = 0, begin = INT32_MAX, end = INT32_MIN; };
        std::map<std::pair<std::size_t, bool>, Along> along;  // cut, a is below
        for (const std::size_t p : pieces) {
            const Piece& piece = m_pieces[p];
            Along& at = along[{piece.cut, find(piece.below) == a}];
            at.length += piece.end - piece.begin;
            at.begin = std::min(at.begin, piece.begin);
            at.end = std::max(at.end, piece.end);
        }
        double longest = 0;
        for (const auto& [key, at] : along) longest = std::max(longest, at.length * m_cuts[key.first].cut->direction.stretch());
        Score worst;
        for (const auto& [key, at] : along) {
            const CutView& view = m_cuts[key.first];
            const double length = at.length * view.cut->direction.stretch();
            if (length < 0.5 * longest) continue;
            const int sideOfA = key.second ? 0 : 1;
            const double extentA = std::max(at.length, extent(view, sideOfA, a, at.begin, at.end));
            const double extentB = std::max(at.length, extent(view, 1 - sideOfA, b, at.begin, at.end));
            const double ra = at.length / extentA, rb = at.length / extentB;
            const bool open = isOpen(view.cut->kind == CutKind::CriticalLine && length * m_rules.resolution_m <= m_rules.door_m ? CutKind::WallRay : view.cut->kind, ra, rb, radius(a), radius(b));
            if ((open && !worst.open) || (open == worst.open && ra + rb > worst.sum)) worst = {ra + rb, open, ra, rb, length, static_cast<int>(view.cut->kind)};
        }
        return worst;
    }

    double radius(int f) const { return std::sqrt(static_cast<double>(m_radius[static_cast<std::size_t>(f)])); }

    bool isOpen(CutKind kind, double ra, double rb, double radiusA, double radiusB) const
    {
        const double maxSum = kind == CutKind::WallRay ? m_rules.maxSumRay : kind == CutKind::WallToWall ? m_rules.maxSumWall : m_rules.maxSumCritical;
        if (std::max(ra, rb) <= m_rules.maxRatio && ra + rb <= maxSum) return false;
        const bool mouth = std::min(ra, rb) <= m_rules.mouthRatio && std::min(radiusA, radiusB) <= m_rules.mouthContrast * std::max(radiusA, radiusB);
        return !mouth;
    }

    /** The regions that touch one, with the pieces of cuts between. */
    std::map<int, std::vector<std::size_t>> neighbours(int region)
    {
        std::map<int, std::vector<std::size_t>> result;
        for (const std::size_t p : m_piecesOf[static_cast<std::size_t>(region)]) {
            const int a = find(m_pieces[p].below), b = find(m_pieces[p].above);
            if (a != b) result[a == region ? b : a].push_back(p);
        }
        return result;
    }

    int unite(int a, int b)
    {
        auto& pa = m_piecesOf[static_cast<std::size_t>(a)];
        auto& pb = m_piecesOf[static_cast<std::size_t>(b)];
        if (pa.size() < pb.size()) { std::swap(a, b); }
        auto& big = m_piecesOf[static_cast<std::size_t>(a)];
        auto& small = m_piecesOf[static_cast<std::size_t>(b)];
        m_parent[static_cast<std::size_t>(b)] = a;
        if (m_radius[b] > m_radius[a]) m_rep[a] = m_rep[b];
        m_area[static_cast<std::size_t>(a)] += m_area[static_cast<std::size_t>(b)];
        m_radius[static_cast<std::size_t>(a)] = std::max(m_radius[static_cast<std::size_t>(a)], m_radius[static_cast<std::size_t>(b)]);
        big.insert(big.end(), small.begin(), small.end());
        small.clear();
        big.erase(std::remove_if(big.begin(), big.end(), [&](std::size_t p) { return find(m_pieces[p].below) == find(m_pieces[p].above); }), big.end());
        return a;
    }

    /** Regions below an area join the neighbour to which they are most open. */
    void mergeSmall(double area_m2, double radius_m)
    {
        const double minRadius = radius_m / m_rules.resolution_m;
        const double limit = area_m2 / (m_rules.resolution_m * m_rules.resolution_m);
        std::priority_queue<std::pair<std::int64_t, int>, std::vector<std::pair<std::int64_t, int>>, std::greater<>> queue;
        for (int f = 1; f < static_cast<int>(m_parent.size()); ++f)
            if (find(f) == f && (static_cast<double>(area(f)) < limit || radius(f) < minRadius)) queue.push({area(f), f});
        while (!queue.empty()) {
            const auto [size, f] = queue.top();
            queue.pop();
            if (find(f) != f || area(f) != size) continue;
            int best = 0;
            double bestSum = -1;
            for (const auto& [other, pieces] : neighbours(f)) {
                double length = 0;
                for (const std::size_t p : pieces) length += (m_pieces[p].end - m_pieces[p].begin) * m_cuts[m_pieces[p].cut].cut->direction.stretch();
                const double sum = length;
                if (sum > bestSum) bestSum = sum, best = other;
            }
            if (!best) continue;
            log("S", f, best, {});
            const int merged = unite(f, best);
            if (static_cast<double>(area(merged)) < limit || radius(merged) < minRadius) queue.push({area(merged), merged});
        }
    }

    std::int64_t area(int f) const { return m_area[static_cast<std::size_t>(f)]; }

    /** Merges across open borders, the most open first. */
    void mergeOpen()
    {
        struct Entry
        {
            double sum;
            int a, b;
            int versionA, versionB;
            bool operator<(const Entry& o) const { return sum != o.sum ? sum < o.sum : a != o.a ? a > o.a : b > o.b; }
        };
        std::priority_queue<Entry> queue;
        std::vector<int> version(m_parent.size(), 0);
        const auto push = [&](int a, int b, const std::vector<std::size_t>& pieces) {
            const Score s = score(a, b, pieces);
            if (s.open) queue.push({s.sum, a, b, version[static_cast<std::size_t>(a)], version[static_cast<std::size_t>(b)]});
        };
        for (int f = 1; f < static_cast<int>(m_parent.size()); ++f)
            if (find(f) == f)
                for (const auto& [other, pieces] : neighbours(f))
                    if (f < other) push(f, other, pieces);
        while (!queue.empty()) {
            const Entry e = queue.top();
            queue.pop();
            if (find(e.a) != e.a || find(e.b) != e.b || version[static_cast<std::size_t>(e.a)] != e.versionA || version[static_cast<std::size_t>(e.b)] != e.versionB)
                continue;
            if (std::getenv("MLOG")) log("M", e.a, e.b, score(e.a, e.b, neighbours(e.a)[e.b]));
            const int merged = unite(e.a, e.b);
            ++version[static_cast<std::size_t>(merged)];
            for (const auto& [other, pieces] : neighbours(merged)) push(merged, other, pieces);
        }
    }

    const ClassifiedGrid& m_grid;
    FaceMergingRules m_rules;
    std::vector<int> m_face;
    std::vector<int> m_parent;
    std::vector<std::int64_t> m_area;      // cells
    std::vector<std::int32_t> m_radius;    // largest squared clearance
    std::vector<CutView> m_cuts;
    std::vector<Piece> m_pieces;
    std::vector<std::vector<std::size_t>> m_piecesOf;
};
}  // namespace

Regions mergeFaces(const ClassifiedGrid& grid, const DistanceMap& distances, const std::vector<CandidateCut>& cuts,
                   const FaceMergingRules& rules)
{
    return Merger(grid, distances, cuts, rules).merge();
}
}  // namespace gr2to
