#pragma once

#include <cstdint>
#include <string>

namespace gr2to::test
{
/** How the samples of a PNG are laid out, in the format's own numbers. */
struct PngLayout
{
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint8_t bitDepth = 8;
    std::uint8_t colourType = 0;  //!< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
};

/** A PNG without compression of any layout, to test readers with: `rows` from the top, each of whole bytes.
 * \param palette  three bytes a colour, for colour type 3
 */
std::string plainPng(const PngLayout& layout, const std::string& rows, const std::string& palette = "");
}  // namespace gr2to::test
