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

std::vector<int> CurveCells::growCircles(const std::vector<Circle>& circles,
                                         const std::vector<bool>& blocked) const
{
    struct Entry
    {
        double cost;
        std::size_t cell;
        int circle;
    };
    std::vector<Entry> starts;
    for (std::size_t c = 0; c < circles.size(); ++c)
        if (const int i = find(circles[c].center); i >= 0)
            starts.push_back({-circles[c].radius_cells, static_cast<std::size_t>(i), static_cast<int>(c)});
    std::stable_sort(starts.begin(), starts.end(),
                     [](const Entry& a, const Entry& b) { return a.cost < b.cost; });
    // Every step costs 1, so what is queued comes in rising order of cost: two sorted lists replace a heap.
    std::vector<int> owner(size(), none());
    std::vector<Entry> queue;
    std::size_t nextStart = 0, nextQueued = 0;
    while (nextStart < starts.size() || nextQueued < queue.size()) {
        const bool takeStart =
            nextQueued == queue.size() ||
            (nextStart < starts.size() && starts[nextStart].cost <= queue[nextQueued].cost);
        const Entry entry = takeStart ? starts[nextStart++] : queue[nextQueued++];
        if (owner[entry.cell] != none() || blocked[entry.cell]) continue;
        owner[entry.cell] = entry.circle;
        for (const int n : m_neighbours[entry.cell])
            if (n >= 0 && owner[static_cast<std::size_t>(n)] == none())
                queue.push_back({entry.cost + 1.0, static_cast<std::size_t>(n), entry.circle});
    }
    return owner;
}

std::vector<int> CurveCells::floodCircles(const std::vector<Circle>& circles,
                                          const std::vector<bool>& blocked,
                                          const DistanceMap& distances) const
{
    struct Entry
    {
        std::int32_t squared;  //!< clearance of the cell
        std::size_t order;     //!< of equals the first that was queued
        std::size_t cell;
        int circle;

        bool operator<(const Entry& other) const
        {
            return squared != other.squared ? squared < other.squared : order > other.order;
        }
    };
    std::priority_queue<Entry> queue;
    std::size_t order = 0;
    const auto push = [&](std::size_t i, int circle) {
        queue.push({distances.squared[distances.index(cell(i))], order++, i, circle});
    };
    for (std::size_t c = 0; c < circles.size(); ++c)
        if (const int i = find(circles[c].center); i >= 0)
            push(static_cast<std::size_t>(i), static_cast<int>(c));
    std::vector<int> owner(size(), none());
    while (!queue.empty()) {
        const Entry entry = queue.top();
        queue.pop();
        if (owner[entry.cell] != none() || blocked[entry.cell]) continue;
        owner[entry.cell] = entry.circle;
        for (const int n : m_neighbours[entry.cell])
            if (n >= 0 && owner[static_cast<std::size_t>(n)] == none())
                push(static_cast<std::size_t>(n), entry.circle);
    }
    return owner;
}
}  // namespace gr2to
