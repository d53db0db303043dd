#include "crossingSides.h"

#include <algorithm>
#include <cmath>

namespace gr2to
{
namespace
{
using mrpt::math::TPoint2D;

constexpr double kRounding = 1e-9;  // sine of angles that tell nothing

struct Side
{
    TPoint2D from, to;
    std::size_t number = 0;

    double left() const { return std::min(from.x, to.x); }
    double right() const { return std::max(from.x, to.x); }
    double bottom() const { return std::min(from.y, to.y); }
    double top() const { return std::max(from.y, to.y); }
};

/** On which side of a line through a side a point is: 1 left, -1 right, 0 on it within rounding. */
int sideOf(const Side& s, const TPoint2D& p)
{
    const double dx = s.to.x - s.from.x, dy = s.to.y - s.from.y, px = p.x - s.from.x, py = p.y - s.from.y;
    const double sine = dx * py - dy * px, least = kRounding * std::hypot(dx, dy) * std::hypot(px, py);
    return sine > least ? 1 : sine < -least ? -1 : 0;
}

bool cross(const Side& s, const Side& t)
{
    return sideOf(s, t.from) * sideOf(s, t.to) < 0 && sideOf(t, s.from) * sideOf(t, s.to) < 0;
}
}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> crossingSides(const std::vector<TPoint2D>& polygon)
{
    std::vector<Side> sides;
    for (std::size_t k = 0; k < polygon.size(); ++k)
        sides.push_back({polygon[k], polygon[(k + 1) % polygon.size()], k});
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return a.left() < b.left(); });
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = i + 1; j < sides.size() && sides[j].left() <= sides[i].right(); ++j)
            if (sides[j].bottom() <= sides[i].top() && sides[i].bottom() <= sides[j].top() &&
                cross(sides[i], sides[j]))
                return std::pair<std::size_t, std::size_t>(std::minmax(sides[i].number, sides[j].number));
    return {};
}
}  // namespace gr2to
