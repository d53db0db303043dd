#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/pipeline.h"

using namespace gr2to;

/** The paper's fourth stage as it is printed, against the reading that the library implements. */
namespace
{
/** "The algorithm search in all stored circles if r_i + r < distance is satisfied. If not, this circle is
 * stored, if [it] is, the algorithm select the circle with bigger radius." */
std::vector<Circle> storedAsPrinted(const std::vector<Circle>& all)
{
    std::vector<Circle> stored;
    for (const Circle& circle : all) {
        const auto disjoint = [&](const Circle& s) {
            return s.radius_cells + circle.radius_cells < distance_cells(s.center, circle.center);
        };
        const auto at = std::find_if(stored.begin(), stored.end(), disjoint);
        if (at == stored.end())
            stored.push_back(circle);
        else if (circle.radius_cells > at->radius_cells)
            *at = circle;
    }
    return stored;
}

/** Eq. (9) as printed: drops the smaller when sqrt2 r_i + sqrt2 r_j < distance and
 * min(r_i, r_j) > dist((x_j - x_i) / 2, (y_j - y_i) / 2). */
std::vector<Circle> dropAsPrinted(std::vector<Circle> circles, const DistanceMap& distances)
{
    for (std::size_t i = 0; i < circles.size(); ++i)
        for (std::size_t j = i + 1; j < circles.size(); ++j) {
            const Circle &a = circles[i], &b = circles[j];
            const Cell middle{std::abs(b.center.x - a.center.x) / 2, std::abs(b.center.y - a.center.y) / 2};
            const bool drop =
                std::sqrt(2.0) * (a.radius_cells + b.radius_cells) < distance_cells(a.center, b.center) &&
                std::min(a.radius_cells, b.radius_cells) > distances.clearance_cells(middle);
            if (!drop) continue;
            const std::size_t smaller = a.radius_cells < b.radius_cells ? i : j;
            circles.erase(circles.begin() + static_cast<std::ptrdiff_t>(smaller));
            return dropAsPrinted(std::move(circles), distances);
        }
    return circles;
}

std::vector<Circle> circlesAlong(const test::Diagram& diagram, const ClassifiedGrid& grid)
{
    std::vector<Circle> all;
    for (const std::uint32_t i : diagram.voronoi.cells)
        all.push_back({grid.cell(i), diagram.distances.clearance_cells(i)});
    return all;
}

std::size_t overlappingPairs(const std::vector<Circle>& circles)
{
    std::size_t pairs = 0;
    for (std::size_t a = 0; a < circles.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            pairs += distance_cells(circles[a].center, circles[b].center) <
                             circles[a].radius_cells + circles[b].radius_cells
                         ? 1
                         : 0;
    return pairs;
}

std::size_t circlesIn(const std::vector<Circle>& circles, int left, int right)
{
    return static_cast<std::size_t>(std::count_if(circles.begin(), circles.end(), [&](const Circle& c) {
        return c.center.x >= left && c.center.x <= right;
    }));
}
}  // namespace

TEST(Misprints, printedRulesGiveNonsenseOnTwoRoomsAndTheReadingTwoPlacesAndOneDoor)
{
    const ClassifiedGrid grid = test::twoSquareRooms(17);
    const test::Topology reading = test::topologyOfPlaces(grid);
    EXPECT_EQ(reading.graph.circles.size(), 2u);
    EXPECT_EQ(reading.graph.doors.size(), 1u);
    EXPECT_EQ(circlesIn(reading.graph.circles, 1, 59), 1u);
    EXPECT_EQ(circlesIn(reading.graph.circles, 62, 120), 1u);

    const auto printed =
        dropAsPrinted(storedAsPrinted(circlesAlong(reading.diagram, grid)), reading.diagram.distances);
    EXPECT_NE(printed.size(), 2u);
    EXPECT_TRUE(overlappingPairs(printed) > 0 || circlesIn(printed, 1, 59) == 0 ||
                circlesIn(printed, 62, 120) == 0)
        << "stores overlapping circles, or leaves a room without any";
}
