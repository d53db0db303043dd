#pragma once

#include <Eigen/Core>
#include <optional>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/PlaceImage.h"

namespace gr2to::view
{
/** Along which direction an opening spans its passage: the one with the shortest free run through the centre.
 *
 * Runs beside the centre by up to two cells count too: a centre may lie beside the axis of a thin wall.
 * Directions whose run is less than a cell longer than the shortest one are averaged. Cells that are not
 * free, and the outside of the grid, are jambs.
 *
 * \param center       continuous grid coordinates [cells]
 * \param reach_cells  how far to look for jambs, each way
 * \return unit vector along the grid's axes, its sign arbitrary; none when no direction meets a jamb both
 * ways
 */
std::optional<Eigen::Vector2d> doorDirection(const ClassifiedGrid& grid, const Eigen::Vector2d& center,
                                             double reach_cells);

/** Along which direction two places touch around a point: the principal axis of where they do.
 *
 * \param center       continuous grid coordinates [cells]
 * \param reach_cells  half the side of the square that is looked at
 * \return unit vector along the grid's axes, its sign arbitrary; none where they touch at less than two spots
 */
std::optional<Eigen::Vector2d> contactDirection(const PlaceImage& places, PlaceId a, PlaceId b,
                                                const Eigen::Vector2d& center, double reach_cells);
}  // namespace gr2to::view
