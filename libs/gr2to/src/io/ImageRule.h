#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to::io
{
enum class ImageMode : std::uint8_t
{
    Trinary,
    Scale,
    Raw
};

/** How the greys of an image are understood; the fields of TGridReaderOptions with nothing left open. */
struct ImageRule
{
    double occupied_threshold = 0.65;
    double free_threshold = 0.196;
    bool negate = false;
    ImageMode mode = ImageMode::Trinary;
    int unknown_grey = 205;
};

/** The state for every sum of a pixel's channels, 0 to channels * maximum.
 * \param name  of the file, quoted, for messages
 * \throws InputError  the mode is raw and the maximum is not 255
 */
std::vector<CellState> stateTable(const ImageRule& rule, unsigned channels, unsigned maximum,
                                  const std::string& name);

/** Refuses sizes that are not positive or too large to index, before anything is allocated.
 * \throws InputError
 */
void requireSize(std::uint64_t width, std::uint64_t height, const std::string& name);
}  // namespace gr2to::io
