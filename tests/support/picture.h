#pragma once

#include <string>
#include <vector>

#include "gr2to/view/Palette.h"

namespace gr2to::test
{
/** The pixels of a PNG file; rows from the top. */
struct Picture
{
    int width = 0;
    int height = 0;
    std::vector<Rgb> pixels;

    Rgb at(int x, int y) const
    {
        return pixels.at(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x));
    }
};

/** Decodes with libpng, not with what wrote it. \throws std::runtime_error  the bytes are no PNG */
Picture decodePng(const std::string& bytes);
}  // namespace gr2to::test
