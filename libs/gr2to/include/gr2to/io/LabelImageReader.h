#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "gr2to/grid/PlaceImage.h"

namespace gr2to
{
/** A label image and the values that its labels have in the file. */
struct LabelImage
{
    PlaceImage labels;
    /** values[id] is the file's value of label `id`, values[0] = 0; empty when labels are those of the file.
     */
    std::vector<std::uint32_t> values;
};

/** Reads a PNG whose pixels are labels, 0 = none: grey of up to 16 bits, palette indices, or 8-bit RGB.
 *
 * An RGB pixel is the label r * 65536 + g * 256 + b; the image's labels are then numbered from 1 in ascending
 * order. Transparency is ignored. \throws InputError  the file is missing, not a PNG, damaged, larger than
 * 2^31 pixels, has more than 8 bits a colour, or more than 65535 labels
 */
LabelImage readLabelImage(const std::filesystem::path& path);
}  // namespace gr2to
