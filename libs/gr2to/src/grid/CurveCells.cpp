#include "gr2to/grid/CurveCells.h"

#include <algorithm>
#include <queue>

namespace gr2to
{
CurveCells::CurveCells(const VoronoiGraph& voronoi) : m_voronoi(voronoi), m_neighbours(voronoi.cells.size())
{
    for (auto& neighbours : m_neighbours) neighbours.fill(none());
    const auto width = static_cast<std::uint32_t>(voronoi.width);
    const auto& cells = voronoi.cells;
    std::size_t above = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i + 1 < cells.size() && cells[i + 1] == cells[i] + 1 && cells[i + 1] % width != 0) {
            m_neighbours[i][0] = static_cast<int>(i + 1);
            m_neighbours[i + 1][2] = static_cast<int>(i);
        }
        while (above < cells.size() && cells[above] < cells[i] + width) ++above;
        if (above < cells.size() && cells[above] == cells[i] + width) {
            m_neighbours[i][1] = static_cast<int>(above);
            m_neighbours[above][3] = static_cast<int>(i);
        }
    }
}

int CurveCells::find(Cell c) const
{
    if (c.x < 0 || c.y < 0 || c.x >= m_voronoi.width || c.y >= m_voronoi.height) return none();
    const auto index = static_cast<std::uint32_t>(c.y) * static_cast<std::uint32_t>(m_voronoi.width) +
                       static_cast<std::uint32_t>(c.x);
    const auto at = std::lower_bound(m_voronoi.cells.begin(), m_voronoi.cells.end(), index);
    return at != m_voronoi.cells.end() && *at == index ? static_cast<int>(at - m_voronoi.cells.begin())
                                                       : none();
}

std::vector<int> CurveCells::parts(const std::vector<bool>& blocked, int* count) const
{
    std::vector<int> part(size(), -1);
    std::vector<std::size_t> stack;
    *count = 0;
    for (std::size_t seed = 0; seed < size(); ++seed) {
        if (blocked[seed] || part[seed] >= 0) continue;
        part[seed] = *count;
        stack.push_back(seed);
        while (!stack.empty()) {
            const std::size_t i = stack.back();
            stack.pop_back();
            for (const int n : m_neighbours[i]) {
                const auto j = static_cast<std::size_t>(n);
                if (n < 0 || blocked[j] || part[j] >= 0) continue;
                part[j] = *count;
                stack.push_back(j);
            }
        }
        ++*count;
    }
    return part;
}

std::vector<CurveCells::Start> CurveCells::startsByPart(const std::vector<Circle>& circles,
                                                        const std::vector<int>& partOf) const
{
    std::vector<Start> starts;
    for (std::size_t c = 0; c < circles.size(); ++c)
        if (const int i = find(circles[c].center); i >= 0 && partOf[static_cast<std::size_t>(i)] >= 0)
            starts.push_back({static_cast<std::size_t>(i), static_cast<int>(c)});
    std::stable_sort(starts.begin(), starts.end(),
                     [&](const Start& a, const Start& b) { return partOf[a.cell] < partOf[b.cell]; });
    return starts;
}

template <class GrowPart>
std::vector<int> CurveCells::growByPart(const std::vector<Circle>& circles, const std::vector<int>& partOf,
                                        const GrowPart& growPart) const
{
    const std::vector<Start> starts = startsByPart(circles, partOf);
    std::vector<int> owner(size(), none());
    for (auto first = starts.begin(); first != starts.end();) {
        const auto last = std::find_if(first, starts.end(), [&](const Start& start) {
            return partOf[start.cell] != partOf[first->cell];
        });
        growPart(std::vector<Start>(first, last), owner);
        first = last;
    }
    return owner;
}

std::vector<int> CurveCells::growCircles(const std::vector<Circle>& circles,
                                         const std::vector<int>& partOf) const
{
    struct Entry
    {
        double cost;
        Start at;
    };
    std::vector<Entry> queue;
    return growByPart(circles, partOf, [&](std::vector<Start> starts, std::vector<int>& owner) {
        const auto radius = [&](const Start& s) {
            return circles[static_cast<std::size_t>(s.circle)].radius_cells;
        };
        std::stable_sort(starts.begin(), starts.end(),
                         [&](const Start& a, const Start& b) { return radius(a) > radius(b); });
        // Every step costs 1, so what is queued comes in rising order of cost: two sorted lists replace a
        // heap.
        queue.clear();
        std::size_t nextStart = 0, nextQueued = 0;
        while (nextStart < starts.size() || nextQueued < queue.size()) {
            const bool takeStart =
                nextQueued == queue.size() ||
                (nextStart < starts.size() && -radius(starts[nextStart]) <= queue[nextQueued].cost);
            const Entry entry =
                takeStart ? Entry{-radius(starts[nextStart]), starts[nextStart]} : queue[nextQueued];
            ++(takeStart ? nextStart : nextQueued);
            if (owner[entry.at.cell] != none()) continue;
            owner[entry.at.cell] = entry.at.circle;
            for (const int n : m_neighbours[entry.at.cell])
                if (const auto j = static_cast<std::size_t>(n);
                    n >= 0 && partOf[j] >= 0 && owner[j] == none())
                    queue.push_back({entry.cost + 1.0, {j, entry.at.circle}});
        }
    });
}

std::vector<int> CurveCells::floodCircles(const std::vector<Circle>& circles, const std::vector<int>& partOf,
                                          const DistanceMap& distances) const
{
    struct Entry
    {
        std::int32_t squared;  //!< clearance of the cell
        std::size_t order;     //!< of equals the first that was queued
        Start at;

        bool operator<(const Entry& other) const
        {
            return squared != other.squared ? squared < other.squared : order > other.order;
        }
    };
    return growByPart(circles, partOf, [&](const std::vector<Start>& starts, std::vector<int>& owner) {
        std::priority_queue<Entry> queue;
        std::size_t order = 0;
        const auto push = [&](const Start& at) {
            queue.push({distances.squared[distances.index(cell(at.cell))], order++, at});
        };
        for (const Start& start : starts) push(start);
        while (!queue.empty()) {
            const Start at = queue.top().at;
            queue.pop();
            if (owner[at.cell] != none()) continue;
            owner[at.cell] = at.circle;
            for (const int n : m_neighbours[at.cell])
                if (const auto j = static_cast<std::size_t>(n);
                    n >= 0 && partOf[j] >= 0 && owner[j] == none())
                    push({j, at.circle});
        }
    });
}
}  // namespace gr2to
