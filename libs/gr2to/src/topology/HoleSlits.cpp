#include "gr2to/topology/HoleSlits.h"

#include <algorithm>
#include <cmath>

namespace gr2to
{
namespace
{
using Eigen::Vector2d;

constexpr double kLeftInside =
    0.01;  // of a place's cells, as much as half the error that its outline may have

Cell cellAbove(const Vector2d& corner)
{
    return {static_cast<int>(std::lround(corner.x() + 0.5)), static_cast<int>(std::lround(corner.y() + 0.5))};
}

/** A point in a cell on the left of a ring. */
Vector2d pointBeside(const std::vector<Vector2d>& corners)
{
    constexpr double side_cells = 0.49, inside_cells = 0.4;  // sides of cut-off corners are shorter
    std::size_t k = 0;
    while (k + 2 < corners.size() && (corners[k + 1] - corners[k]).norm() < side_cells) ++k;
    const Vector2d along = (corners[k + 1] - corners[k]).normalized();
    return 0.5 * (corners[k] + corners[k + 1]) + inside_cells * Vector2d(-along.y(), along.x());
}

bool encloses(const std::vector<Vector2d>& polygon, const Vector2d& p)
{
    bool inside = false;
    for (std::size_t k = 0, before = polygon.size() - 1; k < polygon.size(); before = k++) {
        const Vector2d &a = polygon[k], &b = polygon[before];
        if ((a.y() > p.y()) == (b.y() > p.y())) continue;
        if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside;
}

/** Finds the holes of places that may not stay inside their outlines. */
class HoleChooser
{
 public:
    HoleChooser(const LabelArcs& arcs, std::size_t count)
        : m_arcs(arcs), m_holes(count + 1), m_cells(count + 1, 0)
    {
        for (const std::size_t r : mainRings(arcs, count))
            if (r < arcs.rings.size())
                m_places.push_back({pointBeside(cornersOf(arcs, arcs.rings[r])), arcs.rings[r].area_cells});
        for (std::size_t r = 0; r < arcs.rings.size(); ++r) {
            const LabelRing& ring = arcs.rings[r];
            m_cells[ring.label] += ring.area_cells;
            if (ring.area_cells < 0) m_holes[ring.label].push_back(r);
        }
    }

    std::vector<std::size_t> choose()
    {
        std::vector<std::size_t> chosen;
        for (std::size_t label = 1; label < m_holes.size(); ++label) {
            auto& holes = m_holes[label];
            std::stable_sort(holes.begin(), holes.end(), [&](std::size_t a, std::size_t b) {
                return m_arcs.rings[a].area_cells > m_arcs.rings[b].area_cells;  // both negative
            });
            double left = kLeftInside * m_cells[label];
            for (const std::size_t hole : holes) {
                left += m_arcs.rings[hole].area_cells;
                if (left < 0 || holdsPlace(m_arcs.rings[hole])) chosen.push_back(hole);
            }
        }
        return chosen;
    }

 private:
    bool holdsPlace(const LabelRing& hole) const
    {
        const auto mayHold = [&](const Inside& place) { return place.area_cells <= -hole.area_cells; };
        if (std::none_of(m_places.begin(), m_places.end(), mayHold)) return false;
        const std::vector<Vector2d> polygon = cornersOf(m_arcs, hole);
        return std::any_of(m_places.begin(), m_places.end(), [&](const Inside& place) {
            return mayHold(place) && encloses(polygon, place.point);
        });
    }

    /** A point of a place, and the area of the place's outline. */
    struct Inside
    {
        Vector2d point;
        double area_cells = 0;
    };

    const LabelArcs& m_arcs;
    std::vector<Inside> m_places;
    std::vector<std::vector<std::size_t>> m_holes;  //!< of each label
    std::vector<double> m_cells;                    //!< of each label
};

/** The cell of a hole that is farthest to the left, in the middle of its side: at a corner the slit would go
 * on along another side. */
Cell leftmostCell(const std::vector<Vector2d>& corners)
{
    Cell best{0, 0};
    bool found = false;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Cell from = cellAbove(corners[k]), to = cellAbove(corners[(k + 1) % corners.size()]);
        if (from.x != to.x || from.y >= to.y) continue;  // the place is on the left of sides that go up
        if (found && from.x >= best.x) continue;
        best = {from.x, (from.y + to.y - 1) / 2};
        found = true;
    }
    return best;
}
}  // namespace

std::vector<std::size_t> mainRings(const LabelArcs& arcs, std::size_t count)
{
    std::vector<std::size_t> main(count + 1, arcs.rings.size());
    for (std::size_t r = 0; r < arcs.rings.size(); ++r) {
        std::size_t& best = main[arcs.rings[r].label];
        const double least = best < arcs.rings.size() ? arcs.rings[best].area_cells : 0;
        if (arcs.rings[r].area_cells > least) best = r;
    }
    return main;
}

std::vector<Vector2d> cornersOf(const LabelArcs& arcs, const LabelRing& ring)
{
    std::vector<Vector2d> corners;
    for (const HalfArc& side : ring.sides) {
        const auto& points = arcs.arcs[side.arc].points;
        if (side.reversed)
            corners.insert(corners.end(), points.rbegin(), points.rend() - 1);
        else
            corners.insert(corners.end(), points.begin(), points.end() - 1);
    }
    return corners;
}

std::vector<Cell> findSlits(const LabelArcs& arcs, std::size_t count, const PlaceImage& image)
{
    std::vector<Cell> slits;
    for (const std::size_t hole : HoleChooser(arcs, count).choose()) {
        const Cell start = leftmostCell(cornersOf(arcs, arcs.rings[hole]));
        for (Cell c{start.x - 1, start.y}; c.x >= 0 && image.at(c) == arcs.rings[hole].label; --c.x)
            slits.push_back(c);
    }
    return slits;
}
}  // namespace gr2to
