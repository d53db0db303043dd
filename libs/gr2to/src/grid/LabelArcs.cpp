#include "gr2to/grid/LabelArcs.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace gr2to
{
namespace
{
constexpr double kShort_cells = 0.25;  // how far from a corner that two cells share an arc leaves their sides
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/** The corner of four cells: the bottom-left one of cell (x, y). */
struct Corner
{
    int x = 0, y = 0;

    Eigen::Vector2d point() const { return {x - 0.5, y - 0.5}; }
};

constexpr std::array<int, 4> kStepX{1, 0, -1, 0}, kStepY{0, 1, 0, -1};  // of the directions, from the right

/** The corner beside one; directions count counter-clockwise. */
Corner moved(Corner c, int direction)
{
    const auto d = static_cast<std::size_t>(direction);
    return {c.x + kStepX[d], c.y + kStepY[d]};
}

/** The point on the way from a corner to the one beside it. */
Eigen::Vector2d pointAfter(Corner c, int direction, double cells)
{
    const auto d = static_cast<std::size_t>(direction);
    return c.point() + cells * Eigen::Vector2d(kStepX[d], kStepY[d]);
}

/** The labels around a corner and the ways that lead away from it. */
class Surroundings
{
 public:
    /** \param labels  counter-clockwise from the upper right */
    explicit Surroundings(const std::array<PlaceId, 4>& labels) : m_labels(labels)
    {
        for (int d = 0; d < 4; ++d) m_ways += isWay(d) ? 1 : 0;
        const bool even = labels[0] == labels[2], odd = labels[1] == labels[3];
        if (m_ways == 4 && (even || odd))
            m_joined = even && odd ? (labels[0] < labels[1] ? 0 : 1) : (even ? 0 : 1);
    }
    PlaceId left(int direction) const { return m_labels[static_cast<std::size_t>(direction)]; }
    PlaceId right(int direction) const { return m_labels[static_cast<std::size_t>((direction + 3) % 4)]; }
    bool isWay(int direction) const { return left(direction) != right(direction); }
    bool isNode() const { return m_ways > 2 && m_joined < 0; }

    /** Whether arcs pass here without meeting, around two cells over the corner. */
    bool isPassedTwice() const { return m_joined >= 0; }

    /** The way on for who came along a direction; not at nodes. */
    int wayOn(int direction) const
    {
        const int back = (direction + 2) % 4;
        if (!isPassedTwice()) {
            for (int turn = 1; turn < 4; ++turn)
                if (isWay((back + turn) % 4)) return (back + turn) % 4;
            return back;
        }
        const int around = back % 2 == m_joined ? (back + 3) % 4 : back;  // the cell on the way's inner side
        return back == around ? (around + 1) % 4 : around;
    }

 private:
    std::array<PlaceId, 4> m_labels;
    int m_ways = 0;
    int m_joined = -1;  //!< parity of the pair over the corner that is joined, -1: no pair is
};

/** The upright sides between cells of different labels, in raster order; what is beyond the image is 0. */
std::vector<std::uint32_t> uprightSides(const PlaceImage& image)
{
    constexpr std::size_t block = 4;  // labels that are compared at once
    std::vector<std::uint32_t> sides;
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
        const PlaceId* row = image.ids.data() + y * width;
        const auto add = [&](std::size_t x) {
            sides.push_back(static_cast<std::uint32_t>(y * (width + 1) + x));
        };
        if (row[0] != 0) add(0);
        for (std::size_t x = 1; x < width;) {
            if (x + block <= width && std::memcmp(row + x, row + x - 1, block * sizeof(PlaceId)) == 0) {
                x += block;
                continue;
            }
            if (row[x] != row[x - 1]) add(x);
            ++x;
        }
        if (row[width - 1] != 0) add(width);
    }
    return sides;
}

class ArcTracer
{
 public:
    explicit ArcTracer(const PlaceImage& image)
        : m_image(image),
          m_stride(static_cast<std::size_t>(image.width) + 1),
          m_traced(m_stride * static_cast<std::size_t>(image.height), false)
    {
    }

    LabelArcs trace()
    {
        const std::vector<std::uint32_t> sides = uprightSides(m_image);
        findNodes(sides);
        m_leaving.assign(4 * m_nodes.size(), kNone);
        for (std::size_t n = 0; n < m_nodes.size(); ++n)
            for (int d = 0; d < 4; ++d)
                if (m_leaving[4 * n + static_cast<std::size_t>(d)] == kNone &&
                    around(corner(m_nodes[n])).isWay(d))
                    traceFromNode(n, d);
        for (const std::uint32_t side : sides)
            if (!m_traced[side]) traceClosed(corner(side));
        linkRings();
        return std::move(m_result);
    }

 private:
    PlaceId labelAt(int x, int y) const
    {
        const bool inside = x >= 0 && y >= 0 && x < m_image.width && y < m_image.height;
        return inside ? m_image.at({x, y}) : PlaceId{0};
    }
    Surroundings around(Corner c) const
    {
        return Surroundings(
            {labelAt(c.x, c.y), labelAt(c.x - 1, c.y), labelAt(c.x - 1, c.y - 1), labelAt(c.x, c.y - 1)});
    }
    std::size_t index(Corner c) const
    {
        return static_cast<std::size_t>(c.y) * m_stride + static_cast<std::size_t>(c.x);
    }
    Corner corner(std::size_t index) const
    {
        return {static_cast<int>(index % m_stride), static_cast<int>(index / m_stride)};
    }

    /** Nodes have an upright side above or below. */
    void findNodes(const std::vector<std::uint32_t>& sides)
    {
        for (const std::uint32_t side : sides)
            for (const std::size_t end : {std::size_t{side}, side + m_stride})
                if (around(corner(end)).isNode()) m_nodes.push_back(end);
        std::sort(m_nodes.begin(), m_nodes.end());
        m_nodes.erase(std::unique(m_nodes.begin(), m_nodes.end()), m_nodes.end());
        for (const std::size_t n : m_nodes) m_result.nodes.push_back(corner(n).point());
    }

    /** Takes one step along a side and marks it when it is upright. */
    Corner step(Corner from, int direction)
    {
        const Corner to = moved(from, direction);
        if (direction % 2 == 1) m_traced[index(direction == 1 ? from : to)] = true;
        return to;
    }

    /** The direction of an arc after a corner, which it gets when it turns there. */
    static int turn(const Surroundings& here, Corner at, int direction, LabelArc& arc)
    {
        const int next = here.wayOn(direction);
        if (here.isPassedTwice()) {
            arc.points.push_back(pointAfter(at, (direction + 2) % 4, kShort_cells));
            arc.points.push_back(pointAfter(at, next, kShort_cells));
        } else if (next != direction)
            arc.points.push_back(at.point());
        return next;
    }

    LabelArc startedAt(Corner c, int direction) const
    {
        LabelArc arc;
        const Surroundings here = around(c);
        arc.left = here.left(direction);
        arc.right = here.right(direction);
        return arc;
    }

    void traceFromNode(std::size_t node, int direction)
    {
        const std::size_t number = m_result.arcs.size();
        Corner at = corner(m_nodes[node]);
        LabelArc arc = startedAt(at, direction);
        arc.points.push_back(at.point());
        m_leaving[4 * node + static_cast<std::size_t>(direction)] = 2 * number;
        for (;;) {
            at = step(at, direction);
            const Surroundings here = around(at);
            if (here.isNode()) break;
            direction = turn(here, at, direction, arc);
        }
        arc.points.push_back(at.point());
        const auto end = std::lower_bound(m_nodes.begin(), m_nodes.end(), index(at)) - m_nodes.begin();
        arc.from = static_cast<int>(node);
        arc.to = static_cast<int>(end);
        m_leaving[4 * static_cast<std::size_t>(end) + static_cast<std::size_t>((direction + 2) % 4)] =
            2 * number + 1;
        m_result.arcs.push_back(std::move(arc));
    }

    /** \param start  lower end of an upright side in the lowest row of the curve: a corner of it */
    void traceClosed(Corner start)
    {
        constexpr int up = 1;
        int direction = up;
        LabelArc arc = startedAt(start, up);
        Corner at = start;
        do {
            at = step(at, direction);
            direction = turn(around(at), at, direction, arc);
        } while (index(at) != index(start) || direction != up);
        arc.points.insert(arc.points.begin(), arc.points.back());
        m_result.arcs.push_back(std::move(arc));
    }

    PlaceId leftOf(std::size_t half) const
    {
        const LabelArc& arc = m_result.arcs[half / 2];
        return half % 2 == 0 ? arc.left : arc.right;
    }

    /** The next half arc around the label on the left. */
    std::size_t following(std::size_t half) const
    {
        const LabelArc& arc = m_result.arcs[half / 2];
        if (arc.isClosed()) return half;
        const auto node = static_cast<std::size_t>(half % 2 == 0 ? arc.to : arc.from);
        for (std::size_t way = 4 * node; way < 4 * node + 4; ++way)
            if (m_leaving[way] != kNone && leftOf(m_leaving[way]) == leftOf(half)) return m_leaving[way];
        return half;
    }

    void linkRings()
    {
        std::vector<bool> linked(2 * m_result.arcs.size(), false);
        for (std::size_t first = 0; first < linked.size(); ++first) {
            if (linked[first] || leftOf(first) == 0) continue;
            LabelRing ring;
            ring.label = leftOf(first);
            for (std::size_t half = first; !linked[half]; half = following(half)) {
                linked[half] = true;
                ring.sides.push_back({half / 2, half % 2 == 1});
                ring.area_cells += (half % 2 == 0 ? 1 : -1) * areaBeside(m_result.arcs[half / 2].points);
            }
            m_result.rings.push_back(std::move(ring));
        }
    }

    const PlaceImage& m_image;
    std::size_t m_stride;                //!< corners in a row
    std::vector<bool> m_traced;          //!< upright sides that are in an arc, by their lower corner
    std::vector<std::size_t> m_nodes;    //!< their corners, ascending
    std::vector<std::size_t> m_leaving;  //!< half arc that leaves each node in each direction
    LabelArcs m_result;
};
}  // namespace

double areaBeside(const std::vector<Eigen::Vector2d>& chain)
{
    double twice = 0;
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
        twice += chain[k].x() * chain[k + 1].y() - chain[k].y() * chain[k + 1].x();
    return twice / 2;
}

LabelArcs traceArcs(const PlaceImage& image)
{
    return ArcTracer(image).trace();
}
}  // namespace gr2to
