#include "gr2to/topology/Octagon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gr2to/grid/Jambs.h"

namespace gr2to
{
namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr double kBeam = 2.0 * kPi / 8;  // aperture, fifth stage
constexpr int kMaxRaysPerBeam = 16;      // 2.8 degrees apart: at 10 m half a metre

double limitOfEq10(const Circle& circle, const std::vector<Circle>& neighbours, double axis_rad)
{
    double closest = std::numeric_limits<double>::infinity(), limit = closest;
    for (const Circle& other : neighbours) {
        const double dx = other.center.x - circle.center.x, dy = other.center.y - circle.center.y;
        const double distance = std::hypot(dx, dy);
        const double off = std::remainder(std::atan2(dy, dx) - axis_rad, 2.0 * kPi);
        if (std::abs(off) > kBeam / 2 || distance >= closest) continue;
        closest = distance;
        limit = circle.radius_cells / (circle.radius_cells + other.radius_cells) * distance;
    }
    return limit;
}

/** How many steps from a cell stay inside the grid, at least. */
int stepsInside(const ClassifiedGrid& grid, Cell from, const Eigen::Vector2d& step)
{
    const auto along = [](int at, double d, int size) {
        const double room = d > 0 ? size - 1 - at : at;
        return d == 0 ? std::numeric_limits<double>::infinity() : room / std::abs(d) - 1;
    };
    const double steps =
        std::min(along(from.x, step.x(), grid.width()), along(from.y, step.y(), grid.height()));
    return std::max(0, static_cast<int>(steps));
}
}  // namespace

OctagonGrower::OctagonGrower(const ClassifiedGrid& closedDoors, const DistanceMap& distances,
                             double widestDoor_cells)
    : m_grid(closedDoors), m_distances(distances), m_squaredHalfDoor(widestDoor_cells * widestDoor_cells / 4)
{
}

/** Walks from the centre cell by cell until it leaves the free space, with leaps where nothing can be near.
 *
 * The grid's border is no obstacle, so that no leap may end beyond it. No obstacle is nearer than the
 * clearance c. A closed door of half length h whose jambs are at least c away is at least sqrt(c^2 - h^2)
 * away.
 */
OctagonGrower::Ray OctagonGrower::castRay(Cell from, const Eigen::Vector2d& direction) const
{
    const double stepsPerCell = direction.cwiseAbs().maxCoeff(), step = 1.0 / stepsPerCell;
    const Eigen::Vector2d move = step * direction;
    const int inside = stepsInside(m_grid, from, move);
    double length = 0;
    for (int k = 1;;) {
        const Cell c{from.x + roundToCell(k * move.x()), from.y + roundToCell(k * move.y())};
        if (k > inside && !m_grid.contains(c)) return {length, false};
        const CellState state = m_grid.at(c);
        if (state == CellState::Unknown) return {length, false};
        length = k * step;
        if (state == CellState::Occupied) return {length, true};
        const double squared = m_distances.squared[m_distances.index(c)] - m_squaredHalfDoor;
        const int leap = squared > 16 ? static_cast<int>((std::sqrt(squared) - 2) * stepsPerCell) : 1;
        k = std::max(k + 1, std::min(k + leap, inside));
    }
}

Eigen::Vector2d OctagonGrower::growVertex(const Circle& circle, double axis_rad, double limit) const
{
    const int rays = std::clamp(static_cast<int>(std::ceil(circle.radius_cells * kBeam)), 4, kMaxRaysPerBeam);
    Ray best;
    Eigen::Vector2d bestDirection(std::cos(axis_rad), std::sin(axis_rad));
    for (int k = 0; k <= rays; ++k) {
        const double angle = axis_rad + kBeam * (static_cast<double>(k) / rays - 0.5);
        const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
        const Ray ray = castRay(circle.center, direction);
        if (ray.hits < best.hits || (ray.hits == best.hits && ray.length <= best.length)) continue;
        best = ray;
        bestDirection = direction;
    }
    const double reach = std::max(circle.radius_cells, best.length);
    return Eigen::Vector2d(circle.center.x, circle.center.y) + std::min(reach, limit) * bestDirection;
}
Octagon OctagonGrower::grow(const Circle& circle, const std::vector<Circle>& neighbours) const
{
    Octagon octagon;
    for (int k = 0; k < 8; ++k) {
        const double axis = kBeam * k;
        octagon[static_cast<std::size_t>(k)] =
            growVertex(circle, axis, limitOfEq10(circle, neighbours, axis));
    }
    return octagon;
}

std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points)
{
    const auto less = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    };
    std::sort(points.begin(), points.end(), less);
    const auto turnsLeft = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) > 0;
    };
    std::vector<Eigen::Vector2d> hull;
    const auto addChain = [&](const std::vector<Eigen::Vector2d>& chain) {
        const std::size_t start = hull.size();
        for (const auto& p : chain) {
            while (hull.size() >= start + 2 && !turnsLeft(hull[hull.size() - 2], hull.back(), p))
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // the last point starts the other chain
    };
    addChain(points);
    std::reverse(points.begin(), points.end());
    addChain(points);
    return hull;
}
}  // namespace gr2to
