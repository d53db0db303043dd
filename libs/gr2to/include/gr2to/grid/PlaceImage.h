#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to
{
/** Number of a place, from 1; 0 is no place. At most 65535 places a map, as `places.png` has 16 bits. */
using PlaceId = std::uint16_t;

/** For every cell the place that it belongs to; rows from the bottom, as in ClassifiedGrid. */
struct PlaceImage
{
    int width = 0;
    int height = 0;
    std::vector<PlaceId> ids;

    PlaceImage() = default;
    PlaceImage(int w, int h)
        : width(w), height(h), ids(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), PlaceId{0})
    {
    }
    std::size_t index(Cell c) const
    {
        return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(c.x);
    }
    PlaceId at(Cell c) const { return ids[index(c)]; }
};
}  // namespace gr2to
