#include "support/topology.h"

#include <vector>

namespace gr2to::test
{
PlanarTopology topologyOf(int width, int height, const std::function<bool(Cell)>& inSet)
{
    const int w = width + 2, h = height + 2;  // one cell of surroundings on every side
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x);
    };
    std::vector<int> figure(index(0, h), 0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) figure[index(x + 1, y + 1)] = inSet({x, y}) ? 1 : 0;
    std::vector<bool> seen(figure.size(), false);
    PlanarTopology result;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            if (seen[index(x, y)]) continue;
            const int value = figure[index(x, y)];
            if (value)
                ++result.components;
            else if (x + y > 0)
                ++result.holes;
            std::vector<Cell> stack{{x, y}};
            seen[index(x, y)] = true;
            while (!stack.empty()) {
                const Cell c = stack.back();
                stack.pop_back();
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const int nx = c.x + dx, ny = c.y + dy;
                        if (nx < 0 || ny < 0 || nx >= w || ny >= h || (value && dx != 0 && dy != 0)) continue;
                        if (seen[index(nx, ny)] || figure[index(nx, ny)] != value) continue;
                        seen[index(nx, ny)] = true;
                        stack.push_back({nx, ny});
                    }
            }
        }
    return result;
}
}  // namespace gr2to::test
