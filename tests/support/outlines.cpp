#include "support/outlines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace gr2to::test
{
namespace
{
using Eigen::Vector2d;

constexpr double kArea = 0.02;
constexpr double kJagged = 0.5;       // length of a border's sides, of that of the cells' sides at least
constexpr std::size_t kFewSides = 6;  // cells side by side that say nothing of a border's length

bool encloses(const Polygon& polygon, const Vector2d& p)
{
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector2d &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

class OutlineCheck
{
 public:
    explicit OutlineCheck(const Extraction& e) : m_extraction(e), m_patches(largestPatches(e.places))
    {
        for (const auto& [id, place] : e.map.places()) m_outlines[id] = polygonOf(place.boundary);
        for (const PlaceId id : m_patches.ids) ++m_cells[id];
    }

    std::vector<std::string> run()
    {
        for (const auto& [id, outline] : m_outlines) checkShape(id, outline);
        for (auto a = m_outlines.begin(); a != m_outlines.end(); ++a)
            for (auto b = std::next(a); b != m_outlines.end(); ++b) checkPair(*a, *b);
        for (int y = 0; y <= m_patches.height; ++y)
            for (int x = 0; x <= m_patches.width; ++x) checkCorner(x, y);
        return m_breaches;
    }

 private:
    void report(PlaceId id, const std::string& what)
    {
        m_breaches.push_back("place " + std::to_string(id) + ": " + what);
    }

    void checkShape(PlaceId id, const Polygon& outline)
    {
        if (const std::string why = whyNotSimple(outline); !why.empty()) return report(id, why);
        const double cell = m_extraction.grid.resolution_m() * m_extraction.grid.resolution_m();
        const double area = static_cast<double>(m_cells[id]) * cell, found = areaOf(outline);
        if (std::abs(found - area) > kArea * area)
            report(id, "area " + std::to_string(found) + " m2 instead of " + std::to_string(area));
    }

    void checkPair(const std::pair<const PlaceId, Polygon>& a, const std::pair<const PlaceId, Polygon>& b)
    {
        const Polygon &p = a.second, &q = b.second;
        double common_m = 0;
        for (const auto& [from, to] : commonSides(p, q)) common_m += (to - from).norm();
        for (std::size_t i = 0; i < p.size(); ++i)
            for (std::size_t j = 0; j < q.size(); ++j) {
                const Vector2d &from = p[i], &to = p[(i + 1) % p.size()];
                const Vector2d &start = q[j], &end = q[(j + 1) % q.size()];
                if (from != start && from != end && to != start && to != end &&
                    sidesMeet(from, to, start, end))
                    return report(a.first, "meets place " + std::to_string(b.first) + " beside its vertices");
            }
        const std::size_t sides =
            m_sides.empty() ? countSides(a.first, b.first) : m_sides[{a.first, b.first}];
        const double length_m = static_cast<double>(sides) * m_extraction.grid.resolution_m();
        if (sides >= kFewSides && (common_m < kJagged * length_m || common_m > 1.02 * length_m))
            report(a.first, "has " + std::to_string(common_m) + " m in common with place " +
                                std::to_string(b.first) + ", cells " + std::to_string(length_m) + " m");
    }

    /** Counts the sides of cells between all places at the first call. */
    std::size_t countSides(PlaceId a, PlaceId b)
    {
        for (int y = 0; y < m_patches.height; ++y)
            for (int x = 0; x < m_patches.width; ++x) {
                const PlaceId here = m_patches.at({x, y});
                if (x > 0) ++m_sides[std::minmax(here, m_patches.at({x - 1, y}))];
                if (y > 0) ++m_sides[std::minmax(here, m_patches.at({x, y - 1}))];
            }
        return m_sides[{a, b}];
    }

    void checkCorner(int x, int y)
    {
        std::set<PlaceId> labels;
        bool inside = true;  // else a slit runs here
        for (const Cell c : {Cell{x, y}, Cell{x - 1, y}, Cell{x - 1, y - 1}, Cell{x, y - 1}}) {
            const bool inImage = c.x >= 0 && c.y >= 0 && c.x < m_patches.width && c.y < m_patches.height;
            const PlaceId id = inImage ? m_patches.at(c) : PlaceId{0};
            if (inImage && id != m_extraction.places.at(c)) return;  // a patch that belongs to no outline
            labels.insert(id);
        }
        if (labels.size() < 3 || isPassedTwice(x, y)) return;
        const Vector2d at = m_extraction.grid.frame().toMap(x - 0.5, y - 0.5);
        for (const PlaceId id : labels)
            if (id != 0) inside = inside && isBeside(id, x, y);
        for (const PlaceId id : labels) {
            const Polygon& outline = m_outlines[id];
            if (id != 0 && inside && std::find(outline.begin(), outline.end(), at) == outline.end())
                report(id, "no vertex at cell " + std::to_string(x) + ", " + std::to_string(y));
        }
    }

    bool isPassedTwice(int x, int y) const
    {
        if (x == 0 || y == 0 || x == m_patches.width || y == m_patches.height) return false;
        return m_patches.at({x, y}) == m_patches.at({x - 1, y - 1}) ||
               m_patches.at({x - 1, y}) == m_patches.at({x, y - 1});
    }

    /** Whether the place's cells around a corner are inside its outline. */
    bool isBeside(PlaceId id, int x, int y)
    {
        for (const Cell c : {Cell{x, y}, Cell{x - 1, y}, Cell{x - 1, y - 1}, Cell{x, y - 1}})
            if (c.x >= 0 && c.y >= 0 && c.x < m_patches.width && c.y < m_patches.height &&
                m_patches.at(c) == id && !encloses(m_outlines[id], m_extraction.grid.frame().toMap(c)))
                return false;
        return true;
    }

    const Extraction& m_extraction;
    PlaceImage m_patches;
    std::map<PlaceId, Polygon> m_outlines;
    std::map<PlaceId, std::size_t> m_cells;
    std::map<std::pair<PlaceId, PlaceId>, std::size_t> m_sides;
    std::vector<std::string> m_breaches;
};
}  // namespace

PlaceImage largestPatches(const PlaceImage& places)
{
    std::map<PlaceId, std::vector<std::size_t>> largest;
    std::vector<bool> seen(places.ids.size(), false);
    for (std::size_t start = 0; start < seen.size(); ++start) {
        if (seen[start] || places.ids[start] == 0) continue;
        std::vector<std::size_t> patch{start};
        seen[start] = true;
        for (std::size_t k = 0; k < patch.size(); ++k) {
            const auto width = static_cast<std::size_t>(places.width);
            const int x = static_cast<int>(patch[k] % width), y = static_cast<int>(patch[k] / width);
            for (const Cell c : {Cell{x + 1, y}, Cell{x, y + 1}, Cell{x - 1, y}, Cell{x, y - 1}}) {
                if (c.x < 0 || c.y < 0 || c.x >= places.width || c.y >= places.height) continue;
                const std::size_t i = places.index(c);
                if (seen[i] || places.ids[i] != places.ids[start]) continue;
                seen[i] = true;
                patch.push_back(i);
            }
        }
        if (patch.size() > largest[places.ids[start]].size()) largest[places.ids[start]] = patch;
    }
    PlaceImage image(places.width, places.height);
    for (const auto& [id, patch] : largest)
        for (const std::size_t i : patch) image.ids[i] = id;
    return image;
}

std::vector<std::string> breachesOfOutlines(const Extraction& e)
{
    return OutlineCheck(e).run();
}

std::vector<std::pair<Vector2d, Vector2d>> commonSides(const Polygon& a, const Polygon& b)
{
    std::vector<std::pair<Vector2d, Vector2d>> common;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            if (a[i] == b[(j + 1) % b.size()] && a[(i + 1) % a.size()] == b[j])
                common.emplace_back(a[i], a[(i + 1) % a.size()]);
    return common;
}
}  // namespace gr2to::test
