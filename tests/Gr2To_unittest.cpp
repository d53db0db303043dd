#include "gr2to/pipeline/Gr2To.h"

#include <gmock/gmock.h>

#include <thread>

#include "gr2to/base/errors.h"
#include "gr2to/io/XmlMap.h"
#include "gr2to/mrpt/archive.h"
#include "support/buildingMeasures.h"
#include "support/messageOf.h"
#include "support/rooms.h"

using namespace gr2to;
using testing::HasSubstr;

namespace
{
std::size_t countOf(const Extraction& e, const std::string& stage, const std::string& name)
{
    for (const StageReport& report : e.reports)
        for (const auto& [key, count] : report.counts)
            if (report.stage == stage && key == name) return count;
    ADD_FAILURE() << "no report of " << stage << ", " << name;
    return 0;
}
}  // namespace

TEST(Gr2To, reportsWhatEveryStageFound)
{
    const ClassifiedGrid grid = test::twoSquareRooms(17);
    const Extraction e = Gr2To().extract(grid);
    EXPECT_EQ(countOf(e, "distance map", "cells"), grid.size());
    EXPECT_EQ(countOf(e, "door detection", "candidates"), e.doorCandidates.size());
    EXPECT_EQ(countOf(e, "Voronoi diagram", "nodes"), e.voronoi.nodes.size());
    EXPECT_EQ(countOf(e, "Voronoi diagram", "edges"), e.voronoi.edges.size());
    EXPECT_EQ(countOf(e, "place construction", "critical points"), e.criticalPoints.size());
    EXPECT_EQ(countOf(e, "place construction", "circles"), 2u);
    EXPECT_EQ(countOf(e, "place construction", "doors"), 1u);
    EXPECT_EQ(countOf(e, "space delimitation", "places"), 2u);
    EXPECT_EQ(countOf(e, "space delimitation", "connections"), 1u);
    std::size_t real = 0;
    for (const auto& [id, place] : e.map.places())
        for (const Wall& wall : place.walls) real += wall.real ? 1 : 0;
    EXPECT_EQ(countOf(e, "space delimitation", "real walls"), real);
    for (const StageReport& report : e.reports) {
        EXPECT_GE(report.seconds, 0) << report.stage;
        EXPECT_GT(report.bytes, 0u) << report.stage;
    }
}

TEST(Gr2To, sameGridAndOptionsGiveTheSameBytes)
{
    for (const char* preset : {"default", "paper"}) {
        const auto grid = test::generateBuilding(test::buildingOptions(5, 20, 0.15)).grid;
        const Gr2To pipeline(Gr2ToOptions::preset(preset));
        const Extraction a = pipeline.extract(grid), b = pipeline.extract(grid);
        EXPECT_EQ(toXml(a.map), toXml(b.map));
        EXPECT_EQ(toArchive(a.map), toArchive(b.map));
        EXPECT_EQ(a.places.ids, b.places.ids);
        const Extraction fresh = Gr2To(Gr2ToOptions::preset(preset)).extract(grid);
        EXPECT_EQ(toXml(fresh.map), toXml(a.map)) << "no state is kept";
    }
}

TEST(Gr2To, manyThreadsWithOnePipelineGiveTheSameBytes)
{
    const auto grid = test::generateBuilding(test::buildingOptions(7, 20, 0.15)).grid;
    for (const char* preset : {"default", "paper"}) {
        const Gr2To pipeline(Gr2ToOptions::preset(preset));
        const std::string alone = toXml(pipeline.extract(grid).map);
        std::vector<std::string> texts(6);
        std::vector<std::thread> threads;
        for (std::string& text : texts)
            threads.emplace_back([&] { text = toXml(pipeline.extract(grid).map); });
        for (std::thread& thread : threads) thread.join();
        for (const std::string& text : texts) EXPECT_EQ(text, alone) << preset;
    }
}

/** Sets an option to another value of its range. */
static void change(const OptionField& field)
{
    if (auto* const* truth = std::get_if<bool*>(&field.value))
        **truth = !**truth;
    else if (auto* const* number = std::get_if<double*>(&field.value))
        **number = **number == field.minimum ? 0.5 * (field.minimum + field.maximum)
                                             : 0.5 * (**number + field.minimum);
    else
        ADD_FAILURE() << field.name << ": no idle option had this type when the test was written";
}

TEST(Gr2To, idleOptionsHaveNoEffect)
{
    const auto grid = test::generateBuilding(test::buildingOptions(5, 20, 0.15)).grid;
    for (const bool alongWalls : {true, false}) {
        Gr2ToOptions options;
        options.cut.along_walls = alongWalls;
        const std::string usual = toXml(Gr2To(options).extract(grid).map);
        int idle = 0;
        for (OptionTable* table : options.tables())
            for (const OptionField& field : table->fields()) {
                const std::string key = table->section() + "." + field.name;
                if (!options.isIdle(key)) continue;
                ++idle;
                const std::string before = field.valueText();
                change(field);
                EXPECT_NE(field.valueText(), before) << key;
                EXPECT_EQ(toXml(Gr2To(options).extract(grid).map), usual) << key;
                table->set(field.name, before);
            }
        EXPECT_GT(idle, 5);
    }
}

TEST(Gr2To, gridsWithoutFreeOrOccupiedCellsAreRefused)
{
    const auto complaint = [](CellState state) {
        return test::messageOf<InputError>(
            [&] { Gr2To().extract(ClassifiedGrid(20, 10, GridFrame{}, state)); });
    };
    EXPECT_THAT(complaint(CellState::Occupied), HasSubstr("no free cell"));
    EXPECT_THAT(complaint(CellState::Unknown), HasSubstr("no free cell"));
    EXPECT_THAT(complaint(CellState::Free), HasSubstr("no occupied cell"));
    EXPECT_THAT(test::messageOf<InputError>([] { Gr2To().extract(ClassifiedGrid{}); }),
                HasSubstr("no free cell"));
}

TEST(Gr2To, gridsTooNarrowForAPlaceGiveAnEmptyMap)
{
    ClassifiedGrid crack = test::solid(40, 5);
    test::carve(crack, {1, 2}, {38, 2});
    const Extraction e = Gr2To().extract(crack);
    EXPECT_TRUE(e.map.places().empty());
    EXPECT_THAT(e.map.validate(), testing::IsEmpty());
    for (const PlaceId id : e.places.ids) EXPECT_EQ(id, 0);
}

TEST(Gr2To, smallestGridsAndOddShapesPassThrough)
{
    for (const Cell size : {Cell{2, 1}, Cell{1, 2}, Cell{2, 2}, Cell{3, 200}, Cell{200, 3}}) {
        ClassifiedGrid grid(size.x, size.y, GridFrame{}, CellState::Free);
        grid.set({size.x - 1, size.y - 1}, CellState::Occupied);
        for (const char* preset : {"default", "paper"})
            EXPECT_THAT(Gr2To(Gr2ToOptions::preset(preset)).extract(grid).map.validate(), testing::IsEmpty())
                << size.x << " x " << size.y;
    }
}

TEST(Gr2To, unknownSurroundingsBoundPlacesInThePresetDefault)
{
    ClassifiedGrid grid(61, 61, GridFrame{}, CellState::Unknown);
    test::carve(grid, {1, 1}, {59, 59});
    grid.set({0, 0}, CellState::Occupied);
    const Extraction e = Gr2To().extract(grid);
    ASSERT_EQ(e.map.places().size(), 1u);
    for (const Wall& wall : e.map.place(1).walls) EXPECT_FALSE(wall.real);
}
