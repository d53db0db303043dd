#pragma once

#include <string>
#include <vector>

#include "gr2to/grid/PlaceImage.h"

namespace gr2to::test
{
/** Side of the square that a drawn character stands for: 400 cells are well above a speck. */
constexpr int kLabelBlock = 20;

/** A label image from a drawing: digits are labels, all else is none; the first row is the top (largest y).
 */
PlaceImage drawLabels(const std::vector<std::string>& rows, int block = kLabelBlock);
}  // namespace gr2to::test
