#pragma once

#include <string>
#include <string_view>

#include "io/ImageRule.h"

namespace gr2to::io
{
/** Reads a PNG image of any colour type and depth; see readGrid() for what pixels mean.
 * \param name  of the file, quoted, for messages
 * \throws InputError  the image is truncated, malformed, or larger than a file of its length can hold (told
 * before allocating)
 */
ClassifiedGrid readPng(std::string_view bytes, const std::string& name, const ImageRule& rule,
                       const GridFrame& frame);
}  // namespace gr2to::io
