#include "gr2to/view/Palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gr2to
{
namespace
{
// Farthest-point selection among all light sRGB tints under normal and simulated dichromatic vision (Machado,
// Oliveira and Fernandes 2009), kept away from the greys of unknown and occupied cells, then ordered by
// simulated annealing so that colours at most five steps apart, around the cycle, differ most.
// Palette_unittest holds the distances.
constexpr std::array<std::uint32_t, palette::placeColors> kPlaceTints = {
    0x78B4FF, 0xB4E17D, 0xB4D7FF, 0x96E6D2, 0xD7CDAA, 0xC8F5B4, 0xFF8CD2, 0xFFEB7D, 0x91C3F5, 0x7DC86E,
    0xF0BEBE, 0xC3D791, 0x9BB9A0, 0xDCD264, 0x64C3D7, 0xFF9664, 0xFAE1FF, 0xDCF0CD, 0xD2AF8C, 0xEBF0A0};
}  // namespace

Rgb placeColor(PlaceId id)
{
    if (id == 0) return palette::free;
    const std::uint32_t tint = kPlaceTints[(id - 1U) % kPlaceTints.size()];
    return {static_cast<std::uint8_t>(tint >> 16U), static_cast<std::uint8_t>((tint >> 8U) & 0xFFU),
            static_cast<std::uint8_t>(tint & 0xFFU)};
}

Rgb darker(Rgb color, double factor)
{
    const auto scaled = [factor](std::uint8_t channel) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(channel * factor, 0.0, 255.0)));
    };
    return {scaled(color.red), scaled(color.green), scaled(color.blue)};
}
}  // namespace gr2to
