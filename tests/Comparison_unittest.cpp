#include "gr2to/compare/Comparison.h"

#include <gmock/gmock.h>

#include <cmath>

#include "gr2to/base/errors.h"
#include "support/drawLabels.h"

namespace
{
using namespace gr2to;

using test::drawLabels;

constexpr int kBlock = test::kLabelBlock;

ReferenceAnnotation roomsOf(const std::vector<std::string>& rows)
{
    return {drawLabels(rows), {}, 0.0, true};
}

/** The cells of all blocks but '#' are free. */
ClassifiedGrid drawGrid(const std::vector<std::string>& rows)
{
    const int height = static_cast<int>(rows.size()), width = static_cast<int>(rows.front().size());
    ClassifiedGrid grid(width * kBlock, height * kBlock, GridFrame{}, CellState::Free);
    for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x)
            if (rows.at(static_cast<std::size_t>(height - 1 - y / kBlock))
                    .at(static_cast<std::size_t>(x / kBlock)) == '#')
                grid.set({x, y}, CellState::Occupied);
    return grid;
}

ComparisonScores score(const std::vector<std::string>& places, const std::vector<std::string>& rooms)
{
    return compareMaps(drawLabels(places), {}, roomsOf(rooms));
}
}  // namespace

TEST(Comparison, aPerfectMapScoresOneWhateverItsNumbersAre)
{
    const auto scores = score({"7733", "7799"}, {"1122", "1144"});
    EXPECT_DOUBLE_EQ(scores.bormann.recall, 1);
    EXPECT_DOUBLE_EQ(scores.bormann.precision, 1);
    EXPECT_DOUBLE_EQ(scores.bormann.recallByCells, 1);
    EXPECT_DOUBLE_EQ(scores.bormann.precisionByCells, 1);
    EXPECT_DOUBLE_EQ(scores.maoris.precision, 1);
    EXPECT_DOUBLE_EQ(scores.maoris.recall, 1);
    EXPECT_DOUBLE_EQ(scores.maoris.mcc, 1);
    EXPECT_DOUBLE_EQ(scores.matched.meanIou, 1);
    EXPECT_DOUBLE_EQ(scores.matched.mcc, 1);
    EXPECT_DOUBLE_EQ(scores.matched.iouOverHalf, 1);
    EXPECT_EQ(scores.matched.rooms, 3);
    EXPECT_EQ(scores.matched.segments, 3);
    EXPECT_EQ(scores.matched.countError, 0);
    EXPECT_EQ(scores.matched.splitRooms, 0);
    EXPECT_EQ(scores.matched.mergingSegments, 0);
}

TEST(Comparison, onePlaceOverTwoRoomsLosesPrecision)
{
    const auto scores = score({"55"}, {"12"});
    EXPECT_DOUBLE_EQ(scores.bormann.recall, 1);
    EXPECT_DOUBLE_EQ(scores.bormann.precision, 0.5);
    EXPECT_DOUBLE_EQ(scores.matched.meanIou, 0.25);  // one room at 0.5, the other unpaired
    EXPECT_DOUBLE_EQ(scores.matched.iouOverHalf, 0.5);
    EXPECT_DOUBLE_EQ(scores.matched.mcc, 0);  // no true negatives are left
    EXPECT_EQ(scores.matched.mergingSegments, 1);
    EXPECT_EQ(scores.matched.splitRooms, 0);
    EXPECT_EQ(scores.matched.countError, -1);
    // tp = fp = 400, fn = 0, tn = 800 - (400 - 400); the other room scores 0.
    EXPECT_DOUBLE_EQ(scores.maoris.mcc, 400. * 800. / std::sqrt(800. * 400. * 1200. * 800.) / 2);
    EXPECT_DOUBLE_EQ(scores.maoris.precision, 0.25);
    EXPECT_DOUBLE_EQ(scores.maoris.recall, 0.5);
}

TEST(Comparison, aRoomCutInHalvesLosesRecall)
{
    const auto scores = score({"34"}, {"11"});
    EXPECT_DOUBLE_EQ(scores.bormann.recall, 0.5);
    EXPECT_DOUBLE_EQ(scores.bormann.precision, 1);
    EXPECT_DOUBLE_EQ(scores.matched.meanIou, 0.5);
    EXPECT_EQ(scores.matched.splitRooms, 1);
    EXPECT_EQ(scores.matched.mergingSegments, 0);
    EXPECT_EQ(scores.matched.countError, 1);
    // Both halves stand for the room: tp = 400, fp = 0, fn = 400, tn = 800 - (0 - 800).
    EXPECT_DOUBLE_EQ(scores.maoris.mcc, 400. * 1600. / std::sqrt(400. * 800. * 1600. * 2000.));
    EXPECT_DOUBLE_EQ(scores.maoris.precision, 1);
    EXPECT_DOUBLE_EQ(scores.maoris.recall, 0.5);
}

TEST(Comparison, averagesByRoomAndByAreaDiffer)
{
    // Room 1 (three blocks) is held to two thirds, room 2 (one block) wholly; place 3 is pure, 4 half and
    // half.
    const auto scores = score({"3344"}, {"1112"});
    EXPECT_DOUBLE_EQ(scores.bormann.recall, (2. / 3 + 1) / 2);
    EXPECT_DOUBLE_EQ(scores.bormann.recallByCells, 3. / 4);
    EXPECT_DOUBLE_EQ(scores.bormann.precision, (1 + 0.5) / 2);
    EXPECT_DOUBLE_EQ(scores.bormann.precisionByCells, 3. / 4);
}

TEST(Comparison, unlabelledCellsCountAgainstBothSidesButNotInMaoris)
{
    const auto scores = score({"3.3"}, {"11."});
    EXPECT_DOUBLE_EQ(scores.bormann.recall, 0.5);
    EXPECT_DOUBLE_EQ(scores.bormann.precision, 0.5);
    EXPECT_DOUBLE_EQ(scores.matched.meanIou, 1. / 3);
    EXPECT_DOUBLE_EQ(scores.maoris.recall, 1);
    EXPECT_DOUBLE_EQ(scores.maoris.precision, 1);
}

TEST(Comparison, matthewsCorrelationOfAPairCountsItsTrueNegatives)
{
    // Place 5 and room 1: tp = 800, fp = 0, fn = 400, tn = 800; place 6 and room 2: tp = 400, fp = 400, fn =
    // 400, tn = 800.
    const auto grid = drawGrid({"....."});
    const auto scores = compareMaps(drawLabels({"5566."}), {}, roomsOf({"11122"}), &grid);
    const double first = 800. * 800. / std::sqrt(800. * 1200. * 800. * 1200.);
    const double second = (400. * 800. - 400. * 400.) / std::sqrt(800. * 800. * 1200. * 1200.);
    EXPECT_NEAR(scores.matched.mcc, (first + second) / 2, 1e-12);
}

TEST(Comparison, placesOfAHundredCellsAreSpecks)
{
    PlaceImage rooms(60, 20), places(60, 20);
    std::fill(rooms.ids.begin(), rooms.ids.end(), PlaceId{1});
    places.ids = rooms.ids;
    std::fill_n(places.ids.begin(), 100, PlaceId{2});
    const auto hundred = compareMaps(places, {}, {rooms, {}, 0.0, true});
    EXPECT_EQ(hundred.matched.segments, 1);
    EXPECT_DOUBLE_EQ(hundred.bormann.precisionByCells, 1);
    EXPECT_DOUBLE_EQ(hundred.bormann.recall, 1100. / 1200);
    std::fill_n(places.ids.begin(), 101, PlaceId{2});
    std::fill_n(places.ids.begin() + 101, 1200 - 101, PlaceId{0});
    const auto more = compareMaps(places, {}, {rooms, {}, 0.0, true});
    EXPECT_EQ(more.matched.segments, 1);
    EXPECT_DOUBLE_EQ(more.bormann.recall, 101. / 1200);
    std::fill_n(places.ids.begin(), 1, PlaceId{0});
    const auto speck = compareMaps(places, {}, {rooms, {}, 0.0, true});
    EXPECT_EQ(speck.matched.segments, 0);
    EXPECT_DOUBLE_EQ(speck.bormann.recall, 0);
    EXPECT_DOUBLE_EQ(speck.matched.meanIou, 100. / 1200);
}

TEST(Comparison, pairingMaximisesTheSumOfOverlaps)
{
    // Place 5 overlaps room 1 most, but then room 2 goes empty: 5 with 2 and 6 with 1 is the better sum.
    const auto scores = score({"5555666"}, {"1112111"});
    // iou(5, 1) = 3/7, iou(5, 2) = 1/4, iou(6, 1) = 3/6.
    EXPECT_DOUBLE_EQ(scores.matched.meanIou, (0.25 + 0.5) / 2);
}

TEST(Comparison, maorisAssociationFallsBackToTheLeastTakenRoom)
{
    // 5 takes room 1 and 6 takes room 2 by their larger overlaps; 7 touches both and takes the one it
    // overlaps less, 2.
    const auto scores = score({"5555666772"}, {"1111222112"});
    // Label 2 of the map takes nothing new either: room 2 is its only one.
    const double recall = (4. / 6 + 3. / 4 + 2. / 6 + 1. / 4) / 4;
    EXPECT_DOUBLE_EQ(scores.maoris.recall, recall);
    const auto mixed = score({"55556667777"}, {"11112222111"});
    // 7: three cells in room 1, one in room 2, both taken: room 2.
    EXPECT_DOUBLE_EQ(mixed.maoris.precision, (1 + 1 + 1. / 4) / 3);
}

TEST(Comparison, emptyMapsAndEmptyReferencesScoreNothing)
{
    for (const auto& scores : {score({".."}, {"12"}), score({"12"}, {".."}), score({".."}, {".."})}) {
        EXPECT_EQ(scores.bormann.recall, 0);
        EXPECT_EQ(scores.bormann.precision, 0);
        EXPECT_EQ(scores.bormann.recallByCells, 0);
        EXPECT_EQ(scores.maoris.mcc, 0);
        EXPECT_EQ(scores.matched.meanIou, 0);
        EXPECT_EQ(scores.matched.mcc, 0);
        EXPECT_FALSE(scores.doors);
        EXPECT_FALSE(scores.edges);
    }
    EXPECT_EQ(compareMaps({}, {}, {}).matched.rooms, 0);
}

TEST(Comparison, onlyFreeCellsCountWhereTheGridIsKnown)
{
    // Half of room 1 is furniture, which the place leaves out.
    const auto grid = drawGrid({".#..#"});
    const auto scores = compareMaps(drawLabels({"3.44."}), {}, roomsOf({"1122."}), &grid);
    EXPECT_DOUBLE_EQ(scores.bormann.recall, 0.75);
    EXPECT_DOUBLE_EQ(scores.bormann.recallCeiling.value(), 0.75);
    EXPECT_DOUBLE_EQ(scores.matched.meanIou, 1);
    EXPECT_DOUBLE_EQ(scores.matched.labelledFree.value(), 1);
    const auto blind = compareMaps(drawLabels({"3.44."}), {}, roomsOf({"1122."}));
    EXPECT_DOUBLE_EQ(blind.matched.meanIou, 0.75);
    EXPECT_FALSE(blind.bormann.recallCeiling);
    EXPECT_FALSE(blind.matched.labelledFree);
}

TEST(Comparison, roomsUnderFurnitureAltogetherAreNotAskedFor)
{
    const auto grid = drawGrid({".#"});
    const auto scores = compareMaps(drawLabels({"3."}), {}, roomsOf({"12"}), &grid);
    EXPECT_EQ(scores.matched.rooms, 1);
    EXPECT_DOUBLE_EQ(scores.matched.meanIou, 1);
    EXPECT_DOUBLE_EQ(scores.bormann.recallCeiling.value(), 0.5);
}

TEST(Comparison, sizesThatDifferAreNamed)
{
    const auto messageOf = [](const auto& action) -> std::string {
        try {
            action();
        } catch (const InputError& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_THAT(messageOf([] { score({"123"}, {"12"}); }),
                testing::AllOf(testing::HasSubstr("60 x 20"), testing::HasSubstr("40 x 20")));
    const auto grid = drawGrid({"....", "...."});
    EXPECT_THAT(messageOf([&] { compareMaps(drawLabels({"12"}), {}, roomsOf({"12"}), &grid); }),
                testing::AllOf(testing::HasSubstr("80 x 40"), testing::HasSubstr("40 x 20")));
    ReferenceAnnotation lost = roomsOf({"12"});
    lost.interfaces.emplace();
    EXPECT_THAT(messageOf([&] { compareMaps(drawLabels({"12"}), {}, lost); }),
                testing::HasSubstr("resolution"));
}

TEST(ComparisonText, namesEveryGroupThatIsThere)
{
    auto reference = roomsOf({"12"});
    const auto rooms = toText(compareMaps(drawLabels({"12"}), {}, reference));
    EXPECT_THAT(rooms, testing::HasSubstr("mean IoU               1.000"));
    EXPECT_THAT(rooms, testing::HasSubstr("recall ceiling             -"));
    EXPECT_THAT(rooms, testing::Not(testing::HasSubstr("Doors")));
    reference.interfaces.emplace({ReferenceInterface{InterfaceKind::Door, 1, 2, {10, 10}, 0.9}});
    reference.resolution_m = 0.05;
    reference.doorsReliable = false;
    const auto all = toText(compareMaps(drawLabels({"12"}), {{{{10, 10}, 1.1}}, {{1, 2}}}, reference));
    EXPECT_THAT(all, testing::HasSubstr("width error            0.200"));
    EXPECT_THAT(all, testing::HasSubstr("not reliable"));
    EXPECT_THAT(all, testing::HasSubstr("Pairs of neighbouring rooms"));
}

TEST(ComparisonText, jsonLeavesOutWhatIsNotAvailable)
{
    const auto json = toJson(compareMaps(drawLabels({"12"}), {}, roomsOf({"12"})));
    EXPECT_THAT(json, testing::HasSubstr("\"mean_iou\": 1.0"));
    EXPECT_THAT(
        json, testing::Not(testing::AnyOf(testing::HasSubstr("doors"), testing::HasSubstr("labelled_free"),
                                          testing::HasSubstr("recall_ceiling"), testing::HasSubstr("null"))));
}
