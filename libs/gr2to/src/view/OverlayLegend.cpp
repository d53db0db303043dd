#include "OverlayLegend.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "OverlayLayers.h"
#include "OverlayRaster.h"

namespace gr2to::view
{
namespace
{
using Eigen::Vector2d;

// All in pixels of a picture of nominal size.
constexpr double kColumn = 163, kRow = 24, kMargin = 10, kSign = 34, kText = 15, kGap = 8, kDoorSign = 26;
constexpr double kLongestBar = 100;

/** An entry: what it says, and how to draw its sign from its left end towards the right. */
struct Entry
{
    std::string text;
    std::function<void(Canvas&, const Vector2d& left, const Vector2d& right)> sign;
};

void swatch(Canvas& canvas, const Vector2d& left, const Vector2d& right, const std::vector<Rgb>& colors)
{
    const double width = (right.x() - left.x()) / static_cast<double>(colors.size());
    const double height = (right.x() - left.x()) * 0.4;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        canvas.setColor(colors[i]);
        cairo_rectangle(canvas.context(), left.x() + width * static_cast<double>(i), left.y() - height / 2,
                        width, height);
        cairo_fill(canvas.context());
    }
}

bool hasCorridors(const TopologicalMap& map)
{
    return std::any_of(map.places().begin(), map.places().end(),
                       [](const auto& entry) { return entry.second.kind == PlaceKind::Corridor; });
}

void addSwatches(std::vector<Entry>& entries, const OverlayInput& input, const TOverlayOptions& options)
{
    const auto add = [&](const char* text, const std::vector<Rgb>& colors) {
        entries.push_back(
            {text, [colors](Canvas& c, const Vector2d& a, const Vector2d& b) { swatch(c, a, b, colors); }});
    };
    if (options.places) add("places", {placeColor(1), placeColor(2), placeColor(3)});
    if (options.places && hasCorridors(input.map)) {
        const Rgb tint = placeColor(2), stripe = darker(tint, kCorridorShade);
        add("corridor", {tint, stripe, tint, stripe, tint, stripe, tint});
    }
    if (options.grid) add("occupied", {palette::occupied});
    if (options.grid) add("unknown", {palette::unknown});
    if (showsRemoved(input, options)) add("removed", {palette::removed});
}

std::vector<Entry> legendEntries(const OverlayInput& input, const TOverlayOptions& o, double unit)
{
    std::vector<Entry> entries;
    addSwatches(entries, input, o);
    const auto add = [&](bool wanted, const char* text, auto sign) {
        if (wanted) entries.push_back({text, sign});
    };
    const double wall = o.wall_width * unit, door = o.door_width * unit, dash = kDash * unit;
    const double dot = o.point_size * unit, link = o.connection_width * unit, ridge = o.voronoi_width * unit;
    using V = const Vector2d&;
    add(o.walls, "real wall", [=](Canvas& c, V a, V b) { drawWall(c, a, b, true, wall, dash); });
    add(o.walls, "virtual wall", [=](Canvas& c, V a, V b) { drawWall(c, a, b, false, wall, dash); });
    add(o.doors, "door", [=](Canvas& c, V a, V b) { drawRealDoor(c, a, b, door); });
    add(o.doors, "virtual opening", [=](Canvas& c, V a, V b) { drawVirtualOpening(c, a, b, door, dash); });
    add(o.connections, "connection", [=](Canvas& c, V a, V b) {
        c.line(a, b, palette::ink, link);
        drawVertex(c, a, dot * kVertexShare);
        drawVertex(c, b, dot * kVertexShare);
    });
    add(o.voronoi, "Voronoi diagram", [=](Canvas& c, V a, V b) { c.line(a, b, palette::voronoi, ridge); });
    add(o.critical_points, "critical point",
        [=](Canvas& c, V a, V b) { drawCriticalPoint(c, (a + b) / 2, dot); });
    return entries;
}

std::string metres(double length_m)
{
    char buffer[32];
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, length_m).ptr) + " m";
}

void drawScaleBar(Canvas& canvas, const Vector2d& left, const OverlayInput& input, const Layout& layout)
{
    const double pixelsPerMetre = layout.pixelsPerCell() / input.grid.resolution_m();
    const double length_m = scaleBarLength(kLongestBar * layout.unit / pixelsPerMetre);
    const Vector2d right = left + Vector2d(length_m * pixelsPerMetre, 0);
    const Vector2d tick(0, 5 * layout.unit);
    const double width = 2 * layout.unit;
    canvas.line(left, right, palette::ink, width);
    canvas.line(left - tick, left + tick, palette::ink, width);
    canvas.line(right - tick, right + tick, palette::ink, width);
    canvas.text(right + Vector2d(kGap, kText * 0.35) * layout.unit, metres(length_m), palette::ink);
}

int columnsOf(double pictureWidth_px, const Layout& layout)
{
    return std::max(1, static_cast<int>((pictureWidth_px / layout.unit - kMargin) / kColumn));
}
}  // namespace

double scaleBarLength(double longest_m)
{
    const double decade = std::floor(std::log10(longest_m));
    for (const double step : {5.0, 2.0})
        if (step * std::pow(10.0, decade) <= longest_m) return step * std::pow(10.0, decade);
    return std::pow(10.0, decade);
}

double placeMap(Layout& layout, const TOverlayOptions& options)
{
    if (!options.legend && !options.scale_bar) return layout.mapWidth;
    const double least = std::ceil((kColumn + 2 * kMargin) * layout.unit);
    const double width = std::max<double>(layout.mapWidth, least);
    layout.mapLeft = static_cast<int>((width - layout.mapWidth) / 2);
    return width;
}

double stripHeight(const OverlayInput& input, const TOverlayOptions& options, const Layout& layout,
                   double pictureWidth_px)
{
    std::size_t entries = options.scale_bar ? 1 : 0;
    if (options.legend) entries += legendEntries(input, options, layout.unit).size();
    if (entries == 0) return 0;
    const auto columns = static_cast<std::size_t>(columnsOf(pictureWidth_px, layout));
    const std::size_t rows = (entries - 1) / columns + 1;
    return std::ceil((kRow * static_cast<double>(rows) + kMargin) * layout.unit);
}

void drawStrip(Canvas& canvas, const OverlayInput& input, const TOverlayOptions& options,
               const Layout& layout, double pictureWidth_px)
{
    const double unit = layout.unit;
    const int columns = columnsOf(pictureWidth_px, layout);
    int slot = 0;
    const auto nextSlot = [&] {
        const int column = slot % columns, row = slot / columns;
        ++slot;
        const double x = (kMargin + kColumn * column) * unit;
        const double y = layout.mapHeight + (kMargin / 2 + kRow * (row + 0.5)) * unit;
        return Vector2d(x, y);
    };
    canvas.setTextSize(kText * unit, true);
    if (options.scale_bar) drawScaleBar(canvas, nextSlot(), input, layout);
    if (!options.legend) return;
    for (const auto& entry : legendEntries(input, options, unit)) {
        const Vector2d left = nextSlot();
        entry.sign(canvas, left, left + Vector2d(kDoorSign * unit, 0));
        canvas.text(left + Vector2d(kSign, kText * 0.35) * unit, entry.text, palette::ink);
    }
}
}  // namespace gr2to::view
