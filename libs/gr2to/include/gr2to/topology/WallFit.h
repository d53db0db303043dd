#pragma once

#include <Eigen/Core>
#include <vector>

namespace gr2to
{
/** A straight line through wall cells with its uncertainty, in the plane. */
struct LineFit
{
    Eigen::Vector2d center;     //!< half-way between the first and the last point along the line [m]
    Eigen::Vector2d direction;  //!< unit vector along the line
    double length_m = 0;        //!< from the first to the last point along the line, a cell's side added
    Eigen::Matrix2d centerCovariance;  //!< [m^2]
    Eigen::Matrix2d normalCovariance;  //!< of the unit normal, along the line
    double lengthVariance = 0;         //!< [m^2]
};

/** Fits a line to the centres of cells by total least squares and propagates the cell size to its covariance.
 *
 * A cell's centre stands for a point anywhere in the cell: variance sigma^2 = resolution^2 / 12 along each
 * axis. With n points at positions s_k along the line, measured from their mean, and unit vectors t along and
 * n across the line, and the middle at position m:
 * - position  (sigma^2 / n + m^2 sigma^2 / sum s_k^2) n n^T  +  sigma^2 / 2 t t^T  (across, the mean's and
 * the angle's part; along, the ends, one cell each, fix it)
 * - normal    sigma^2 / sum s_k^2 t t^T  (the line's angle, first order)
 * - length    2 sigma^2  (difference of two ends)
 *
 * \param points  at least two, not all the same  \param resolution_m  side of a cell \throws
 * std::invalid_argument  too few different points
 */
LineFit fitLine(const std::vector<Eigen::Vector2d>& points, double resolution_m);
}  // namespace gr2to
