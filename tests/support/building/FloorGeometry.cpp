#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "support/building/FloorPlan.h"

namespace gr2to::test
{
namespace
{
/** Lengths below this are rounding [m]. */
constexpr double kRounding_m = 1e-6;

bool same(double a, double b)
{
    return std::abs(a - b) < kRounding_m;
}

/** The stretch that two rectangles share, if any; `a` may lie on either side. */
bool shareEdge(const Rect& a, const Rect& b, Boundary& boundary, bool& aIsLow)
{
    const double fromY = std::max(a.y0, b.y0), toY = std::min(a.y1, b.y1);
    const double fromX = std::max(a.x0, b.x0), toX = std::min(a.x1, b.x1);
    if ((same(a.x1, b.x0) || same(b.x1, a.x0)) && toY - fromY > kRounding_m) {
        aIsLow = same(a.x1, b.x0);
        boundary.vertical = true;
        boundary.line = aIsLow ? a.x1 : a.x0;
        boundary.from = fromY, boundary.to = toY;
        return true;
    }
    if ((same(a.y1, b.y0) || same(b.y1, a.y0)) && toX - fromX > kRounding_m) {
        aIsLow = same(a.y1, b.y0);
        boundary.vertical = false;
        boundary.line = aIsLow ? a.y1 : a.y0;
        boundary.from = fromX, boundary.to = toX;
        return true;
    }
    return false;
}

/** Sorted coordinates without near-duplicates. */
std::vector<double> distinct(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end(), same), values.end());
    return values;
}

/** Outline of a union of disjoint rectangles without holes: the sides of a coarse grid that have floor at
 * their left. */
std::vector<Eigen::Vector2d> outlineOf(const std::vector<Rect>& floor)
{
    std::vector<double> xs, ys;
    for (const auto& r : floor) {
        xs.insert(xs.end(), {r.x0, r.x1});
        ys.insert(ys.end(), {r.y0, r.y1});
    }
    xs = distinct(xs), ys = distinct(ys);
    const auto covered = [&](int i, int j) {
        if (i < 0 || j < 0 || i + 1 >= static_cast<int>(xs.size()) || j + 1 >= static_cast<int>(ys.size()))
            return false;
        const auto c = static_cast<std::size_t>(i), r = static_cast<std::size_t>(j);
        const double x = (xs[c] + xs[c + 1]) / 2, y = (ys[r] + ys[r + 1]) / 2;
        return std::any_of(floor.begin(), floor.end(), [&](const Rect& f) {
            return Rect{x, y, x, y}.inside(f);
        });
    };
    using Node = std::pair<int, int>;
    std::map<Node, Node> next;
    for (int i = 0; i + 1 < static_cast<int>(xs.size()); ++i)
        for (int j = 0; j + 1 < static_cast<int>(ys.size()); ++j) {
            if (!covered(i, j)) continue;
            if (!covered(i, j - 1)) next[{i, j}] = {i + 1, j};
            if (!covered(i + 1, j)) next[{i + 1, j}] = {i + 1, j + 1};
            if (!covered(i, j + 1)) next[{i + 1, j + 1}] = {i, j + 1};
            if (!covered(i - 1, j)) next[{i, j + 1}] = {i, j};
        }
    std::vector<Eigen::Vector2d> outline;
    const Node start = next.begin()->first;  // leftmost, then lowest: a corner
    Node node = start;
    do {
        const Node after = next.at(node), beyond = next.at(after);
        const bool turns = (after.first == node.first) != (beyond.first == after.first);
        if (turns)
            outline.emplace_back(xs[static_cast<std::size_t>(after.first)],
                                 ys[static_cast<std::size_t>(after.second)]);
        node = after;
    } while (node != start);
    return outline;
}

/** One side of a room's outline, with what is behind each stretch of it. */
void addSide(FloorPlan& plan, std::size_t room, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
             const std::vector<Boundary>& mine, const TBuildingOptions& options)
{
    const bool vertical = same(from.x(), to.x());
    const int axis = vertical ? 1 : 0;
    const double low = std::min(from[axis], to[axis]), high = std::max(from[axis], to[axis]);
    const double line = from[1 - axis];
    const bool forward = to[axis] > from[axis];
    const auto add = [&](double a, double b, long behind) {
        if (b - a <= options.wall_thickness) return;
        Eigen::Vector2d p = from, q = to;
        p[axis] = forward ? a : b, q[axis] = forward ? b : a;
        plan.walls.push_back(
            {room, behind, p, q, behind < 0 ? options.outer_wall_thickness : options.wall_thickness});
    };
    double reached = low;
    for (const auto& b : mine) {
        if (b.vertical != vertical) continue;
        // the room is above a wall that it walks forward along, and left of one that it walks upward along
        const bool roomIsHigh = vertical ? !forward : forward;
        if ((b.high == room) != roomIsHigh ||
            !same(b.line, line + (roomIsHigh ? -0.5 : 0.5) * options.wall_thickness))
            continue;
        if (b.to <= low || b.from >= high) continue;
        add(reached, b.from, -1);
        add(std::max(b.from, low), std::min(b.to, high), static_cast<long>(roomIsHigh ? b.low : b.high));
        reached = b.to;
    }
    add(reached, high, -1);
}
}  // namespace

double PlanRoom::area() const
{
    return std::accumulate(floor.begin(), floor.end(), 0.0,
                           [](double sum, const Rect& r) { return sum + r.area(); });
}

void constructFloors(std::vector<PlanRoom>& rooms, double wallThickness)
{
    const double half = wallThickness / 2;
    for (auto& room : rooms) {
        for (const auto& part : room.parts) room.floor.push_back(part.grown(-half));
        for (std::size_t i = 0; i < room.parts.size(); ++i)
            for (std::size_t j = i + 1; j < room.parts.size(); ++j) {
                Boundary joint;
                bool low = false;
                if (!shareEdge(room.parts[i], room.parts[j], joint, low)) continue;
                const double a = joint.from + half, b = joint.to - half, c = joint.line - half,
                             d = joint.line + half;
                room.floor.push_back(joint.vertical ? Rect{c, a, d, b} : Rect{a, c, b, d});
            }
        room.outline = outlineOf(room.floor);
    }
}

std::vector<Boundary> findBoundaries(const std::vector<PlanRoom>& rooms, const TBuildingOptions& options)
{
    const auto columns = static_cast<std::size_t>(options.tiles_x);
    const auto tiles = columns * static_cast<std::size_t>(options.tiles_y);
    std::vector<std::vector<std::size_t>> inTile(tiles);
    for (std::size_t i = 0; i < rooms.size(); ++i) inTile[rooms[i].tile].push_back(i);
    std::vector<Boundary> boundaries;
    const auto meet = [&](std::size_t a, std::size_t b) {
        for (const auto& p : rooms[a].parts)
            for (const auto& q : rooms[b].parts) {
                Boundary boundary;
                bool aIsLow = false;
                if (!shareEdge(p, q, boundary, aIsLow)) continue;
                boundary.low = aIsLow ? a : b, boundary.high = aIsLow ? b : a;
                boundaries.push_back(boundary);
            }
    };
    for (std::size_t t = 0; t < tiles; ++t)
        for (const auto a : inTile[t]) {
            for (const auto b : inTile[t])
                if (a < b) meet(a, b);
            if ((t + 1) % columns != 0)
                for (const auto b : inTile[t + 1]) meet(a, b);
            if (t + columns < tiles)
                for (const auto b : inTile[t + columns]) meet(a, b);
        }
    return boundaries;
}

void findWalls(FloorPlan& plan, const TBuildingOptions& options)
{
    std::vector<std::vector<Boundary>> ofRoom(plan.rooms.size());
    for (const auto& boundary : findBoundaries(plan.rooms, options)) {
        ofRoom[boundary.low].push_back(boundary);
        ofRoom[boundary.high].push_back(boundary);
    }
    for (std::size_t room = 0; room < plan.rooms.size(); ++room) {
        auto& mine = ofRoom[room];
        std::sort(mine.begin(), mine.end(),
                  [](const Boundary& a, const Boundary& b) { return a.from < b.from; });
        const auto& outline = plan.rooms[room].outline;
        for (std::size_t i = 0; i < outline.size(); ++i)
            addSide(plan, room, outline[i], outline[(i + 1) % outline.size()], mine, options);
    }
}
}  // namespace gr2to::test
