#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include "support/BuildingGenerator.h"

namespace gr2to::test
{
namespace
{
/** The evaluation data calls an interface a slit below the first width, an opening above the second [m]. */
constexpr double kSlit_m = 0.5, kOpening_m = 1.5;

/** Shortest text of a number at a tenth of a millimetre, which is far below any cell. */
std::string text(double value)
{
    const double rounded = std::round(value * 1e4) / 1e4;
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, rounded == 0.0 ? 0.0 : rounded).ptr};
}
std::string text(const Eigen::Vector2d& p)
{
    return "[" + text(p.x()) + ", " + text(p.y()) + "]";
}
std::string text(bool value)
{
    return value ? "true" : "false";
}

template <class Range, class Item>
std::string list(const Range& range, Item item, const std::string& separator = ",\n  ")
{
    std::string result;
    for (const auto& element : range) result += (result.empty() ? "" : separator) + item(element);
    return result;
}

/** What the cells of one room say, in pixels with the top row first. */
struct PixelFigures
{
    double count = 0, sumX = 0, sumY = 0;
    int left = 0, top = 0, right = -1, bottom = -1;
    std::set<PlaceId> neighbours = {};
};

std::vector<PixelFigures> measure(const Building& building)
{
    std::vector<PixelFigures> figures(building.rooms.size() + 1);
    const auto& labels = building.labels;
    for (int y = 0; y < labels.height; ++y)
        for (int x = 0; x < labels.width; ++x) {
            const PlaceId id = labels.at({x, y});
            if (id == 0) continue;
            auto& f = figures[id];
            const int row = labels.height - 1 - y;
            if (f.count == 0) f.left = f.right = x, f.top = f.bottom = row;
            f.left = std::min(f.left, x), f.right = std::max(f.right, x);
            f.top = std::min(f.top, row), f.bottom = std::max(f.bottom, row);
            f.sumX += x, f.sumY += row, ++f.count;
        }
    for (const auto& door : building.doors)
        if (!door.closed)
            figures[door.a].neighbours.insert(door.b), figures[door.b].neighbours.insert(door.a);
    return figures;
}

class AnnotationText
{
 public:
    explicit AnnotationText(const Building& building) : m_building(building), m_figures(measure(building)) {}

    std::string run(const std::string& name) const
    {
        const auto& grid = m_building.grid;
        std::vector<BuildingDoor> open;
        std::copy_if(m_building.doors.begin(), m_building.doors.end(), std::back_inserter(open),
                     [](const BuildingDoor& d) { return !d.closed; });
        return "{\n \"map\": \"" + name + "\",\n \"size_px\": [" + std::to_string(grid.width()) + ", " +
               std::to_string(grid.height()) + "],\n \"resolution_m\": " + text(grid.resolution_m()) +
               ",\n \"origin_convention\": \"pixels: (0, 0) is the centre of the top-left one, y down; "
               "metres: (0, 0) is "
               "the bottom-left corner of the image, y up\",\n \"rooms\": [\n  " +
               list(m_building.rooms, [&](const BuildingRoom& r) { return room(r); }) +
               "\n ],\n \"interfaces\": [\n  " +
               list(open, [&](const BuildingDoor& d) { return interface(d); }) + "\n ],\n \"doors\": [\n  " +
               list(m_building.doors, [&](const BuildingDoor& d) { return door(d); }) +
               "\n ],\n \"walls\": [\n  " +
               list(m_building.walls, [&](const BuildingWall& w) { return wall(w); }) + "\n ]\n}\n";
    }

 private:
    Eigen::Vector2d pixel(const Eigen::Vector2d& p) const
    {
        const auto c = m_building.grid.frame().toGrid(p.x(), p.y());
        return {c.x(), m_building.grid.height() - 1 - c.y()};
    }

    std::string room(const BuildingRoom& r) const
    {
        const auto& f = m_figures[r.id];
        const double n = std::max(1.0, f.count);
        const Eigen::Vector2d inner = pixel(r.inner);
        return "{\"id\": " + std::to_string(r.id) + ", \"area_m2\": " + text(r.area_m2) +
               ", \"centroid_px\": " + text(Eigen::Vector2d(f.sumX / n, f.sumY / n)) +
               ", \"inner_px\": " + text(Eigen::Vector2d(std::round(inner.x()), std::round(inner.y()))) +
               ", \"bbox_px\": [" + std::to_string(f.left) + ", " + std::to_string(f.top) + ", " +
               std::to_string(f.right) + ", " + std::to_string(f.bottom) +
               "], \"n_neighbours\": " + std::to_string(f.neighbours.size()) +
               ", \"isolated\": " + text(f.neighbours.empty()) + ", \"is_corridor\": " + text(r.corridor) +
               ", \"kind\": \"" + (r.corridor ? "corridor" : "room") + "\", \"polygon_m\": [" +
               list(
                   r.polygon, [](const Eigen::Vector2d& p) { return text(p); }, ", ") +
               "]}";
    }

    std::string interface(const BuildingDoor& d) const
    {
        const Eigen::Vector2d along(-std::sin(d.angle_rad), std::cos(d.angle_rad));
        const Eigen::Vector2d half = along * (d.width_m / 2);
        const char* kind = d.width_m < kSlit_m ? "slit" : d.width_m <= kOpening_m ? "door" : "opening";
        return "{\"a\": " + std::to_string(d.a) + ", \"b\": " + std::to_string(d.b) +
               ", \"mid_px\": " + text(pixel(d.centre)) + ", \"width_m\": " + text(d.width_m) +
               ", \"clearance_m\": " + text(d.width_m) + ", \"end_px\": [" + text(pixel(d.centre - half)) +
               ", " + text(pixel(d.centre + half)) + "], \"kind\": \"" + kind + "\"}";
    }

    static std::string door(const BuildingDoor& d)
    {
        return "{\"a\": " + std::to_string(d.a) + ", \"b\": " + std::to_string(d.b) +
               ", \"x_m\": " + text(d.centre.x()) + ", \"y_m\": " + text(d.centre.y()) +
               ", \"width_m\": " + text(d.width_m) + ", \"thickness_m\": " + text(d.thickness_m) +
               ", \"angle_rad\": " + text(d.angle_rad) + ", \"state\": \"" + (d.closed ? "closed" : "open") +
               "\"}";
    }

    static std::string wall(const BuildingWall& w)
    {
        return "{\"room\": " + std::to_string(w.room) + ", \"behind\": " + std::to_string(w.behind) +
               ", \"from_m\": " + text(w.from) + ", \"to_m\": " + text(w.to) +
               ", \"thickness_m\": " + text(w.thickness_m) + "}";
    }

    const Building& m_building;
    std::vector<PixelFigures> m_figures;
};
}  // namespace

std::string annotationJson(const Building& building, const std::string& name)
{
    return AnnotationText(building).run(name);
}

std::string mapServerYaml(const ClassifiedGrid& grid, const std::string& imageFile)
{
    const auto& frame = grid.frame();
    return "image: " + imageFile + "\nresolution: " + text(frame.resolution_m) + "\norigin: [" +
           text(frame.origin_x_m) + ", " + text(frame.origin_y_m) + ", " + text(frame.yaw_rad) +
           "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}
}  // namespace gr2to::test
