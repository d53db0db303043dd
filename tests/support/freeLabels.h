#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/PlaceImage.h"

namespace gr2to::test
{
/** A piece of the cells of one place, connected over sides and corners. */
struct LabelPiece
{
    PlaceId place = 0;
    std::vector<std::size_t> cells;
};

/** The pieces of all places. */
std::vector<LabelPiece> piecesOf(const PlaceImage& image);

/** The first cell that breaks the partition, in words: a free cell without a place, or a place elsewhere;
 * empty when every free cell has one place and no other cell has. */
std::string breachOfPartition(const ClassifiedGrid& grid, const PlaceImage& image);
}  // namespace gr2to::test
