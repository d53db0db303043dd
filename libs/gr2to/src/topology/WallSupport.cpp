#include "gr2to/topology/WallSupport.h"

#include <algorithm>
#include <cmath>

#include "gr2to/grid/Jambs.h"

namespace gr2to
{
std::vector<Cell> wallSupport(const ClassifiedGrid& grid, const Eigen::Vector2d& from,
                              const Eigen::Vector2d& to, double* covered)
{
    const int samples = std::max(1, static_cast<int>(std::ceil((to - from).norm())));  // one a cell
    std::vector<std::size_t> support;
    int hits = 0;
    Cell before{-3, -3};  // the sample before, whose neighbours are known
    for (int k = 0; k <= samples; ++k) {
        const Eigen::Vector2d p = from + (to - from) * (static_cast<double>(k) / samples);
        const Cell at{roundToCell(p.x()), roundToCell(p.y())};
        bool hit = false;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const Cell c{at.x + dx, at.y + dy};
                if (!grid.isOccupied(c)) continue;
                hit = true;
                if (std::abs(c.x - before.x) > 1 || std::abs(c.y - before.y) > 1)
                    support.push_back(grid.index(c));
            }
        hits += hit ? 1 : 0;
        before = at;
    }
    *covered = static_cast<double>(hits) / (samples + 1);
    std::sort(support.begin(), support.end());
    support.erase(std::unique(support.begin(), support.end()), support.end());
    std::vector<Cell> cells;
    cells.reserve(support.size());
    for (const std::size_t i : support) cells.push_back(grid.cell(i));
    return cells;
}
}  // namespace gr2to
