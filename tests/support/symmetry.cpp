#include "support/symmetry.h"

#include <utility>

namespace gr2to::test
{
Cell Symmetry::apply(Cell c, int width, int height) const
{
    if (mirrored) c.x = width - 1 - c.x;
    for (int k = 0; k < quarterTurns; ++k) {
        c = {height - 1 - c.y, c.x};
        std::swap(width, height);
    }
    return c;
}

ClassifiedGrid Symmetry::apply(const ClassifiedGrid& grid) const
{
    const bool swapped = quarterTurns % 2 == 1;
    ClassifiedGrid moved(swapped ? grid.height() : grid.width(), swapped ? grid.width() : grid.height(),
                         grid.frame());
    for (std::size_t i = 0; i < grid.size(); ++i)
        moved.set(apply(grid.cell(i), grid.width(), grid.height()), grid[i]);
    return moved;
}

std::string Symmetry::name() const
{
    return std::string(mirrored ? "mirrored, " : "") + std::to_string(quarterTurns) + " quarter turns";
}

std::vector<Symmetry> symmetries()
{
    std::vector<Symmetry> all;
    for (const bool mirrored : {false, true})
        for (int turns = mirrored ? 0 : 1; turns < 4; ++turns) all.push_back({mirrored, turns});
    return all;
}
}  // namespace gr2to::test
