#include <algorithm>
#include <numeric>
#include <utility>

#include "support/building/FloorPlan.h"

namespace gr2to::test
{
namespace
{
constexpr double kDoubleDoor = 1.5;  //!< width of a double door, in single ones

/** Rooms that are joined so far. */
class Groups
{
 public:
    explicit Groups(std::size_t count) : m_parent(count)
    {
        std::iota(m_parent.begin(), m_parent.end(), std::size_t{0});
    }
    std::size_t of(std::size_t i)
    {
        while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    bool join(std::size_t a, std::size_t b)
    {
        a = of(a), b = of(b);
        m_parent[std::max(a, b)] = std::min(a, b);
        return a != b;
    }

 private:
    std::vector<std::size_t> m_parent;
};

class DoorPlanner
{
 public:
    DoorPlanner(FloorPlan& plan, const std::vector<Boundary>& boundaries, const TBuildingOptions& options)
        : m_plan(plan),
          m_o(options),
          m_random(options.seed, SeededRandom::Purpose::Doors),
          m_groups(plan.rooms.size())
    {
        std::copy_if(boundaries.begin(), boundaries.end(), std::back_inserter(m_walls),
                     [&](const Boundary& b) { return space(b) >= m_o.door_max_width; });
    }

    void run()
    {
        std::vector<bool> used(m_walls.size(), false);
        for (const auto i : byCost()) {
            used[i] = m_groups.join(m_walls[i].low, m_walls[i].high);
            if (used[i]) place(m_walls[i], from(m_walls[i]), to(m_walls[i]));
        }
        for (std::size_t i = 0; i < m_walls.size(); ++i) addMore(m_walls[i], used[i]);
        dropUnreachable();
    }

 private:
    double clearEnd() const { return m_o.wall_thickness / 2 + kJamb_m; }
    double from(const Boundary& b) const { return b.from + clearEnd(); }
    double to(const Boundary& b) const { return b.to - clearEnd(); }
    double space(const Boundary& b) const { return to(b) - from(b); }
    int corridors(const Boundary& b) const
    {
        return (m_plan.rooms[b.low].corridor ? 1 : 0) + (m_plan.rooms[b.high].corridor ? 1 : 0);
    }

    /** Corridors join each other first, rooms join a corridor, and only where there is none another room. */
    std::vector<std::size_t> byCost()
    {
        std::vector<bool> suite;
        for (const auto& room : m_plan.rooms) suite.push_back(!room.corridor && m_random.chance(m_o.suites));
        std::vector<double> cost;
        for (const auto& wall : m_walls) {
            const int through = corridors(wall);
            const bool avoided = through == 1 && (suite[wall.low] || suite[wall.high]);
            cost.push_back((avoided ? 4.0 : 2.0 - through) + m_random.between(0, 0.9));
        }
        std::vector<std::size_t> order(m_walls.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return cost[a] < cost[b]; });
        return order;
    }

    void place(const Boundary& wall, double low, double high)
    {
        PlanDoor door;
        door.wall = wall;
        door.width = m_random.between(m_o.door_min_width, m_o.door_max_width);
        if (m_random.chance(m_o.double_doors) && kDoubleDoor * door.width <= high - low)
            door.width *= kDoubleDoor;
        const double slack = high - low - door.width;
        const bool atEnd = m_random.chance(0.6);
        const double offset = atEnd ? std::min(slack, m_random.between(0, 0.2)) : m_random.between(0, slack);
        door.along = m_random.chance(0.5) ? low + offset + door.width / 2 : high - offset - door.width / 2;
        if (corridors(wall) == 2) door.along = (low + high) / 2;
        door.closed = m_random.chance(m_o.closed_doors);
        m_plan.doors.push_back(door);
    }

    /** Doors beyond the needed ones: fire doors, a second door in a long wall, doors between neighbours. */
    void addMore(const Boundary& wall, bool used)
    {
        const int through = corridors(wall);
        const bool wanted = m_random.chance(through == 0 ? m_o.extra_doors / 2 : m_o.extra_doors);
        if (!used && (through == 2 || wanted)) place(wall, from(wall), to(wall));
        if (!used || !wanted || through != 1) return;
        const auto& first = *std::find_if(m_plan.doors.begin(), m_plan.doors.end(), [&](const PlanDoor& d) {
            return d.wall.low == wall.low && d.wall.high == wall.high && d.wall.from == wall.from;
        });
        const double pillar = m_o.door_max_width;
        const double before = first.along - first.width / 2 - pillar,
                     after = first.along + first.width / 2 + pillar;
        if (to(wall) - after >= m_o.door_max_width)
            place(wall, after, to(wall));
        else if (before - from(wall) >= m_o.door_max_width)
            place(wall, from(wall), before);
    }

    /** Keeps the largest group of joined rooms; any other is a shaft that nobody enters. */
    void dropUnreachable()
    {
        std::vector<std::size_t> size(m_plan.rooms.size(), 0);
        for (std::size_t i = 0; i < size.size(); ++i) ++size[m_groups.of(i)];
        const auto kept = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
        std::vector<std::size_t> number(size.size(), 0);
        std::vector<PlanRoom> rooms;
        for (std::size_t i = 0; i < size.size(); ++i)
            if (m_groups.of(i) == kept) {
                number[i] = rooms.size();
                rooms.push_back(std::move(m_plan.rooms[i]));
            }
        const auto shut = [&](const PlanDoor& d) { return m_groups.of(d.wall.low) != kept; };
        m_plan.doors.erase(std::remove_if(m_plan.doors.begin(), m_plan.doors.end(), shut),
                           m_plan.doors.end());
        for (auto& door : m_plan.doors)
            door.wall.low = number[door.wall.low], door.wall.high = number[door.wall.high];
        m_plan.rooms = std::move(rooms);
    }

    FloorPlan& m_plan;
    const TBuildingOptions& m_o;
    SeededRandom m_random;
    Groups m_groups;
    std::vector<Boundary> m_walls;
};
}  // namespace

void placeDoors(FloorPlan& plan, const std::vector<Boundary>& boundaries, const TBuildingOptions& options)
{
    DoorPlanner(plan, boundaries, options).run();
}
}  // namespace gr2to::test
