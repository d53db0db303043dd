#include "gr2to/view/triangulate.h"

#include <algorithm>
#include <numeric>

namespace gr2to
{
namespace
{
using mrpt::math::TPoint2D;

/** Twice the area of a triangle, positive when it turns left. */
double turn(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool contains(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c, const TPoint2D& p)
{
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}
}  // namespace

std::vector<std::array<std::size_t, 3>> triangulate(const std::vector<TPoint2D>& polygon)
{
    std::vector<std::array<std::size_t, 3>> triangles;
    std::vector<std::size_t> left(polygon.size());
    std::iota(left.begin(), left.end(), 0);
    const auto isEar = [&](std::size_t k) {
        const std::size_t n = left.size(), a = left[(k + n - 1) % n], b = left[k], c = left[(k + 1) % n];
        if (turn(polygon[a], polygon[b], polygon[c]) <= 0) return false;
        return std::none_of(left.begin(), left.end(), [&](std::size_t p) {
            const bool corner =
                polygon[p] == polygon[a] || polygon[p] == polygon[b] || polygon[p] == polygon[c];
            return !corner && contains(polygon[a], polygon[b], polygon[c], polygon[p]);
        });
    };
    while (left.size() >= 3) {
        std::size_t ear = 0;
        while (ear < left.size() && !isEar(ear)) ++ear;
        const std::size_t n = left.size(),
                          k = ear % n;  // none: the vertex is on a line, or the polygon is not simple
        if (ear < n) triangles.push_back({left[(k + n - 1) % n], left[k], left[(k + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
    }
    return triangles;
}
}  // namespace gr2to
