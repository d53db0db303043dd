#include "gr2to/topology/CorridorMerging.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gr2to
{
namespace
{
bool sameRadius(const Circle& a, const Circle& b, double tolerance)
{
    return std::abs(a.radius_cells - b.radius_cells) <= tolerance * std::max(a.radius_cells, b.radius_cells);
}

double turnAt(const Circle& before, const Circle& at, const Circle& after)
{
    const double in = std::atan2(at.center.y - before.center.y, at.center.x - before.center.x);
    const double out = std::atan2(after.center.y - at.center.y, after.center.x - at.center.x);
    return std::abs(std::remainder(out - in, 2.0 * 3.14159265358979323846));
}
}  // namespace

std::vector<std::size_t> mergeCorridors(const PlaceGraph& graph, double radiusTolerance,
                                        double angleTolerance_rad)
{
    std::vector<std::size_t> group(graph.circles.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
        while (group[i] != i) i = group[i] = group[group[i]];
        return i;
    };
    const auto unite = [&](std::size_t i, std::size_t j) {
        i = find(i);
        j = find(j);
        group[std::max(i, j)] = std::min(i, j);
    };
    std::vector<std::vector<std::size_t>> joined(graph.circles.size());
    for (const PlaceLink& link : graph.links)
        if (link.door < 0) {
            joined[link.from].push_back(link.to);
            joined[link.to].push_back(link.from);
        }
    for (std::size_t b = 0; b < joined.size(); ++b)
        for (const std::size_t a : joined[b])
            for (const std::size_t c : joined[b]) {
                if (a >= c) continue;
                const Circle &first = graph.circles[a], &middle = graph.circles[b], &last = graph.circles[c];
                if (!sameRadius(first, middle, radiusTolerance) ||
                    !sameRadius(middle, last, radiusTolerance) || !sameRadius(first, last, radiusTolerance) ||
                    turnAt(first, middle, last) > angleTolerance_rad)
                    continue;
                unite(a, b);
                unite(b, c);
            }
    for (std::size_t i = 0; i < group.size(); ++i) group[i] = find(i);
    return group;
}
}  // namespace gr2to
