#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "support/building/FloorPlan.h"

namespace gr2to::test
{
namespace
{
/** Rooms deeper than this many times room_max_size are cut in two. */
constexpr double kDeepest = 1.35;
/** Least side of a yard between wings [m]. */
constexpr double kYard_m = 3.0;

/** Lays out one tile around a corridor. Every function works in a frame of its own with the block's corner at
 * (0, 0); transform() then puts the rooms made since a mark into place. */
class TileLayout
{
 public:
    TileLayout(const TBuildingOptions& options, bool closed, SeededRandom random)
        : m_o(options),
          m_closed(closed),
          m_random(random),
          m_corridor(options.corridor_width + options.wall_thickness)
    {
    }

    std::vector<PlanRoom> run(const Rect& tile)
    {
        const std::string layout = m_o.layout == "auto" ? chosen(tile) : m_o.layout;
        const bool free = layout != "straight" && layout != "ring";
        const bool transposed = free ? m_random.chance(0.4) : tile.height() > tile.width();
        const double w = transposed ? tile.height() : tile.width();
        const double h = transposed ? tile.width() : tile.height();
        if (layout == "straight") straight(w, h);
        if (layout == "l") ell(w, h);
        if (layout == "t") tee(w, h);
        if (layout == "cross") cross(w, h);
        if (layout == "ring") ring(w, h);
        transform(0, w, h, m_random.chance(0.5), m_random.chance(0.5), 0, 0);
        for (auto& room : m_rooms)
            for (auto& part : room.parts) {
                if (transposed) part = {part.y0, part.x0, part.y1, part.x1};
                part = {part.x0 + tile.x0, part.y0 + tile.y0, part.x1 + tile.x0, part.y1 + tile.y0};
            }
        return std::move(m_rooms);
    }

 private:
    /** A layout that suits the size: wings of rooms that are neither too deep nor too shallow. */
    std::string chosen(const Rect& tile)
    {
        const double shorter = std::min(tile.width(), tile.height());
        std::vector<std::string> fitting;
        if (shorter <= m_corridor + 2 * kDeepest * m_o.room_max_size) fitting.push_back("straight");
        if (shorter >= 2 * m_corridor + 2.4 * m_o.room_max_size)
            fitting.insert(fitting.end(), {"ring", "ring"});
        // wings that leave no yard are deep blocks of rooms behind rooms: only where nothing else fits
        const bool wings = !m_closed || fitting.empty();
        if (wings && shorter >= m_corridor + 1.6 * m_o.room_max_size)
            fitting.insert(fitting.end(), {"l", "t"});
        if (wings && shorter >= m_corridor + 2.5 * m_o.room_max_size) fitting.push_back("cross");
        if (fitting.empty()) return "straight";
        return fitting[static_cast<std::size_t>(m_random.integer(0, static_cast<int>(fitting.size()) - 1))];
    }

    double depth(double available)
    {
        const double wanted =
            m_random.between(std::max(m_o.room_min_size, 0.7 * m_o.room_max_size), m_o.room_max_size);
        return std::max(m_o.room_min_size, std::min(wanted, available));
    }
    /** A position in the middle part of [0, length - corridor] that leaves room on both sides. */
    double middle(double length, double low, double high)
    {
        const double left = length - m_corridor;
        return std::clamp(left * m_random.between(low, high), m_o.room_min_size, left - m_o.room_min_size);
    }

    void addRoom(const Rect& r) { m_rooms.push_back({false, {r}}); }
    void addCorridor(std::vector<Rect> parts) { m_rooms.push_back({true, std::move(parts)}); }

    void transform(std::size_t first, double w, double h, bool mirrorX, bool mirrorY, double dx, double dy)
    {
        for (std::size_t i = first; i < m_rooms.size(); ++i)
            for (auto& p : m_rooms[i].parts) {
                if (mirrorX) p = {w - p.x1, p.y0, w - p.x0, p.y1};
                if (mirrorY) p = {p.x0, h - p.y1, p.x1, h - p.y0};
                p = {p.x0 + dx, p.y0 + dy, p.x1 + dx, p.y1 + dy};
            }
    }

    /** Lengths within the limits of a room that add up to `length`; most follow one module, as in real
     * buildings. */
    std::vector<double> slices(double length)
    {
        const double low = m_o.room_min_size, high = m_o.room_max_size;
        const double module = m_random.between(low, low + 0.6 * (high - low));
        std::vector<double> sizes;
        double sum = 0;
        while (sum < length - 0.5 * low) {
            sizes.push_back(m_random.chance(0.6) ? module : m_random.between(low, high));
            sum += sizes.back();
        }
        while (sizes.size() > 1 && static_cast<double>(sizes.size()) * low > length) {
            sum -= sizes.back();
            sizes.pop_back();
        }
        const double least = static_cast<double>(sizes.size()) * low;
        const double most = static_cast<double>(sizes.size()) * high;
        for (auto& size : sizes) {
            if (sum > length && sum > least)
                size = low + (size - low) * (length - least) / (sum - least);
            else if (sum < length && most > sum && most >= length)
                size = high - (high - size) * (most - length) / (most - sum);
            else
                size = length / static_cast<double>(sizes.size());
        }
        return sizes;
    }

    /** Rooms side by side along x, the corridor at y = 0; deep or, by chance, other ones have a room behind
     * them. */
    void strip(double w, double h)
    {
        double x = 0;
        const auto widths = slices(w);
        for (std::size_t i = 0; i < widths.size(); ++i) {
            const double next = i + 1 == widths.size() ? w : x + widths[i];
            const bool deep = h > kDeepest * m_o.room_max_size;
            if (deep || (h >= 2 * m_o.room_min_size && m_random.chance(0.15))) {
                const int count = deep ? static_cast<int>(std::ceil(h / m_o.room_max_size)) : 2;
                double y = 0;
                for (int k = 1; k <= count; ++k) {
                    const double slack = std::min(0.15, 0.5 - m_o.room_min_size * count / h / 2);
                    const double shift = slack > 0 ? m_random.between(-slack, slack) : 0.0;
                    const double end = k == count ? h : (k + shift) * h / count;
                    addRoom({x, y, next, end});
                    y = end;
                }
            } else
                addRoom({x, 0, next, h});
            x = next;
        }
    }
    /** A strip in the rectangle with its corridor below (or above). */
    void stripAlongX(const Rect& r, bool corridorAbove)
    {
        const auto first = m_rooms.size();
        strip(r.width(), r.height());
        transform(first, r.width(), r.height(), false, corridorAbove, r.x0, r.y0);
    }
    /** A strip in the rectangle with its corridor at the left (or right). */
    void stripAlongY(const Rect& r, bool corridorRight)
    {
        const auto first = m_rooms.size();
        strip(r.height(), r.width());
        for (std::size_t i = first; i < m_rooms.size(); ++i)
            for (auto& p : m_rooms[i].parts) p = {p.y0, p.x0, p.y1, p.x1};
        transform(first, r.width(), r.height(), corridorRight, false, r.x0, r.y0);
    }

    void straight(double w, double h)
    {
        const double y = middle(h, 0.42, 0.58);
        double from = 0, to = w;
        if (w > 5 * m_o.room_min_size && m_random.chance(0.4)) from = depth(0.25 * w);
        if (w > 5 * m_o.room_min_size && m_random.chance(0.4)) to = w - depth(0.25 * w);
        if (from > 0) stripAlongY({0, 0, from, h}, true);
        if (to < w) stripAlongY({to, 0, w, h}, false);
        stripAlongX({from, 0, to, y}, true);
        stripAlongX({from, y + m_corridor, to, h}, false);
        addCorridor({{from, y, to, y + m_corridor}});
    }

    /** A block between two wings whose corridors run below (y < 0) and at the left (x < 0). */
    void quadrant(double w, double h)
    {
        double low = depth(h);
        if (h - low < m_o.room_min_size) low = h;
        stripAlongX({0, 0, w, low}, false);
        if (low == h) return;
        double left = depth(w);
        if (w - left < m_o.room_min_size) left = w;
        stripAlongY({0, low, left, h}, false);
        if (left == w) return;
        const Rect rest{left, low, w, h};
        const double narrow = std::min(rest.width(), rest.height());
        const bool yard =
            narrow > kDeepest * m_o.room_max_size || (narrow >= kYard_m && m_random.chance(0.6));
        if (yard && !m_closed) return;
        if (rest.width() > rest.height())
            stripAlongX(rest, false);
        else
            stripAlongY(rest, false);
    }
    void quadrantAt(double w, double h, bool mirrorX, bool mirrorY, double x, double y)
    {
        const auto first = m_rooms.size();
        quadrant(w, h);
        transform(first, w, h, mirrorX, mirrorY, x, y);
    }

    void ell(double w, double h)
    {
        const double x = w - m_corridor - depth(w - m_corridor - m_o.room_min_size);
        const double y = h - m_corridor - depth(h - m_corridor - m_o.room_min_size);
        stripAlongX({0, y + m_corridor, w, h}, false);
        stripAlongY({x + m_corridor, 0, w, y + m_corridor}, false);
        quadrantAt(x, y, true, true, 0, 0);
        addCorridor({{0, y, x + m_corridor, y + m_corridor}, {x, 0, x + m_corridor, y}});
    }

    void tee(double w, double h)
    {
        const double x = middle(w, 0.3, 0.7);
        const double y = h - m_corridor - depth(h - m_corridor - m_o.room_min_size);
        stripAlongX({0, y + m_corridor, w, h}, false);
        quadrantAt(x, y, true, true, 0, 0);
        quadrantAt(w - x - m_corridor, y, false, true, x + m_corridor, 0);
        addCorridor({{0, y, w, y + m_corridor}, {x, 0, x + m_corridor, y}});
    }

    void cross(double w, double h)
    {
        const double x = middle(w, 0.35, 0.65), y = middle(h, 0.4, 0.6);
        const double right = x + m_corridor, top = y + m_corridor;
        quadrantAt(x, y, true, true, 0, 0);
        quadrantAt(w - right, y, false, true, right, 0);
        quadrantAt(x, h - top, true, false, 0, top);
        quadrantAt(w - right, h - top, false, false, right, top);
        addCorridor({{0, y, w, top}, {x, 0, right, y}, {x, top, right, h}});
    }

    /** Two corridors, joined by fire doors, around a core. */
    void ring(double w, double h)
    {
        const double mostX = (w - 2 * m_corridor - m_o.room_min_size) / 2;
        const double mostY = (h - 2 * m_corridor - m_o.room_min_size) / 2;
        const double x0 = depth(mostX), x1 = w - depth(mostX), y0 = depth(mostY), y1 = h - depth(mostY);
        const Rect core{x0 + m_corridor, y0 + m_corridor, x1 - m_corridor, y1 - m_corridor};
        stripAlongX({0, 0, w, y0}, true);
        stripAlongX({0, y1, w, h}, false);
        stripAlongY({0, y0, x0, y1}, true);
        stripAlongY({x1, y0, w, y1}, false);
        addCorridor({{x0, y0, x1, core.y0}, {x0, core.y0, core.x0, core.y1}});
        addCorridor({{x0, core.y1, x1, y1}, {core.x1, core.y0, x1, core.y1}});
        fillCore(core);
    }

    void fillCore(const Rect& core)
    {
        const double high = core.height();
        if (high <= kDeepest * m_o.room_max_size) {
            stripAlongX(core, m_random.chance(0.5));
            return;
        }
        double low = depth(high / 2), top = depth(high / 2);
        if (high - low - top < kYard_m) low = top = high / 2;
        if (high / 2 > kDeepest * m_o.room_max_size && m_random.chance(0.2)) return;  // an atrium
        stripAlongX({core.x0, core.y0, core.x1, core.y0 + low}, false);
        stripAlongX({core.x0, core.y1 - top, core.x1, core.y1}, true);
    }

    const TBuildingOptions& m_o;
    bool m_closed;
    SeededRandom m_random;
    double m_corridor;  //!< between centre lines
    std::vector<PlanRoom> m_rooms;
};
}  // namespace

std::vector<PlanRoom> layOutTile(const TBuildingOptions& options, const Rect& tile, bool closed,
                                 SeededRandom random)
{
    return TileLayout(options, closed, random).run(tile);
}
}  // namespace gr2to::test
