#pragma once

#include <cstddef>
#include <cstdint>

#include "gr2to/grid/PlaceImage.h"

namespace gr2to
{
/** A colour in sRGB, 8 bits a channel. */
struct Rgb
{
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    friend bool operator==(Rgb a, Rgb b) { return a.red == b.red && a.green == b.green && a.blue == b.blue; }
    friend bool operator!=(Rgb a, Rgb b) { return !(a == b); }
};

/** The colours of every picture that the project draws.
 *
 * Places are light tints (CIE lightness L* above 72) on which dark lines stay readable; marks are taken from
 * the colour-blind safe set of Okabe and Ito (2008).
 */
namespace palette
{
inline constexpr Rgb unknown{170, 174, 178};
inline constexpr Rgb occupied{90, 90, 90};
inline constexpr Rgb removed{150, 90, 20};  //!< occupied or unknown, but taken out by the filter
inline constexpr Rgb free{255, 255, 255};   //!< free cells that belong to no place
inline constexpr Rgb ink{17, 17, 17};       //!< walls, connections and text
inline constexpr Rgb halo{255, 255, 255};   //!< around text and doors
inline constexpr Rgb door{0, 114, 178};
inline constexpr Rgb voronoi{0, 110, 80};
inline constexpr Rgb criticalPoint{240, 228, 66};
inline constexpr Rgb vertex{213, 60, 0};

/** After this many ids the place colours start again. */
inline constexpr std::size_t placeColors = 20;
}  // namespace palette

/** Colour of a place; it depends on nothing but the id, so it is the same on every run and every map.
 *
 * Ids follow raster order, so neighbours on the map tend to have ids near one another. Any two ids whose
 * difference is at most five differ by at least 19 units of CIELAB distance (1976) to people with normal
 * vision, 9.9 to protanopes and deuteranopes and 8 to tritanopes; any two of the colours by 10, 8.9, 8.9
 * and 7. (About 2 can just be told apart.) Id 0, no place, has the colour of free space.
 */
Rgb placeColor(PlaceId id);

/** The colour times a factor; 0 is black, 1 the colour itself. */
Rgb darker(Rgb color, double factor);
}  // namespace gr2to
