#include "support/freeLabels.h"

namespace gr2to::test
{
std::vector<LabelPiece> piecesOf(const PlaceImage& image)
{
    std::vector<LabelPiece> pieces;
    std::vector<bool> seen(image.ids.size(), false);
    for (std::size_t seed = 0; seed < image.ids.size(); ++seed) {
        if (seen[seed] || image.ids[seed] == 0) continue;
        pieces.push_back({image.ids[seed], {seed}});
        seen[seed] = true;
        auto& cells = pieces.back().cells;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const int x = static_cast<int>(cells[k] % static_cast<std::size_t>(image.width));
            const int y = static_cast<int>(cells[k] / static_cast<std::size_t>(image.width));
            for (int ny = y - 1; ny <= y + 1; ++ny)
                for (int nx = x - 1; nx <= x + 1; ++nx) {
                    if (nx < 0 || ny < 0 || nx >= image.width || ny >= image.height) continue;
                    const std::size_t n = image.index({nx, ny});
                    if (seen[n] || image.ids[n] != image.ids[seed]) continue;
                    seen[n] = true;
                    cells.push_back(n);
                }
        }
    }
    return pieces;
}

std::string breachOfPartition(const ClassifiedGrid& grid, const PlaceImage& image)
{
    if (image.width != grid.width() || image.height != grid.height()) return "the sizes differ";
    for (std::size_t i = 0; i < grid.size(); ++i)
        if ((grid[i] == CellState::Free) != (image.ids[i] != 0)) {
            const Cell c = grid.cell(i);
            return "cell " + std::to_string(c.x) + ", " + std::to_string(c.y) +
                   (image.ids[i] == 0 ? " is free but in no place"
                                      : " is not free but in place " + std::to_string(image.ids[i]));
        }
    return "";
}
}  // namespace gr2to::test
