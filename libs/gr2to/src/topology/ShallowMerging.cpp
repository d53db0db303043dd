#include "gr2to/topology/ShallowMerging.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gr2to
{
namespace
{
/** Groups of circles; the largest circle stands for its group. */
class Groups
{
 public:
    explicit Groups(const std::vector<Circle>& circles) : m_circles(circles), m_parent(circles.size())
    {
        std::iota(m_parent.begin(), m_parent.end(), std::size_t{0});
    }

    std::size_t find(std::size_t i)
    {
        while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }

    void mergeAcross(const PlaceLink& link, double minDepth)
    {
        std::size_t larger = find(link.from), smaller = find(link.to);
        if (m_circles[smaller].radius_cells > m_circles[larger].radius_cells) std::swap(larger, smaller);
        if (link.clearance_cells > minDepth * m_circles[smaller].radius_cells) m_parent[smaller] = larger;
    }

 private:
    const std::vector<Circle>& m_circles;
    std::vector<std::size_t> m_parent;
};
}  // namespace

PlaceGraph mergeShallow(const PlaceGraph& graph, double minDepth)
{
    Groups groups(graph.circles);
    std::vector<PlaceLink> byWidth = graph.links;
    std::stable_sort(byWidth.begin(), byWidth.end(), [](const PlaceLink& a, const PlaceLink& b) {
        return a.clearance_cells > b.clearance_cells;
    });
    const auto hasLintel = [&](const PlaceLink& link) {
        return link.door >= 0 && graph.doors[static_cast<std::size_t>(link.door)].lintel;
    };
    for (const PlaceLink& link : byWidth)
        if (!hasLintel(link)) groups.mergeAcross(link, minDepth);

    PlaceGraph merged;
    std::vector<std::size_t> newIndex(graph.circles.size());
    for (std::size_t c = 0; c < graph.circles.size(); ++c)
        if (groups.find(c) == c) {
            newIndex[c] = merged.circles.size();
            merged.circles.push_back(graph.circles[c]);
        }
    const auto renumber = [&](std::size_t circle) { return newIndex[groups.find(circle)]; };
    for (const PlaceLink& link : graph.links) {
        PlaceLink kept = link;
        std::tie(kept.from, kept.to) = std::minmax({renumber(link.from), renumber(link.to)});
        if (kept.from == kept.to) continue;
        if (link.door >= 0) {
            kept.door = static_cast<int>(merged.doors.size());
            merged.doors.push_back(graph.doors[static_cast<std::size_t>(link.door)]);
        }
        merged.links.push_back(kept);
    }
    for (const PlaceBorder& border : graph.borders) {
        const auto [from, to] = std::minmax({renumber(border.from), renumber(border.to)});
        if (from != to) merged.borders.push_back({from, to, border.line});
    }
    for (const int circle : graph.circleOfCell)
        merged.circleOfCell.push_back(
            circle < 0 ? circle : static_cast<int>(renumber(static_cast<std::size_t>(circle))));
    return merged;
}
}  // namespace gr2to
