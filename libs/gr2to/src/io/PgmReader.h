#pragma once

#include <string>
#include <string_view>

#include "io/ImageRule.h"

namespace gr2to::io
{
/** Reads a PGM image, text (P2) or binary (P5), 8 or 16 bits.
 * \param name  of the file, quoted, for messages
 * \throws InputError  the header is malformed, or the file is shorter than its header says (told before
 * allocating)
 */
ClassifiedGrid readPgm(std::string_view bytes, const std::string& name, const ImageRule& rule,
                       const GridFrame& frame);
}  // namespace gr2to::io
