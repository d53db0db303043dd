#include <gmock/gmock.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CSphere.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <sstream>

#include "../libs/gr2to/src/mrpt/gz.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/mrpt/CTopologicalMap.h"
#include "gr2to/mrpt/archive.h"
#include "gr2to/mrpt/registerAllClasses.h"
#include "gr2to/mrpt/simplemap.h"
#include "support/cli.h"
#include "support/someTopologicalMap.h"

#if defined(__SANITIZE_ADDRESS__)
/** MRPT's reader of map definitions loses the definition at hand when that throws. */
extern "C" const char* __lsan_default_suppressions()
{
    return "leak:mrpt::maps::TSetOfMetricMapInitializers::loadFromConfigFile\n";
}
#endif

namespace gr2to::test
{
namespace
{
using mrpt::maps::CMultiMetricMap;
using mrpt::maps::CSimpleMap;
using testing::HasSubstr;

const char* const INI =
    "[Maps]\ntopologicalMap_count = 1\n"
    "[Maps_topologicalMap_00_creationOpts]\nresolution = 0.1\n"
    "[Maps_topologicalMap_00_insertOpts]\nmaxDistanceInsertion = 30\n";

/** The topological map of a multi-metric map that an ini text describes. */
CTopologicalMap::Ptr mapFrom(const std::string& ini)
{
    registerAllClasses();
    mrpt::maps::TSetOfMetricMapInitializers wanted;
    wanted.loadFromConfigFile(mrpt::config::CConfigFileMemory(ini), "Maps");
    CMultiMetricMap maps;
    maps.setListOfMaps(wanted);
    EXPECT_EQ(maps.maps.size(), 1u);
    return maps.mapByClass<CTopologicalMap>();
}

/** A keyframe in each of the two rooms of roomsGrid(). */
CSimpleMap keyframesOfRooms()
{
    const Extraction extraction = Gr2To().extract(roomsGrid());
    return toSimplemap(extraction.map, extraction.grid);
}

std::string bytesOf(const CTopologicalMap& map)
{
    mrpt::io::CMemoryStream stream;
    mrpt::serialization::archiveFrom(stream) << map;
    return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}

CTopologicalMap mapOf(const std::string& bytes)
{
    mrpt::io::CMemoryStream stream;
    stream.assignMemoryNotOwn(bytes.data(), bytes.size());
    CTopologicalMap map;
    mrpt::serialization::archiveFrom(stream) >> map;
    return map;
}
}  // namespace

TEST(MetricMap, isMadeFromAnIniSectionAndFilledFromScans)
{
    const auto map = mapFrom(INI);
    ASSERT_TRUE(map);
    EXPECT_TRUE(map->isEmpty());
    EXPECT_TRUE(map->map().places().empty());
    map->loadFromSimpleMap(keyframesOfRooms());
    EXPECT_FALSE(map->isEmpty());
    EXPECT_EQ(map->map().places().size(), 2u);
    EXPECT_EQ(map->map().connections().size(), 1u);
    EXPECT_NEAR(map->map().connections().at(0).doorway.size.length_m, 0.9, 0.15);
    EXPECT_NEAR(map->map().resolution_m, 0.1, 1e-6);
    EXPECT_TRUE(map->map().validate().empty());
    EXPECT_THAT(map->asString(), HasSubstr("2 places and 1 connections"));
    map->clear();
    EXPECT_TRUE(map->isEmpty());
    EXPECT_TRUE(map->map().places().empty());
}

TEST(MetricMap, iniKeysHaveTheClassesNamesToo)
{
    for (const char* key : {"gr2to::CTopologicalMap", "CTopologicalMap"}) {
        mrpt::maps::TSetOfMetricMapInitializers wanted;
        wanted.loadFromConfigFile(
            mrpt::config::CConfigFileMemory(std::string("[Maps]\n") + key + "_count = 2\n"), "Maps");
        EXPECT_EQ(wanted.size(), 2u) << key;
    }
}

TEST(MetricMap, extractsOnlyWhenAskedAndOnlyAgainAfterAChange)
{
    const auto map = mapFrom(INI);
    map->loadFromSimpleMap(keyframesOfRooms());
    const TopologicalMap* first = &map->map();
    const auto* place = &first->place(1);
    EXPECT_EQ(&map->map().place(1), place) << "the same object, not made anew";
    EXPECT_TRUE(map->map().connections().at(0).doorway.real);
    Gr2ToOptions options = map->options();
    options.set("door.max_width", "0.7");
    options.set("place.narrow_opening", "0");
    map->setOptions(options);
    EXPECT_FALSE(map->map().connections().at(0).doorway.real) << "an opening of 0.9 m is no door now";
    options.door.max_width = -1;
    EXPECT_THROW(map->setOptions(options), std::invalid_argument);
}

TEST(MetricMap, optionsOfTheIniReachTheStages)
{
    const std::string more = std::string(INI) + "[Maps_topologicalMap_00_extractOpts]\n";
    EXPECT_EQ(mapFrom(more + "door.max_width = 1.25\n")->options().door.max_width, 1.25);
    EXPECT_EQ(mapFrom(std::string(INI) + "[Maps_topologicalMap_00_creationOpts]\npreset = paper\n")
                  ->options()
                  .filter.max_blob_area,
              0);
    EXPECT_ANY_THROW(mapFrom(more + "door.max_widht = 1.25\n"));
    EXPECT_ANY_THROW(
        mapFrom("[Maps]\ntopologicalMap_count = 1\n"
                "[Maps_topologicalMap_00_creationOpts]\nresolution = 0\n"));
    std::ostringstream dump;
    mrpt::maps::TSetOfMetricMapInitializers wanted;
    wanted.loadFromConfigFile(mrpt::config::CConfigFileMemory(INI), "Maps");
    wanted.dumpToTextStream(dump);
    EXPECT_THAT(dump.str(), testing::AllOf(HasSubstr("resolution = 0.1 m"), HasSubstr("max_width")));
}

TEST(MetricMap, archiveKeepsGridMapAndOptions)
{
    const auto map =
        mapFrom(std::string(INI) + "[Maps_topologicalMap_00_extractOpts]\ndoor.max_width = 1.25\n");
    map->loadFromSimpleMap(keyframesOfRooms());
    for (const bool extracted : {false, true}) {
        if (extracted) map->map();
        const CTopologicalMap again = mapOf(bytesOf(*map));
        EXPECT_EQ(again.options().door.max_width, 1.25);
        EXPECT_FALSE(again.isEmpty());
        EXPECT_EQ(again.grid().getRawMap(), map->grid().getRawMap());
        EXPECT_EQ(again.map(), mapOf(bytesOf(*map)).map());
        EXPECT_EQ(again.map().places().size(), 2u);
        EXPECT_EQ(fromArchive(compressGz(bytesOf(*map)), "a.gr2to"), again.map());
    }
    EXPECT_EQ(mapOf(bytesOf(*map)).map(), map->map());
    std::string cut = bytesOf(*map);
    cut.resize(cut.size() - 100);
    EXPECT_THROW(fromArchive(compressGz(cut), "a.gr2to"), InputError);
}

TEST(MetricMap, aMapWithoutGridIsStoredAsBefore)
{
    const std::string bytes = bytesOf(CTopologicalMap(someMap()));
    EXPECT_EQ(bytes[std::string("gr2to::CTopologicalMap").size() + 1], 0) << "version 0";
    const CTopologicalMap again = mapOf(bytes);
    EXPECT_EQ(again.map(), someMap());
    EXPECT_FALSE(again.isEmpty());
    EXPECT_TRUE(again.grid().isEmpty());
}

TEST(MetricMap, firstObservationReplacesAMapThatWasMadeElsewhere)
{
    CTopologicalMap map(someMap());
    EXPECT_FALSE(map.insertObservation(mrpt::obs::CObservationComment()));
    EXPECT_EQ(map.map(), someMap()) << "a comment is no observation of the map";
    map.insertObservation(**std::get<1>(keyframesOfRooms().get(0))->begin());
    EXPECT_FALSE(map.map() == someMap());
}

TEST(MetricMap, aCopyIsIndependent)
{
    const auto map = mapFrom(INI);
    map->loadFromSimpleMap(keyframesOfRooms());
    const CTopologicalMap copy = *map;
    map->clear();
    EXPECT_EQ(copy.map().places().size(), 2u);
}

TEST(MetricMap, likelihoodIsBestWhereTheScanWasTaken)
{
    const auto map = mapFrom(INI);
    const CSimpleMap keyframes = keyframesOfRooms();
    const auto [pdf, frame] = keyframes.get(0);
    const auto& scan = **frame->begin();
    EXPECT_FALSE(map->canComputeObservationLikelihood(scan)) << "the map is empty yet";
    map->loadFromSimpleMap(keyframes);
    EXPECT_TRUE(map->canComputeObservationLikelihood(scan));
    EXPECT_FALSE(map->canComputeObservationLikelihood(mrpt::obs::CObservationComment()));
    const auto at = pdf->getMeanVal();
    const mrpt::poses::CPose3D beside(at.x() + 0.6, at.y() + 0.4, 0, 0.5, 0, 0);
    EXPECT_GT(map->computeObservationLikelihood(scan, at), map->computeObservationLikelihood(scan, beside));
}

TEST(MetricMap, otherOperationsAreAnsweredAsMrptExpects)
{
    const auto map = mapFrom(INI);
    map->loadFromSimpleMap(keyframesOfRooms());
    mrpt::maps::CSimplePointsMap points;
    points.loadFromSimpleMap(keyframesOfRooms());
    mrpt::tfest::TMatchingPairList pairs;
    mrpt::maps::TMatchingParams params;
    params.maxDistForCorrespondence = 0.2f;
    mrpt::maps::TMatchingExtraResults results;
    map->determineMatching2D(&points, mrpt::poses::CPose2D(), pairs, params, results);
    EXPECT_GT(results.correspondencesRatio, 0.9f) << "by the grid";
    EXPECT_EQ(map->compute3DMatchingRatio(&points, mrpt::poses::CPose3D(), {}), 0);
    EXPECT_EQ(map->getAsSimplePointsMap(), nullptr);
    EXPECT_ANY_THROW(map->determineMatching3D(&points, mrpt::poses::CPose3D(), pairs, params, results));
    EXPECT_ANY_THROW(map->squareDistanceToClosestCorrespondence(0, 0));
}

TEST(MetricMap, drawsPlacesWallsDoorsAndGraph)
{
    const auto map = mapFrom(INI);
    map->loadFromSimpleMap(keyframesOfRooms());
    const auto scene = map->getVisualization();
    EXPECT_EQ(scene->getByClass<mrpt::opengl::CSphere>(2), nullptr);
    ASSERT_NE(scene->getByClass<mrpt::opengl::CSphere>(1), nullptr) << "a node for each of the two places";
    std::size_t triangles = 0;
    for (std::size_t i = 0; const auto set = scene->getByClass<mrpt::opengl::CSetOfTriangles>(i); ++i)
        triangles += set->getTrianglesCount();
    std::size_t planes = 1;  // the door
    for (const auto& [id, place] : map->map().places())
        for (const Wall& wall : place.walls) planes += wall.real ? 1 : 0;
    EXPECT_GT(triangles, 2 * planes) << "two for each upright plane, and the floors";
    map->genericMapParams.enableSaveAs3DObject = false;
    EXPECT_EQ(map->getVisualization()->getByClass<mrpt::opengl::CSphere>(0), nullptr);
}

TEST(MetricMap, savesFilesThatGr2toReads)
{
    const TempFolder folder;
    const auto map = mapFrom(INI);
    map->loadFromSimpleMap(keyframesOfRooms());
    map->saveMetricMapRepresentationToFile((folder.path() / "rooms").string());
    EXPECT_EQ(loadTopologicalMap(folder.path() / "rooms_topomap.xml"), map->map());
    EXPECT_EQ(loadTopologicalMap(folder.path() / "rooms_topomap.gr2to"), map->map());
    mrpt::opengl::COpenGLScene scene;
    EXPECT_TRUE(scene.loadFromFile((folder.path() / "rooms_topomap.3Dscene").string()));
    EXPECT_THROW(map->saveMetricMapRepresentationToFile((folder.path() / "rooms_topomap.xml/x").string()),
                 InputError);
}

TEST(MetricMap, infoReadsAnArchiveWithItsGrid)
{
    const TempFolder folder;
    const auto map = mapFrom(INI);
    map->loadFromSimpleMap(keyframesOfRooms());
    folder.write("rooms.gr2to", compressGz(bytesOf(*map)));
    const CliRun run = runCli(folder.path(), {"info", "rooms.gr2to"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("2 rooms"));
}
}  // namespace gr2to::test
