#include "gr2to/grid/CriticalPoints.h"

#include <gmock/gmock.h>

#include "support/drawCurves.h"
#include "support/rooms.h"

using namespace gr2to;
using testing::ElementsAre;
using testing::IsEmpty;

namespace
{
std::vector<Cell> pointsOf(const std::vector<std::string>& rows, double minRise)
{
    const test::DrawnCurves drawn = test::drawCurves(rows);
    std::vector<Cell> cells;
    for (const CriticalPoint& point : findCriticalPoints(drawn.voronoi, drawn.distances, minRise))
        cells.push_back(point.cell);
    return cells;
}
}  // namespace

namespace gr2to
{
void PrintTo(const Cell& c, std::ostream* out)
{
    *out << "(" << c.x << ", " << c.y << ")";
}
}  // namespace gr2to

TEST(CriticalPoints, valleyIsFoundWithItsClearance)
{
    const test::DrawnCurves drawn = test::drawCurves({"5432345"});
    const auto points = findCriticalPoints(drawn.voronoi, drawn.distances, 1.0);
    ASSERT_EQ(points.size(), 1u);
    EXPECT_EQ(points[0].cell, (Cell{3, 0}));
    EXPECT_EQ(points[0].clearance_cells, 2.0);
}

TEST(CriticalPoints, middleOfALevelStretchIsTaken)
{
    EXPECT_THAT(pointsOf({"54222223345"}, 1.0), ElementsAre(Cell{4, 0}));
}

TEST(CriticalPoints, rippleBelowTheRiseIsIgnored)
{
    EXPECT_THAT(pointsOf({"7667676677"}, 2.0), IsEmpty());
    EXPECT_THAT(pointsOf({"7776777"}, 1.0), ElementsAre(Cell{3, 0}));
    EXPECT_THAT(pointsOf({"7543436"}, 2.0), ElementsAre(Cell{3, 0})) << "one valley with a ripple in it";
}

TEST(CriticalPoints, riseOfExactlyTheLeastCounts)
{
    EXPECT_THAT(pointsOf({"535"}, 2.0), ElementsAre(Cell{1, 0}));
    EXPECT_THAT(pointsOf({"535"}, 2.1), IsEmpty());
}

TEST(CriticalPoints, everyValleyOfACurveIsFoundAndOfConnectedOnesTheDeepest)
{
    EXPECT_THAT(pointsOf({"525351"}, 2.0), ElementsAre(Cell{1, 0}, Cell{3, 0}));
    EXPECT_THAT(pointsOf({"7545357"}, 3.0), ElementsAre(Cell{4, 0}));
    EXPECT_THAT(pointsOf({"7535457"}, 3.0), ElementsAre(Cell{2, 0}));
}

TEST(CriticalPoints, deadEndsAndCornersAreNoMinima)
{
    EXPECT_THAT(pointsOf({"23456"}, 1.0), IsEmpty());
    EXPECT_THAT(pointsOf({"65432"}, 1.0), IsEmpty());
    EXPECT_THAT(pointsOf({"3"}, 1.0), IsEmpty());
    EXPECT_THAT(pointsOf({"6....", "54321"}, 1.0), IsEmpty());
}

TEST(CriticalPoints, riseBeyondAJunctionIsFound)
{
    const std::vector<std::string> branching = {"....5..", "....4..", "5423334", "....3..", "....2.."};
    EXPECT_THAT(pointsOf(branching, 2.0), ElementsAre(Cell{2, 2}))
        << "one branch rises by 2, one by 1, one falls";
}

TEST(CriticalPoints, valleyBesideAJunctionThatOnlyFallsIsNone)
{
    EXPECT_THAT(pointsOf({"...1..", "543321", "...1.."}, 1.0), IsEmpty());
}

TEST(CriticalPoints, junctionThatIsTheNarrowestCellIsFoundOnce)
{
    EXPECT_THAT(pointsOf({"..5..", "..4..", "54245", "..4..", "..5.."}, 2.0), ElementsAre(Cell{2, 2}));
}

TEST(CriticalPoints, riseBeyondTwoJunctionsIsFound)
{
    EXPECT_THAT(pointsOf({"...3..3..5", "...3..3..5", "5423333345", "...3..3..."}, 2.0),
                ElementsAre(Cell{2, 1}));
}

TEST(CriticalPoints, valleyOfARingIsFoundWhereverItsCellsStart)
{
    EXPECT_THAT(pointsOf({"56667", "4...7", "34567"}, 1.0), ElementsAre(Cell{0, 0}))
        << "the lower left cell, where the ring is cut open";
    EXPECT_THAT(pointsOf({"66667", "7...6", "76543"}, 2.0), ElementsAre(Cell{4, 0}));
    EXPECT_THAT(pointsOf({"4444", "4..4", "4444"}, 1.0), IsEmpty());
}

TEST(CriticalPoints, valleyOfALoopBesideItsOnlyJunctionIsFound)
{
    EXPECT_THAT(pointsOf({"..4566", "..3..6", "234..6", "..5666"}, 2.0), ElementsAre(Cell{2, 2}))
        << "the stem falls, the loop rises on both sides";
    EXPECT_THAT(pointsOf({"..4566", "..3..6", "234..6", "..2666"}, 2.0), ElementsAre(Cell{2, 0}));
}

TEST(CriticalPoints, doorBetweenTwoRoomsIsOne)
{
    const ClassifiedGrid grid = test::twoSquareRooms(17);
    const test::Diagram diagram = test::diagramOf(grid);
    const auto points = findCriticalPoints(diagram.voronoi, diagram.distances, 1.0);
    ASSERT_EQ(points.size(), 1u);
    EXPECT_NEAR(points[0].cell.x, 60.5, 1.0);
    EXPECT_EQ(points[0].cell.y, 30);
    EXPECT_EQ(points[0].clearance_cells, 9.0);
}

TEST(CriticalPoints, areInRasterOrder)
{
    EXPECT_THAT(pointsOf({"525", "...", "535"}, 1.0), ElementsAre(Cell{1, 0}, Cell{1, 2}));
}
