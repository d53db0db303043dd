#include "gr2to/topology/WallMaker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gr2to/grid/Jambs.h"
#include "gr2to/topology/MeasuredHeight.h"
#include "gr2to/topology/WallFit.h"
#include "gr2to/topology/WallSupport.h"
#include "inSpace.h"

namespace gr2to
{
namespace
{
using Eigen::Vector2d;

constexpr double kShortest_cells = 0.5;  // a side below that has no direction
constexpr double kHalfSlit_cells = 0.5;  // from a slit's side to its middle
constexpr double kMostlyInside =
    0.8;  // a side through the middle of steps has about half of its place beside it
constexpr double kAnyDirection = -1;  // least cosine between a side and the line that is fitted to it
constexpr double kAlongSide = 0.98;   // within 11 degrees

/** Whether all vertices of a polygon after `first` and before `last` are near the line between these two. */
bool isStraight(const std::vector<Vector2d>& polygon, std::size_t first, std::size_t last, double tolerance)
{
    const std::size_t n = polygon.size();
    const Vector2d &a = polygon[first % n], along = polygon[last % n] - a;
    const double squared = along.squaredNorm();
    if (squared == 0) return false;
    for (std::size_t k = first + 1; k < last; ++k) {
        const Vector2d offset = polygon[k % n] - a;
        const double t = offset.dot(along) / squared;
        if (t < 0 || t > 1 || (offset - t * along).norm() > tolerance) return false;
    }
    return true;
}
/** Whether a place is on the right of a side of its own outline, but for some cells. */
bool isInside(const Vector2d& from, const Vector2d& to, const PlaceImage& places, PlaceId id)
{
    const Vector2d along = to - from;
    const Vector2d outwards = kHalfSlit_cells / along.norm() * Vector2d(along.y(), -along.x());
    const int samples = std::max(1, static_cast<int>(along.norm()));  // one a cell
    int inside = 0;
    for (int k = 0; k < samples; ++k) {
        const Vector2d p = from + (k + 0.5) / samples * along + outwards;
        const Cell c{roundToCell(p.x()), roundToCell(p.y())};
        const bool inImage = c.x >= 0 && c.y >= 0 && c.x < places.width && c.y < places.height;
        inside += inImage && places.at(c) == id ? 1 : 0;
    }
    return inside > kMostlyInside * samples;
}
}  // namespace

std::vector<Wall> WallMaker::fromSides(const std::vector<Vector2d>& outline)
{
    std::vector<Wall> walls;
    for (std::size_t k = 0; k < outline.size(); ++k)
        if (const Vector2d& next = outline[(k + 1) % outline.size()];
            (next - outline[k]).norm() >= kShortest_cells)
            walls.push_back(wallAlong(sideBetween(outline[k], next), kAnyDirection));
    return walls;
}

std::vector<Wall> WallMaker::fromRuns(const std::vector<Vector2d>& outline, double tolerance_cells,
                                      const PlaceImage& places, PlaceId id)
{
    const std::size_t n = outline.size();
    std::vector<Side> sides;
    for (std::size_t k = 0; k < n; ++k) sides.push_back(sideBetween(outline[k], outline[(k + 1) % n]));
    const auto goesOn = [&](std::size_t first,
                            std::size_t last) {  // from the side before vertex `last` to that after
        return sides[first % n].real == sides[last % n].real &&
               isStraight(outline, first, last + 1, tolerance_cells);
    };
    std::size_t start = 0;  // at a corner, so that no run is cut in two
    while (start < n && goesOn(start + n - 1, start + n)) ++start;
    std::vector<Wall> walls;
    for (std::size_t first = start, last; first < start + n; first = last) {
        Side run = std::move(sides[first % n]);
        for (last = first + 1; last < start + n && goesOn(first, last); ++last) {
            const Side& next = sides[last % n];
            run.to = next.to;
            run.support.insert(run.support.end(), next.support.begin(), next.support.end());
        }
        if ((run.to - run.from).norm() < kShortest_cells) continue;
        if (!run.real && isInside(run.from, run.to, places, id)) continue;
        if (last > first + 1) {
            std::sort(run.support.begin(), run.support.end(), rasterLess);
            run.support.erase(std::unique(run.support.begin(), run.support.end()), run.support.end());
        }
        walls.push_back(wallAlong(run, kAlongSide));
    }
    return walls;
}

WallMaker::Side WallMaker::sideBetween(const Vector2d& from, const Vector2d& to) const
{
    Side side{from, to, {}, false};
    double covered = 0;
    side.support = wallSupport(m_grid, from, to, &covered);
    side.real = covered > m_realRatio;
    return side;
}

Wall WallMaker::wallAlong(const Side& side, double leastCosine)
{
    const GridFrame& frame = m_grid.frame();
    const Vector2d along = frame.directionToMap(side.to - side.from);
    const std::vector<Vector2d> ends{frame.toMap(side.from.x(), side.from.y()),
                                     frame.toMap(side.to.x(), side.to.y())};
    std::vector<Vector2d> support;
    support.reserve(side.support.size());
    for (const Cell c : side.support) support.push_back(frame.toMap(c));
    const bool fitted = side.real && support.size() >= 2;
    LineFit fit = fitLine(fitted ? support : ends, m_grid.resolution_m());
    if (fitted && std::abs(fit.direction.dot(along)) < leastCosine * along.norm())
        fit = fitLine(ends, m_grid.resolution_m());
    Wall wall;
    wall.id = ++m_count;
    wall.real = side.real;
    wall.position.mean = {fit.center.x(), fit.center.y(), 0};
    wall.position.covariance = inSpace(fit.centerCovariance);
    Vector2d normal(fit.direction.y(), -fit.direction.x());
    if (normal.dot(Vector2d(along.y(), -along.x())) < 0) normal = -normal;  // outwards: outlines turn left
    wall.normal.mean = {normal.x(), normal.y(), 0};
    wall.normal.covariance = inSpace(fit.normalCovariance);
    wall.size.length_m = wall.real ? fit.length_m : along.norm() * m_grid.resolution_m();
    wall.size.covariance(0, 0) = fit.lengthVariance;
    setHeight(m_heights, wall.real ? wallHeight(side.support, m_heights) : std::nullopt, wall.position,
              wall.size);
    return wall;
}
}  // namespace gr2to
