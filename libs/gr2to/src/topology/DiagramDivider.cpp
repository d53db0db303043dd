#include "gr2to/topology/DiagramDivider.h"

#include <algorithm>

#include "gr2to/grid/Jambs.h"

namespace gr2to
{
DiagramDivider::DiagramDivider(std::vector<ValidatedDoor> doors, const VoronoiGraph& voronoi,
                               const ClassifiedGrid& grid, Obstacles obstacles, const DistanceMap& distances,
                               double minRadius_cells, MeetingRule meeting)
    : m_curves(voronoi),
      m_grid(grid),
      m_obstacles(obstacles),
      m_distances(distances),
      m_minRadius(minRadius_cells),
      m_meeting(meeting),
      m_blocked(m_curves.size())
{
    m_graph.doors = std::move(doors);
}

PlaceGraph DiagramDivider::divide()
{
    const std::vector<Circle> found = findCircles();
    const auto leadsNowhere = [](const std::set<int>& sides) { return sides.empty() || *sides.begin() < 0; };
    const auto leadsBack = [](const std::set<int>& sides) { return sides.size() < 2 || *sides.begin() < 0; };
    do {
        do {
            m_graph.circles = found;
            blockDoors();
            m_graph.circleOfCell = addMissingCircles();  // parts, for now
        } while (dropDoors(leadsNowhere));
        m_graph.circleOfCell =
            m_meeting == MeetingRule::HalfWay
                ? m_curves.growCircles(m_graph.circles, m_graph.circleOfCell)
                : m_curves.floodCircles(m_graph.circles, m_graph.circleOfCell, m_distances);
    } while (dropDoors(leadsBack));
    linkAtOpenings();
    linkAtDoors();
    sortLinks();
    return std::move(m_graph);
}

/** For each cell of the diagram how far the stretch of its clearance goes on, at least, to either side. */
std::vector<int> DiagramDivider::depthInLevel() const
{
    const auto sameLevel = [&](std::size_t i, int n) {
        return m_distances.squared[m_distances.index(m_curves.cell(i))] ==
               m_distances.squared[m_distances.index(m_curves.cell(static_cast<std::size_t>(n)))];
    };
    std::vector<int> depth(m_curves.size(), -1);
    std::vector<std::size_t> queue;
    for (std::size_t i = 0; i < m_curves.size(); ++i)
        for (const int n : m_curves.neighbours(i))
            if (depth[i] < 0 && n >= 0 && !sameLevel(i, n)) {
                depth[i] = 0;
                queue.push_back(i);
            }
    for (std::size_t k = 0; k < queue.size(); ++k)
        for (const int n : m_curves.neighbours(queue[k]))
            if (n >= 0 && depth[static_cast<std::size_t>(n)] < 0) {
                depth[static_cast<std::size_t>(n)] = depth[queue[k]] + 1;
                queue.push_back(static_cast<std::size_t>(n));
            }
    return depth;
}

/** A circle for every cell that is wide enough, from large to small; of a level stretch the middle comes
 * first, so that turning the grid does not move the circles along corridors. */
std::vector<Circle> DiagramDivider::circlesBySize() const
{
    const std::vector<int> depth = depthInLevel();
    struct Ranked
    {
        Circle circle;
        int depth;
    };
    std::vector<Ranked> ranked;
    for (std::size_t i = 0; i < m_curves.size(); ++i)
        if (const double r = m_distances.clearance_cells(m_curves.cell(i)); r >= m_minRadius)
            ranked.push_back({{m_curves.cell(i), r}, depth[i]});
    std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
        return a.circle.radius_cells != b.circle.radius_cells ? a.circle.radius_cells > b.circle.radius_cells
                                                              : a.depth > b.depth;
    });
    std::vector<Circle> circles;
    circles.reserve(ranked.size());
    for (const Ranked& r : ranked) circles.push_back(r.circle);
    return circles;
}

/** Circles of all cells of the diagram, those of doors left out, thinned out by overlap and eq. (9). */
std::vector<Circle> DiagramDivider::findCircles() const
{
    const std::vector<Circle> all = circlesBySize();
    CircleIndex doorways(m_distances.width, m_distances.height);
    for (const ValidatedDoor& door : m_graph.doors)
        doorways.add({door.critical.cell, door.critical.clearance_cells});
    std::vector<Circle> circles = dropOverlapping(all, m_distances.width, m_distances.height);
    const auto liesInDoorway = [&](const Circle& circle) {
        return doorways.anyWithin(circle, 1.0, [&](const Circle& doorway) {
            return distance_cells(circle.center, doorway.center) < doorway.radius_cells;
        });
    };
    circles.erase(std::remove_if(circles.begin(), circles.end(), liesInDoorway), circles.end());
    return dropClose(circles, m_distances);
}

void DiagramDivider::blockDoors()
{
    m_blocked.assign(m_curves.size(), false);
    for (const ValidatedDoor& door : m_graph.doors)
        for (const Cell c : door.line)
            if (const int i = m_curves.find(c); i >= 0) m_blocked[static_cast<std::size_t>(i)] = true;
}

/** A part without a circle gets the one of its widest cell when that is wide enough for a place.
 * \return for each cell of the diagram a number of its part, for doors to tell their sides apart; -1 in parts
 * too narrow
 */
std::vector<int> DiagramDivider::addMissingCircles()
{
    int parts = 0;
    std::vector<int> partOf = m_curves.parts(m_blocked, &parts);
    std::vector<bool> hasCircle(static_cast<std::size_t>(parts), false);
    std::vector<Circle> widest(hasCircle.size());
    for (const Circle& circle : m_graph.circles)
        if (const int i = m_curves.find(circle.center); i >= 0 && partOf[static_cast<std::size_t>(i)] >= 0)
            hasCircle[static_cast<std::size_t>(partOf[static_cast<std::size_t>(i)])] = true;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        if (partOf[i] < 0) continue;
        Circle& best = widest[static_cast<std::size_t>(partOf[i])];
        const double r = m_distances.clearance_cells(m_curves.cell(i));
        if (r > best.radius_cells) best = {m_curves.cell(i), r};
    }
    for (std::size_t p = 0; p < widest.size(); ++p)
        if (!hasCircle[p] && widest[p].radius_cells >= m_minRadius) m_graph.circles.push_back(widest[p]);
    std::sort(m_graph.circles.begin(), m_graph.circles.end(),
              [](const Circle& a, const Circle& b) { return rasterLess(a.center, b.center); });
    for (int& part : partOf)
        if (part >= 0 && !hasCircle[static_cast<std::size_t>(part)] &&
            widest[static_cast<std::size_t>(part)].radius_cells < m_minRadius)
            part = -1;
    return partOf;
}

/** What circleOfCell has on the sides of a door, in order; -1 among it when a side is too narrow for a place.
 */
std::set<int> DiagramDivider::sidesOf(const ValidatedDoor& door) const
{
    std::set<int> sides;
    for (const Cell c : door.line) {
        const int i = m_curves.find(c);
        if (i < 0) continue;
        for (const int n : m_curves.neighbours(static_cast<std::size_t>(i)))
            if (n >= 0 && !m_blocked[static_cast<std::size_t>(n)])
                sides.insert(m_graph.circleOfCell[static_cast<std::size_t>(n)]);
    }
    return sides;
}

bool DiagramDivider::dropDoors(const std::function<bool(const std::set<int>& sides)>& useless)
{
    const auto last = std::remove_if(m_graph.doors.begin(), m_graph.doors.end(),
                                     [&](const ValidatedDoor& door) { return useless(sidesOf(door)); });
    const bool dropped = last != m_graph.doors.end();
    m_graph.doors.erase(last, m_graph.doors.end());
    return dropped;
}

void DiagramDivider::linkAtOpenings()
{
    for (std::size_t i = 0; i < m_curves.size(); ++i)
        for (std::size_t k = 0; k < 2; ++k)  // right and upper neighbour: each pair once
        {
            const int n = m_curves.neighbours(i)[k];
            if (n < 0) continue;
            const int a = m_graph.circleOfCell[i], b = m_graph.circleOfCell[static_cast<std::size_t>(n)];
            if (a < 0 || b < 0 || a == b) continue;
            addOpening(a, b, m_curves.cell(i));
            addBorder(a, b, m_curves.cell(i));
        }
}

/** Openings between the same places whose circles overlap are one opening: the wider counts. */
void DiagramDivider::addOpening(int a, int b, Cell at)
{
    PlaceLink link{static_cast<std::size_t>(std::min(a, b)), static_cast<std::size_t>(std::max(a, b)), at,
                   m_distances.clearance_cells(at), -1};
    for (std::size_t k : m_linksOf[{link.from, link.to}]) {
        PlaceLink& other = m_graph.links[k];
        if (distance_cells(other.at, at) >= other.clearance_cells + link.clearance_cells) continue;
        if (link.clearance_cells > other.clearance_cells) other = link;
        return;
    }
    m_linksOf[{link.from, link.to}].push_back(m_graph.links.size());
    m_graph.links.push_back(link);
}

void DiagramDivider::addBorder(int a, int b, Cell at)
{
    const auto jambs = findJambs(m_grid, m_obstacles, at, m_distances.clearance_cells(at));
    if (!jambs) return;  // the partition then meets half-way
    m_graph.borders.push_back({static_cast<std::size_t>(std::min(a, b)),
                               static_cast<std::size_t>(std::max(a, b)), criticalLine(m_grid, at, *jambs)});
}

void DiagramDivider::linkAtDoors()
{
    for (std::size_t d = 0; d < m_graph.doors.size(); ++d) {
        const ValidatedDoor& door = m_graph.doors[d];
        const std::set<int> sides = sidesOf(door);
        m_graph.links.push_back({static_cast<std::size_t>(*sides.begin()),
                                 static_cast<std::size_t>(*std::next(sides.begin())), door.critical.cell,
                                 door.critical.clearance_cells, static_cast<int>(d)});
    }
}

void DiagramDivider::sortLinks()
{
    std::sort(m_graph.links.begin(), m_graph.links.end(), [](const PlaceLink& a, const PlaceLink& b) {
        if (a.from != b.from) return a.from < b.from;
        if (a.to != b.to) return a.to < b.to;
        return rasterLess(a.at, b.at);
    });
}
}  // namespace gr2to
