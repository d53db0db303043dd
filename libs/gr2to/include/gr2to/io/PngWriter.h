#pragma once

#include <string>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/PlaceImage.h"

namespace gr2to
{
/** PNG of 16-bit greys whose value is the place id, 0 for no place; the top row of the map comes first.
 * \throws OutputError  the image is empty
 */
std::string encodePng16(const PlaceImage& image);

/** PNG of 8-bit greys as map savers write them: 254 free, 205 unknown, 0 occupied; the top row comes first.
 * \throws OutputError  the grid is empty
 */
std::string encodePng8(const ClassifiedGrid& grid);
}  // namespace gr2to
