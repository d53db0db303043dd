#pragma once

#include <mrpt/math/TPoint2D.h>
#include <Eigen/Core>

#include <string>
#include <vector>

namespace gr2to::test
{
using Polygon = std::vector<Eigen::Vector2d>;

Polygon polygonOf(const std::vector<mrpt::math::TPoint2D>& boundary);
/** Positive when it runs counter-clockwise. */
double areaOf(const Polygon& polygon);
/** Distance of a point from a side. */
double distanceFromSide(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b);
/** Whether two sides have a point in common. */
bool sidesMeet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
               const Eigen::Vector2d& d);
/** Two sides that meet where they may not, or fold back; empty when the polygon is simple. Tries all pairs.
 */
std::string whyNotSimple(const Polygon& polygon);
}  // namespace gr2to::test
