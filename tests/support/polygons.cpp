#include "support/polygons.h"

#include <algorithm>

namespace gr2to::test
{
namespace
{
using Eigen::Vector2d;

double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool boxesMeet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d)
{
    const Vector2d low = a.cwiseMin(b).cwiseMax(c.cwiseMin(d)), high = a.cwiseMax(b).cwiseMin(c.cwiseMax(d));
    return low.x() <= high.x() && low.y() <= high.y();
}
}  // namespace

Polygon polygonOf(const std::vector<mrpt::math::TPoint2D>& boundary)
{
    Polygon polygon;
    for (const auto& p : boundary) polygon.emplace_back(p.x, p.y);
    return polygon;
}

double areaOf(const Polygon& polygon)
{
    double area = 0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        area += turn(polygon[0], polygon[k], polygon[k + 1]) / 2;
    return area;
}

double distanceFromSide(const Vector2d& p, const Vector2d& a, const Vector2d& b)
{
    const double squared = (b - a).squaredNorm();
    const double t = squared > 0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
    return (a + t * (b - a) - p).norm();
}

bool sidesMeet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d)
{
    return boxesMeet(a, b, c, d) && turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
}

std::string whyNotSimple(const Polygon& polygon)
{
    const std::size_t n = polygon.size();
    if (n < 3) return "it has " + std::to_string(n) + " vertices";
    for (std::size_t i = 0; i < n; ++i) {
        const Vector2d &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
        if (a == b || (turn(a, b, c) == 0 && (b - a).dot(c - b) < 0))
            return "it folds back at vertex " + std::to_string(i);
        for (std::size_t j = i + 2; j < n; ++j)
            if ((j + 1) % n != i && sidesMeet(a, b, polygon[j], polygon[(j + 1) % n]))
                return "its sides " + std::to_string(i) + " and " + std::to_string(j) + " meet";
    }
    return "";
}
}  // namespace gr2to::test
