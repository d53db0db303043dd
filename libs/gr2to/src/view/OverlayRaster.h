#pragma once

#include <cstdint>
#include <vector>

#include "Layout.h"
#include "gr2to/view/Overlay.h"

namespace gr2to::view
{
/** Shade of the stripes that mark a corridor, of the place's tint. */
inline constexpr double kCorridorShade = 0.90;

/** Pixels 0x00RRGGBB in rows from the top. */
struct Raster
{
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> pixels;
};

/** Whether the picture shows something that the filter took away. */
bool showsRemoved(const OverlayInput& input, const TOverlayOptions& options);

/** The cells as pixels: grid, what the filter took out of it, place tints, a darker rim between places,
 * hatched corridors.
 *
 * Enlarging repeats cells; reducing pools them: occupied when any cell is, else removed when any is, else
 * free when at least half are not unknown, of the place that has the majority of them (or, without one, of
 * some place among them).
 */
Raster drawCells(const OverlayInput& input, const TOverlayOptions& options, const Layout& layout);
}  // namespace gr2to::view
