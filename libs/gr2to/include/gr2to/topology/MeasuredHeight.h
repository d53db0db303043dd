#pragma once

#include <optional>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/HeightMap.h"
#include "gr2to/grid/Jambs.h"
#include "gr2to/topology/types.h"

namespace gr2to
{
/** A height above the floor [m] and its variance [m^2]. */
struct MeasuredHeight
{
    double height_m = 0;
    double variance = 0;
};

/** Height of a wall: the median of the tops of its occupied columns; nothing when none was seen.
 *
 * Variance: that of a voxel, and that of the median when tops differ.
 */
std::optional<MeasuredHeight> wallHeight(const std::vector<Cell>& wall, const HeightMap& heights);

/** Where a passage is looked at from. */
struct Passage
{
    const ClassifiedGrid& grid;
    const std::vector<Cell>& line;  //!< free cells from jamb to jamb
    Jambs jambs;
};

/** Clear height of a passage: the median of the lower sides of what hangs over it.
 *
 * Of the lines that run beside the passage's, up to 0.3 m to both sides, the nearest counts of which at least
 * two thirds of the free cells have something over them: jambs are as deep as walls, and the line is anywhere
 * between them. Nothing when there is none.
 */
std::optional<MeasuredHeight> lintelHeight(const Passage& passage, const HeightMap& heights);

/** Whether a passage has a lintel: something hangs over it, and ends before and behind it.
 *
 * 0.6 m to both sides of it less than a third of the free cells have anything as low hanging over them: there
 * it is no lintel but a ceiling, a duct or a lamp that goes on.
 */
bool hasLintel(const Passage& passage, const HeightMap& heights);

/** Gives an upright plane its height, with no covariance with its length, and puts its position to half that
 * height above the floor; without a height the position is on the floor. */
void setHeight(const HeightMap& heights, const std::optional<MeasuredHeight>& height,
               UncertainPoint& position, PlaneSize& size);
}  // namespace gr2to
