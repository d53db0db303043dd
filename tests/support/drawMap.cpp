#include "support/drawMap.h"

#include <random>

namespace gr2to::test
{
ClassifiedGrid drawMap(const std::vector<std::string>& rows, double resolution_m)
{
    const int height = static_cast<int>(rows.size());
    const int width = static_cast<int>(rows.front().size());
    ClassifiedGrid grid(width, height, GridFrame{resolution_m, 0, 0, 0}, CellState::Free);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const char c = rows[static_cast<std::size_t>(height - 1 - y)].at(static_cast<std::size_t>(x));
            if (c == '#') grid.set({x, y}, CellState::Occupied);
            if (c == '?') grid.set({x, y}, CellState::Unknown);
        }
    return grid;
}

ClassifiedGrid randomMap(int width, int height, unsigned seed, double occupied, double unknown)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform;
    ClassifiedGrid grid(width, height, GridFrame{}, CellState::Free);
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const double u = uniform(random);
        if (u < occupied)
            grid[i] = CellState::Occupied;
        else if (u < occupied + unknown)
            grid[i] = CellState::Unknown;
    }
    return grid;
}
}  // namespace gr2to::test
