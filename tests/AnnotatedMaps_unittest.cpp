#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "gr2to/io/GridReader.h"
#include "gr2to/pipeline/Gr2To.h"
#include "support/annotatedMaps.h"
#include "support/buildingMeasures.h"
#include "support/cli.h"
#include "support/freeLabels.h"

using namespace gr2to;
using namespace gr2to::test;

/** Every annotated map of the evaluation data runs through both presets. */
namespace
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t kEvery = 12;  // sanitizers take ten times as long
#else
constexpr std::size_t kEvery = 1;
#endif

/** Whether a cell of a place lies within a distance of a point. */
bool placeIsNear(const Extraction& e, PlaceId place, const mrpt::math::TPoint3D& p, double distance_m)
{
    const Cell at = cellAt(e.grid, {p.x, p.y});
    const int reach = static_cast<int>(distance_m / e.grid.resolution_m());
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            const Cell c{at.x + dx, at.y + dy};
            if (dx * dx + dy * dy <= reach * reach && e.grid.contains(c) && e.places.at(c) == place)
                return true;
        }
    return false;
}

void expectSound(const Extraction& e)
{
    EXPECT_THAT(e.map.validate(), testing::IsEmpty());
    EXPECT_EQ(breachOfPartition(e.grid, e.places), "");
    std::set<PlaceId> inImage(e.places.ids.begin(), e.places.ids.end()), inMap;
    inImage.erase(0);
    for (const auto& [id, place] : e.map.places()) inMap.insert(id);
    EXPECT_EQ(inImage, inMap);
    for (const Connection& c : e.map.connections()) {
        if (!c.doorway.real) continue;
        for (const PlaceId place : {c.from, c.to})
            EXPECT_TRUE(placeIsNear(e, place, c.doorway.position.mean, 0.5 + c.doorway.size.length_m / 2))
                << "door " << c.id << " is not beside place " << place;
    }
}

void runAll(const std::string& folder)
{
    const std::vector<AnnotatedMap> maps = annotatedMaps(folder);
    if (maps.empty())
        GTEST_SKIP() << "the evaluation data " << folder << " is not here: its maps are not tested";
    for (std::size_t k = 0; k < maps.size(); k += kEvery) {
        TGridReaderOptions options;
        options.resolution = maps[k].resolution_m;
        const ClassifiedGrid grid = readGrid(maps[k].image, options);
        for (const std::string& preset : Gr2ToOptions::presets()) {
            SCOPED_TRACE(maps[k].image.filename().string() + ", preset " + preset);
            expectSound(Gr2To(Gr2ToOptions::preset(preset)).extract(grid));
        }
    }
}
}  // namespace

TEST(AnnotatedMaps, ofIpaAreSound)
{
    runAll("ipa");
}

TEST(AnnotatedMaps, ofRoseAreSound)
{
    runAll("rose");
}

TEST(AnnotatedMaps, ofHomesAreSound)
{
    runAll("homes");
}

TEST(AnnotatedMaps, ofMapsAreSound)
{
    runAll("maps");
}

#ifdef GR2TO_CLI
TEST(AnnotatedMaps, someRunThroughTheCommandLine)
{
    std::size_t runs = 0;
    for (const char* folder : {"ipa", "rose", "homes", "maps"}) {
        const std::vector<AnnotatedMap> maps = annotatedMaps(folder);
        for (std::size_t k = 0; k < std::min<std::size_t>(maps.size(), 2); ++k)
            for (const char* preset : {"default", "paper"}) {
                const TempFolder out;
                const CliRun run = runCli(out.path(), {"extract", maps[k].image.string(), "--resolution",
                                                       std::to_string(maps[k].resolution_m), "--preset",
                                                       preset, "-o", "out", "-q"});
                EXPECT_EQ(run.code, 0) << maps[k].image << ": " << run.err;
                EXPECT_EQ(runCli(out.path(), {"validate", "out/topomap.xml"}).code, 0) << maps[k].image;
                ++runs;
            }
    }
    if (runs == 0) GTEST_SKIP() << "the evaluation data is not here: no map is tested";
}
#endif
