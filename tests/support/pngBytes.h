#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gr2to::test
{
/** A PNG image built by hand, independent of libpng. */
struct PngImage
{
    enum ColourType : std::uint8_t
    {
        Grey = 0,
        Rgb = 2,
        Palette = 3,
        GreyAlpha = 4,
        Rgba = 6
    };
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint8_t bits = 8;
    ColourType type = Grey;
    bool interlaced = false;
    std::string palette = {};       //!< RGB triples
    std::string transparency = {};  //!< content of the tRNS chunk
    std::vector<std::string> rows =
        {};  //!< packed samples, the top row first; of interlaced images 8-bit grey only
};

std::string encodePng(const PngImage& image);

/** The same, for rows with one byte a sample. */
PngImage pngOf(PngImage::ColourType type, std::uint32_t width, const std::vector<std::string>& rows);

/** Decodes the greys that PngWriter writes: no interlacing, rows filtered by none, sub or up. */
PngImage decodeGreyPng(std::string_view bytes);
}  // namespace gr2to::test
