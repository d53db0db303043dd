#include <algorithm>
#include <utility>

#include "support/building/FloorPlan.h"

namespace gr2to::test
{
namespace
{
constexpr double kGap_m = 0.6;        //!< way left between pieces, and from walls that a piece does not touch
constexpr double kDoorZone_m = 0.9;   //!< depth of the floor kept free before a door
constexpr double kDoorSide_m = 0.15;  //!< and how much wider than the door it is
constexpr double kPassage_m = 1.2;    //!< way left in a furnished corridor
constexpr double kLeg_m = 0.08;       //!< thickness of legs: at 0.05 m every leg is seen
constexpr double kOverhang_m = 0.1;   //!< of a table's top over its legs
constexpr double kChair_m = 0.45;

/** A piece in a frame of its own: the wall, if it stands at one, along y = 0, the room above. */
struct Piece
{
    double width = 0, depth = 0;
    bool atWall = true;
    std::vector<Rect> solids = {};
};

void addLegs(Piece& piece, const Rect& top, double inset)
{
    for (const double x : {top.x0 + inset, top.x1 - inset - kLeg_m})
        for (const double y : {top.y0 + inset, top.y1 - inset - kLeg_m})
            piece.solids.push_back({x, y, x + kLeg_m, y + kLeg_m});
}

void addChair(Piece& piece, double x, double y)
{
    addLegs(piece, {x, y, x + kChair_m, y + kChair_m}, 0.0);
}

Piece solidPiece(double width, double depth, bool atWall)
{
    return {width, depth, atWall, {{0, 0, width, depth}}};
}

/** A desk at a wall, drawers at one end, and a chair before it. */
Piece desk(SeededRandom& random)
{
    const double top = 0.8;
    Piece piece{random.between(1.4, 1.8), top + 0.15 + kChair_m, true};
    addLegs(piece, {0, 0, piece.width, top}, kOverhang_m);
    if (random.chance(0.5)) piece.solids.push_back({piece.width - 0.45, 0, piece.width, 0.6});
    addChair(piece, random.between(0.3, piece.width - 0.8), top + 0.15);
    return piece;
}

/** A table with chairs at its long sides, free in the room. */
Piece table(double longest, SeededRandom& random)
{
    const int seats = random.integer(1, std::max(1, static_cast<int>(longest / 0.8)));
    const double gap = 0.15, top = 0.9;
    Piece piece{0.8 * seats + 0.4, top + 2 * (gap + kChair_m), false};
    addLegs(piece, {0, kChair_m + gap, piece.width, kChair_m + gap + top}, kOverhang_m);
    for (int seat = 0; seat < seats; ++seat) {
        const double x = 0.2 + 0.8 * seat + (0.8 - kChair_m) / 2;
        addChair(piece, x, 0);
        addChair(piece, x, piece.depth - kChair_m);
    }
    return piece;
}

Piece anyPiece(const Rect& floor, bool corridor, SeededRandom& random)
{
    if (corridor) return solidPiece(random.between(0.5, 1.6), random.between(0.3, 0.45), true);
    const double kind = random.unit();
    if (kind < 0.4) return solidPiece(random.between(0.6, 2.4), random.between(0.35, 0.6), true);
    if (kind < 0.7) return desk(random);
    if (kind < 0.85) return table(std::max(floor.width(), floor.height()) / 2, random);
    if (kind < 0.92) return solidPiece(random.between(1.6, 2.2), random.between(0.8, 1.0), true);
    const double column = random.between(0.3, 0.6);
    return solidPiece(column, column, random.chance(0.5));
}

/** Furnishes one rectangle of floor. */
class Furnisher
{
 public:
    Furnisher(const Rect& floor, bool corridor, std::vector<Rect> doorZones, SeededRandom& random)
        : m_floor(floor), m_corridor(corridor), m_doorZones(std::move(doorZones)), m_random(random)
    {
    }

    std::vector<Rect> run(double share)
    {
        const double wanted = share * m_floor.area();
        const int tries = 20 + static_cast<int>(2 * m_floor.area());
        double covered = 0;
        for (int i = 0; i < tries && covered < wanted; ++i) {
            const Piece piece = anyPiece(m_floor, m_corridor, m_random);
            const int side = m_random.integer(0, 3);
            if (place(piece, side)) covered += piece.width * piece.depth;
        }
        return std::move(m_solids);
    }

 private:
    /** From the frame of a wall (0 below, 1 right, 2 above, 3 left; x counter-clockwise along it) to the
     * building's. */
    Rect placed(const Rect& r, int side) const
    {
        const Rect& f = m_floor;
        if (side == 0) return {f.x0 + r.x0, f.y0 + r.y0, f.x0 + r.x1, f.y0 + r.y1};
        if (side == 1) return {f.x1 - r.y1, f.y0 + r.x0, f.x1 - r.y0, f.y0 + r.x1};
        if (side == 2) return {f.x1 - r.x1, f.y1 - r.y1, f.x1 - r.x0, f.y1 - r.y0};
        return {f.x0 + r.y0, f.y1 - r.x1, f.x0 + r.y1, f.y1 - r.x0};
    }

    bool place(const Piece& piece, int side)
    {
        const bool along = side % 2 == 0;
        const double length = along ? m_floor.width() : m_floor.height();
        const double depth = along ? m_floor.height() : m_floor.width();
        const double beside = length - piece.width, before = depth - piece.depth;
        if (beside < (piece.atWall ? kGap_m : 2 * kGap_m)) return false;
        if (before < (m_corridor ? kPassage_m : piece.atWall ? kGap_m : 2 * kGap_m)) return false;
        double x = m_random.between(0, beside), y = m_random.between(0, before);
        if (piece.atWall) {
            y = 0;
            if (x < kGap_m)
                x = 0;
            else if (beside - x < kGap_m)
                x = beside;
        } else {
            x = std::clamp(x, kGap_m, beside - kGap_m);
            y = std::clamp(y, kGap_m, before - kGap_m);
        }
        const Rect footprint = placed({x, y, x + piece.width, y + piece.depth}, side);
        const auto hit = [](const Rect& r) { return [&r](const Rect& other) { return r.overlaps(other); }; };
        const Rect wide = footprint.grown(m_corridor ? kPassage_m : kGap_m);
        if (std::any_of(m_doorZones.begin(), m_doorZones.end(), hit(footprint))) return false;
        if (std::any_of(m_footprints.begin(), m_footprints.end(), hit(wide))) return false;
        m_footprints.push_back(footprint);
        for (const auto& s : piece.solids)
            m_solids.push_back(placed({s.x0 + x, s.y0 + y, s.x1 + x, s.y1 + y}, side));
        return true;
    }

    Rect m_floor;
    bool m_corridor;
    std::vector<Rect> m_doorZones;
    SeededRandom& m_random;
    std::vector<Rect> m_footprints, m_solids;
};

/** The floor on both sides of a door that stays free. */
Rect doorZone(const PlanDoor& door, double wallThickness)
{
    const double along = door.width / 2 + kDoorSide_m, across = wallThickness / 2 + kDoorZone_m;
    const auto c = door.centre();
    const double dx = door.wall.vertical ? across : along, dy = door.wall.vertical ? along : across;
    return {c.x() - dx, c.y() - dy, c.x() + dx, c.y() + dy};
}
}  // namespace

void furnish(FloorPlan& plan, const TBuildingOptions& options)
{
    if (options.furniture == 0.0) return;
    std::vector<std::vector<Rect>> zones(plan.rooms.size());
    for (const auto& door : plan.doors)
        for (const auto room : {door.wall.low, door.wall.high})
            zones[room].push_back(doorZone(door, options.wall_thickness));
    for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
        const auto& room = plan.rooms[i];
        SeededRandom random(options.seed, SeededRandom::Purpose::Furniture, i);
        // corridors are kept clear for escape: a few cupboards at most, and none where two arms meet
        const double share = options.furniture * (room.corridor ? 0.15 : random.between(0.6, 1.4));
        for (const auto& floor : room.floor) {
            auto keptFree = zones[i];
            for (const auto& other : room.floor)
                if (&other != &floor) keptFree.push_back(other.grown(kPassage_m));
            const auto solids = Furnisher(floor, room.corridor, std::move(keptFree), random).run(share);
            plan.furniture.insert(plan.furniture.end(), solids.begin(), solids.end());
        }
    }
}
}  // namespace gr2to::test
