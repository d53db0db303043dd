#include "gr2to/grid/Circles.h"

#include <algorithm>

namespace gr2to
{
void CircleIndex::add(const Circle& circle)
{
    std::size_t l = 0;
    while (static_cast<double>(std::size_t{2} << l) <= circle.radius_cells) ++l;  // radius < 2^(l + 1)
    if (l >= m_levels.size()) m_levels.resize(l + 1);
    Level& level = m_levels[l];
    if (level.heads.empty()) {
        level.side = 4 << l;
        level.columns = m_width / level.side + 1;
        level.rows = m_height / level.side + 1;
        level.heads.assign(level.bucket(0, level.rows), -1);
    }
    int& head = level.heads[level.bucket(circle.center.x / level.side, circle.center.y / level.side)];
    m_next.push_back(head);
    head = static_cast<int>(m_circles.size());
    m_circles.push_back(circle);
}

std::vector<Circle> dropOverlapping(const std::vector<Circle>& circles, int width, int height)
{
    CircleIndex kept(width, height);
    for (const Circle& circle : circles)
        if (!kept.anyWithin(circle, 1.0, [](const Circle&) { return true; })) kept.add(circle);
    return kept.circles();
}

std::vector<Circle> dropClose(const std::vector<Circle>& circles, const DistanceMap& distances)
{
    const double closeFactor = std::sqrt(2.0);
    CircleIndex kept(distances.width, distances.height);
    for (const Circle& circle : circles) {
        const auto nothingNarrower = [&](const Circle& bigger) {
            const Cell middle{(circle.center.x + bigger.center.x) / 2,
                              (circle.center.y + bigger.center.y) / 2};
            return distances.clearance_cells(middle) >= circle.radius_cells;
        };
        if (!kept.anyWithin(circle, closeFactor, nothingNarrower)) kept.add(circle);
    }
    return kept.circles();
}
}  // namespace gr2to
