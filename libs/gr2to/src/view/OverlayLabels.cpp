#include "OverlayLabels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace gr2to::view
{
namespace
{
using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double kShareOfPlace = 0.3;  // text height, of the side of a square of the place's area
constexpr double kCapHeight = 0.72;    // of the built-in font's digits, of its size
constexpr double kHaloShare = 0.14;    // of the text size
constexpr double kGap_px = 2.0;        // nominal, between a label and its vertex

std::vector<const Place*> largestFirst(const TopologicalMap& map)
{
    std::vector<const Place*> places;
    for (const auto& [id, place] : map.places()) places.push_back(&place);
    std::stable_sort(places.begin(), places.end(),
                     [](const Place* a, const Place* b) { return a->area_m2 > b->area_m2; });
    return places;
}

/** Where a label of some size may lie, best first: above, below, right, left of the vertex, or on it. */
std::vector<AlignedBox2d> candidates(const Vector2d& vertex, const Vector2d& size, double clearance)
{
    const Vector2d half = size / 2;
    const auto around = [&](double dx, double dy) {
        const Vector2d middle = vertex + Vector2d(dx * (half.x() + clearance), dy * (half.y() + clearance));
        return AlignedBox2d(middle - half, middle + half);
    };
    if (clearance <= 0) return {around(0, 0)};
    return {around(0, -1), around(0, 1), around(1, 0), around(-1, 0)};
}

AlignedBox2d movedInside(const AlignedBox2d& box, const AlignedBox2d& frame)
{
    // The upper corner gives way first: a label larger than the picture keeps its beginning.
    const Vector2d over = (box.max() - frame.max()).cwiseMax(0);
    const Vector2d under = (frame.min() - (box.min() - over)).cwiseMax(0);
    return {box.min() - over + under, box.max() - over + under};
}

AlignedBox2d freeSpot(const std::vector<AlignedBox2d>& spots, const std::vector<AlignedBox2d>& taken)
{
    const auto isFree = [&](const AlignedBox2d& spot) {
        return std::none_of(taken.begin(), taken.end(),
                            [&](const auto& other) { return spot.intersects(other); });
    };
    const auto found = std::find_if(spots.begin(), spots.end(), isFree);
    return found != spots.end() ? *found : spots.front();
}
}  // namespace

void drawIds(Canvas& canvas, const OverlayInput& input, const TOverlayOptions& options, const Layout& layout)
{
    const double pixelsPerMetre = layout.pixelsPerCell() / input.grid.resolution_m();
    const double largest = options.text_size * layout.unit;
    const Vector2d corner(layout.mapLeft, 0);
    const AlignedBox2d frame(corner, corner + Vector2d(layout.mapWidth, layout.mapHeight));
    std::vector<AlignedBox2d> taken;
    for (const Place* place : largestFirst(input.map)) {
        const double side = std::sqrt(std::max(0.0, place->area_m2)) * pixelsPerMetre;
        const double size = std::clamp(kShareOfPlace * side, largest / 2, largest);
        const std::string label = std::to_string(place->id);
        canvas.setTextSize(size, true);
        const Vector2d extent(canvas.textWidth(label), kCapHeight * size);
        const Vector2d vertex = layout.toPicture(input.grid.frame().toGrid(place->center.x, place->center.y));
        const double clearance = options.connections ? (options.point_size / 2 + kGap_px) * layout.unit : 0.0;
        auto spots = candidates(vertex, extent, clearance);
        for (auto& spot : spots) spot = movedInside(spot, frame);
        const AlignedBox2d box = freeSpot(spots, taken);
        canvas.text({box.min().x(), box.max().y()}, label, palette::ink, kHaloShare * size);
        taken.push_back(box);
    }
}
}  // namespace gr2to::view
