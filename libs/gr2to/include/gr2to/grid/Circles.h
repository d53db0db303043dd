#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "gr2to/grid/DistanceMap.h"

namespace gr2to
{
/** A circle around a cell's centre [cells]. */
struct Circle
{
    Cell center;
    double radius_cells = 0;
};

inline double distance_cells(Cell a, Cell b)
{
    const double dx = a.x - b.x, dy = a.y - b.y;
    return std::sqrt(dx * dx + dy * dy);
}

/** Finds the circles near a place quickly; built for circles added from large to small. */
class CircleIndex
{
 public:
    CircleIndex(int width, int height) : m_width(width), m_height(height) {}

    void add(const Circle& circle);

    /** Whether the predicate holds for a circle whose centre is closer than `factor` times the sum of both
     * radii. \param factor  from 1 to 2
     */
    template <class Predicate>
    bool anyWithin(const Circle& circle, double factor, const Predicate& predicate) const
    {
        for (const Level& level : m_levels) {
            if (level.heads.empty()) continue;
            // A circle of this level is smaller than half a bucket; see add().
            const double reach = factor * (level.side / 2.0 + circle.radius_cells);
            const int x0 = std::max(0, static_cast<int>((circle.center.x - reach) / level.side));
            const int y0 = std::max(0, static_cast<int>((circle.center.y - reach) / level.side));
            const int x1 =
                std::min(level.columns - 1, static_cast<int>((circle.center.x + reach) / level.side));
            const int y1 = std::min(level.rows - 1, static_cast<int>((circle.center.y + reach) / level.side));
            for (int y = y0; y <= y1; ++y)
                for (int x = x0; x <= x1; ++x)
                    for (int i = level.heads[level.bucket(x, y)]; i >= 0;
                         i = m_next[static_cast<std::size_t>(i)]) {
                        const Circle& other = m_circles[static_cast<std::size_t>(i)];
                        if (distance_cells(circle.center, other.center) <
                                factor * (circle.radius_cells + other.radius_cells) &&
                            predicate(other))
                            return true;
                    }
        }
        return false;
    }

    const std::vector<Circle>& circles() const { return m_circles; }

 private:
    /** Square buckets for circles of radii from side / 4 to side / 2. */
    struct Level
    {
        int side = 0;
        int columns = 0;
        int rows = 0;
        std::vector<int> heads;  //!< first circle of each bucket, -1 for none
        std::size_t bucket(int x, int y) const
        {
            return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                   static_cast<std::size_t>(x);
        }
    };

    int m_width;
    int m_height;
    std::vector<Level> m_levels;
    std::vector<Circle> m_circles;
    std::vector<int> m_next;
};

/** Keeps, of overlapping circles, the bigger (of equals the first): walks from big to small, keeps what is
 * disjoint. \param circles  sorted by falling radius
 */
std::vector<Circle> dropOverlapping(const std::vector<Circle>& circles, int width, int height);

/** Eq. (9): walks from big circles to small and drops those close to a kept one with nothing narrower
 * between.
 *
 * Two circles are close when sqrt(2) times the sum of their radii exceeds their distance; nothing is narrower
 * when the clearance half-way between them is at least the smaller radius. \param circles  sorted by falling
 * radius
 */
std::vector<Circle> dropClose(const std::vector<Circle>& circles, const DistanceMap& distances);
}  // namespace gr2to
