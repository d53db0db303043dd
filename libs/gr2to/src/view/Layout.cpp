#include "Layout.h"

#include <algorithm>
#include <limits>

namespace gr2to::view
{
namespace
{
constexpr double kNominalSide_px = 1000.0;
constexpr int kMarginShare = 50;
}  // namespace

CellWindow knownWindow(const ClassifiedGrid& grid)
{
    const auto isKnown = [](CellState state) { return state != CellState::Unknown; };
    int left = std::numeric_limits<int>::max(), right = -1, bottom = -1, top = -1;
    for (int y = 0; y < grid.height(); ++y) {
        const CellState* row = grid.row(y);
        const CellState* const end = row + grid.width();
        const CellState* const first = std::find_if(row, end, isKnown);
        if (first == end) continue;
        const auto last =
            std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(first), isKnown);
        left = std::min(left, static_cast<int>(first - row));
        right = std::max(right, static_cast<int>(last.base() - row) - 1);
        if (bottom < 0) bottom = y;
        top = y;
    }
    if (top < 0) return {0, 0, grid.width(), grid.height()};
    const int margin = std::max(right - left, top - bottom) / kMarginShare + 1;
    left = std::max(0, left - margin);
    bottom = std::max(0, bottom - margin);
    right = std::min(grid.width() - 1, right + margin);
    top = std::min(grid.height() - 1, top + margin);
    return {left, bottom, right - left + 1, top - bottom + 1};
}

Layout Layout::of(const CellWindow& window, int minSide, int maxSide)
{
    Layout layout;
    layout.window = window;
    const int longer = std::max(window.width, window.height);
    layout.reduce = (longer - 1) / maxSide + 1;
    if (layout.reduce == 1) layout.enlarge = std::clamp((minSide - 1) / longer + 1, 1, maxSide / longer);
    const auto pixels = [&](int cells) { return (cells * layout.enlarge - 1) / layout.reduce + 1; };
    layout.mapWidth = pixels(window.width);
    layout.mapHeight = pixels(window.height);
    layout.unit = std::max(layout.mapWidth, layout.mapHeight) / kNominalSide_px;
    return layout;
}

Eigen::Vector2d Layout::toPicture(double column, double row) const
{
    const double scale = pixelsPerCell();
    return {mapLeft + (column - window.left + 0.5) * scale,
            (window.bottom + window.height - 0.5 - row) * scale};
}
}  // namespace gr2to::view
