#include "gr2to/grid/VoronoiGraph.h"

#include <algorithm>
#include <unordered_map>

#include "base/forEachMarked.h"
#include "gr2to/grid/Thinning.h"

namespace gr2to
{
namespace
{
constexpr std::uint8_t kCurve = 1;
constexpr std::uint8_t kNode = 2;
constexpr std::uint8_t kDone = 4;

/** Follows the curves of a thinned mask from node to node. */
class Tracer
{
 public:
    explicit Tracer(Mask mask) : m_mask(std::move(mask)), m_steps(m_mask.neighbourSteps()) {}

    VoronoiGraph trace()
    {
        m_graph.width = m_mask.width();
        m_graph.height = m_mask.height();
        collectCells();
        for (const std::size_t i : m_curve)
            if (degree(i) != 2) addNode(i, degree(i));
        for (std::size_t n = 0; n < m_graph.nodes.size(); ++n) followFrom(n);
        for (const std::size_t i : m_curve)
            if (!(m_mask[i] & (kNode | kDone))) {
                addNode(i, 2);
                followFrom(m_graph.nodes.size() - 1);
            }
        return std::move(m_graph);
    }

 private:
    std::size_t stepped(std::size_t i, std::ptrdiff_t step) const
    {
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + step);
    }

    void collectCells()
    {
        for (int y = 0; y < m_mask.height(); ++y) {
            const std::size_t row = m_mask.index({0, y});
            const auto width = static_cast<std::size_t>(m_mask.width());
            forEachMarked(&m_mask[row], width, [&](std::size_t x) {
                m_curve.push_back(row + x);
                m_graph.cells.push_back(static_cast<std::uint32_t>(static_cast<std::size_t>(y) * width + x));
            });
        }
    }

    int degree(std::size_t i) const
    {
        int count = 0;
        for (std::size_t k = 0; k < 8; k += 2) count += m_mask[stepped(i, m_steps[k])] & kCurve;
        return count;
    }

    void addNode(std::size_t i, int nodeDegree)
    {
        m_mask[i] |= kNode;
        m_nodeAt.emplace(i, m_graph.nodes.size());
        m_graph.nodes.push_back({m_mask.cell(i), nodeDegree});
    }

    void followFrom(std::size_t node)
    {
        const std::size_t start = m_mask.index(m_graph.nodes[node].cell);
        for (std::size_t k = 0; k < 8; k += 2) {
            const std::size_t next = stepped(start, m_steps[k]);
            if (!m_mask[next] || (m_mask[next] & kDone)) continue;
            if (m_mask[next] & kNode) {
                if (next > start)
                    m_graph.edges.push_back(
                        {node, m_nodeAt.at(next), {m_mask.cell(start), m_mask.cell(next)}});
                continue;
            }
            m_graph.edges.push_back(followEdge(node, start, next));
        }
    }

    VoronoiEdge followEdge(std::size_t node, std::size_t previous, std::size_t current)
    {
        VoronoiEdge edge{node, node, {m_mask.cell(previous), m_mask.cell(current)}};
        while (!(m_mask[current] & kNode)) {
            m_mask[current] |= kDone;
            for (std::size_t k = 0; k < 8; k += 2) {
                const std::size_t next = stepped(current, m_steps[k]);
                if (!m_mask[next] || next == previous) continue;
                previous = current;
                current = next;
                break;
            }
            edge.cells.push_back(m_mask.cell(current));
        }
        edge.to = m_nodeAt.at(current);
        return edge;
    }

    Mask m_mask;
    std::array<std::ptrdiff_t, 8> m_steps;
    std::vector<std::size_t> m_curve;
    std::unordered_map<std::size_t, std::size_t> m_nodeAt;
    VoronoiGraph m_graph;
};
}  // namespace

VoronoiGraph traceGraph(Mask curves)
{
    return Tracer(std::move(curves)).trace();
}
}  // namespace gr2to
