#include "gr2to/grid/CurveCells.h"

#include <algorithm>
#include <queue>
#include <tuple>

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
    using Entry =
        std::tuple<double, std::size_t, int>;  // cost, cell, circle: ties go to the first cell and circle
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::size_t c = 0; c < circles.size(); ++c)
        if (const int i = find(circles[c].center); i >= 0)
            queue.emplace(-circles[c].radius_cells, static_cast<std::size_t>(i), static_cast<int>(c));
    std::vector<int> owner(size(), none());
    while (!queue.empty()) {
        const auto [cost, i, circle] = queue.top();
        queue.pop();
        if (owner[i] != none() || blocked[i]) continue;
        owner[i] = circle;
        for (const int n : m_neighbours[i])
            if (n >= 0 && owner[static_cast<std::size_t>(n)] == none())
                queue.emplace(cost + 1.0, static_cast<std::size_t>(n), circle);
    }
    return owner;
}
}  // namespace gr2to
