#include <gmock/gmock.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/system/os.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

/** Nothing here includes a header of Gr2To: the library comes as a plugin, as it does to MRPT's programs. */
namespace
{
namespace fs = std::filesystem;
using testing::HasSubstr;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

const char* const CLASS = "gr2to::CTopologicalMap";
const char* const DEMO = "/usr/share/mrpt/datasets/localization_demo.simplemap.gz";

class Plugin : public testing::Test
{
 protected:
    Plugin()
    {
        fs::remove_all(m_folder);
        fs::create_directories(m_folder);
    }
    ~Plugin() override
    {
        std::error_code ignored;
        fs::remove_all(m_folder, ignored);
    }
    /** Runs a command of the shell in the folder. \return what it printed */
    std::string run(const std::string& command)
    {
        const std::string log = (m_folder / "log").string();
        m_status =
            std::system(("cd '" + m_folder.string() + "' && " + command + " </dev/null >log 2>&1").c_str());
        std::ifstream in(log, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    fs::path m_folder = fs::temp_directory_path() / ("gr2to-plugin-" + std::to_string(::getpid()));
    int m_status = -1;
};

bool has(const std::string& program)
{
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

void load()
{
    std::string trouble;
    ASSERT_TRUE(mrpt::system::loadPluginModules(GR2TO_LIBRARY, trouble)) << trouble;
}

mrpt::maps::CMetricMap::Ptr topologicalMapFrom(const std::string& iniFile)
{
    mrpt::maps::TSetOfMetricMapInitializers wanted;
    wanted.loadFromConfigFile(mrpt::config::CConfigFile(iniFile), "MappingApplication");
    mrpt::maps::CMultiMetricMap maps;
    maps.setListOfMaps(wanted);
    return maps.maps.empty() ? nullptr : maps.maps.at(0);
}
}  // namespace

TEST_F(Plugin, isLoadedAndItsClassMadeByName)
{
    // This program does not link the library, so that only the plugin can have registered the class.
    EXPECT_EQ(mrpt::rtti::findRegisteredClass(CLASS), nullptr);
    load();
    ASSERT_NE(mrpt::rtti::findRegisteredClass(CLASS), nullptr);
    const auto object = mrpt::rtti::classFactory(CLASS);
    ASSERT_TRUE(object);
    EXPECT_NE(dynamic_cast<mrpt::maps::CMetricMap*>(object.get()), nullptr);
    const auto map = topologicalMapFrom(GR2TO_SOURCE_DIR "/share/observations2map.ini");
    ASSERT_TRUE(map);
    EXPECT_STREQ(map->GetRuntimeClass()->className, CLASS);
}

TEST_F(Plugin, aSimplemapFillsIt)
{
    if (!fs::exists(DEMO)) GTEST_SKIP() << "mrpt-common is not installed";
    load();
    const auto map = topologicalMapFrom(GR2TO_SOURCE_DIR "/share/observations2map.ini");
    ASSERT_TRUE(map);
    mrpt::maps::CSimpleMap keyframes;
    ASSERT_TRUE(keyframes.loadFromFile(DEMO));
    map->loadFromSimpleMap(keyframes);
    EXPECT_THAT(map->asString(), testing::MatchesRegex("Topological map of [1-9][0-9]* places.*"));
}

TEST_F(Plugin, rawlogEditReadsARawlogThatHoldsAMap)
{
    if (kSanitized) GTEST_SKIP() << "MRPT's programs are built without the sanitizer that the plugin needs";
    if (!has("rawlog-edit")) GTEST_SKIP() << "rawlog-edit is not installed (package mrpt-apps)";
    load();
    {
        mrpt::io::CFileGZOutputStream file((m_folder / "maps.rawlog").string());
        auto archive = mrpt::serialization::archiveFrom(file);
        auto scan = mrpt::obs::CObservation2DRangeScan::Create();
        scan->timestamp = mrpt::Clock::fromDouble(1000);
        scan->sensorLabel = "laser";
        const auto map =
            std::dynamic_pointer_cast<mrpt::serialization::CSerializable>(mrpt::rtti::classFactory(CLASS));
        archive << *scan << *map << *scan << *scan;
    }
    const std::string with = run(std::string("rawlog-edit -p ") + GR2TO_LIBRARY + " --info -i maps.rawlog");
    EXPECT_EQ(m_status, 0) << with;
    EXPECT_THAT(with, testing::ContainsRegex("Overall number of objects *: 4"));
    EXPECT_THAT(with, testing::ContainsRegex("laser / *3 /"));
    const std::string without = run("rawlog-edit --info -i maps.rawlog");
    EXPECT_THAT(without, HasSubstr(CLASS)) << "without the plugin it complains about the class";
}

TEST_F(Plugin, observations2mapMakesATopologicalMap)
{
    if (kSanitized) GTEST_SKIP() << "MRPT's programs are built without the sanitizer that the plugin needs";
    if (!has("observations2map") || !fs::exists(DEMO))
        GTEST_SKIP() << "observations2map (package mrpt-apps) or mrpt-common is not installed";
    const std::string arguments =
        std::string("observations2map ") + GR2TO_SOURCE_DIR + "/share/observations2map.ini " + DEMO + " out";
    const std::string log = run(std::string("LD_PRELOAD=") + GR2TO_LIBRARY + " " + arguments);
    EXPECT_EQ(m_status, 0) << log;
    const fs::path xml = m_folder / "out_gr2to__CTopologicalMap_00_topomap.xml";
    ASSERT_TRUE(fs::exists(xml)) << log;
    std::ifstream in(xml);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    EXPECT_THAT(text, HasSubstr("<place id=\"2\""));
    EXPECT_TRUE(fs::exists(m_folder / "out_gr2to__CTopologicalMap_00_topomap.3Dscene"));
    fs::remove(xml);
    run(arguments);
    EXPECT_FALSE(fs::exists(xml)) << "without the library MRPT leaves the map out";
}

TEST_F(Plugin, aProgramHasToNameASymbolOrItsLinkerDropsTheLibrary)
{
    run(GR2TO_NAMES_A_SYMBOL);
    EXPECT_EQ(m_status, 0);
    run(GR2TO_NAMES_NOTHING);
    EXPECT_NE(m_status, 0) << "the trap is gone: linkers keep libraries of which no symbol is named";
}
