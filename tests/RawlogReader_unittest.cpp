#include "gr2to/io/RawlogReader.h"

#include <gmock/gmock.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CRawlog.h>

#include "../libs/gr2to/src/mrpt/gz.h"
#include "gr2to/base/errors.h"
#include "support/inputFiles.h"
#include "support/rawlogs.h"

namespace gr2to::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

std::size_t entriesOf(RawlogReader& reader)
{
    while (reader.next()) EXPECT_LE(reader.progress(), 1.0);
    return reader.entries();
}
}  // namespace

TEST(RawlogReader, givesEntriesInOrderCompressedOrNot)
{
    const TempFolder folder;
    const std::string bytes = walkThroughRooms(3);
    for (const std::string& file : {bytes, compressGz(bytes)}) {
        RawlogReader reader(folder.write("a.rawlog", file));
        for (int i = 0; i < 3; ++i) {
            EXPECT_STREQ(reader.next()->GetRuntimeClass()->className, "mrpt::obs::CActionCollection");
            EXPECT_STREQ(reader.next()->GetRuntimeClass()->className, "mrpt::obs::CSensoryFrame");
        }
        EXPECT_EQ(reader.next(), nullptr);
        EXPECT_EQ(reader.entries(), 6u);
        EXPECT_EQ(reader.progress(), 1.0);
        EXPECT_EQ(reader.warning(), "");
    }
}

TEST(RawlogReader, aRawlogStoredAsOneObjectIsTheSame)
{
    const TempFolder folder;
    mrpt::obs::CRawlog rawlog;
    for (int i = 0; i < 4; ++i) rawlog.insert(mrpt::obs::CObservationOdometry::Create());
    RawlogReader reader(folder.write("a.rawlog", archiveOf({&rawlog})));
    EXPECT_EQ(entriesOf(reader), 4u);
    EXPECT_EQ(reader.warning(), "");
}

TEST(RawlogReader, everyPrefixIsReadUpToItsLastWholeEntry)
{
    const TempFolder folder;
    const std::string bytes = walkThroughRooms(3);
    std::size_t before = 0;
    for (std::size_t size = 100; size < bytes.size(); size += 211) {
        RawlogReader reader(folder.write("a.rawlog", bytes.substr(0, size)));
        const std::size_t entries = entriesOf(reader);
        EXPECT_GE(entries, before);
        EXPECT_LT(entries, 6u);
        EXPECT_THAT(reader.warning(), AllOf(HasSubstr("ends within entry " + std::to_string(entries + 1)),
                                            HasSubstr("the " + std::to_string(entries) + " entries before")))
            << "prefix of " << size << " bytes";
        before = entries;
    }
    EXPECT_EQ(before, 5u);
}

TEST(RawlogReader, cutCompressedDataAreReadAsFarAsTheyGo)
{
    const TempFolder folder;
    const std::string packed = compressGz(walkThroughRooms(20));
    RawlogReader reader(folder.write("a.rawlog", packed.substr(0, packed.size() / 2)));
    EXPECT_GT(entriesOf(reader), 2u);
    EXPECT_LT(reader.entries(), 40u);
    EXPECT_THAT(reader.warning(), AllOf(HasSubstr("a.rawlog"), HasSubstr("are used")));
}

TEST(RawlogReader, foreignClassIsNamed)
{
    const TempFolder folder;
    std::string bytes = walkThroughRooms(2);
    const std::string known = "mrpt::obs::CObservation2DRangeScan",
                      foreign = "acme::obs::CObservationThermometer";
    ASSERT_EQ(known.size(), foreign.size());
    bytes.replace(bytes.rfind(known), known.size(), foreign);
    RawlogReader reader(folder.write("a.rawlog", bytes));
    EXPECT_THAT(inputErrorOf([&] { entriesOf(reader); }), AllOf(HasSubstr(foreign), HasSubstr("libacme.so")));
}

TEST(RawlogReader, otherFilesAreRefusedByName)
{
    const TempFolder folder;
    const auto refused = [&](const std::string& bytes) {
        const auto file = folder.write("a.rawlog", bytes);
        return inputErrorOf([&] { const RawlogReader reader(file); });
    };
    EXPECT_THAT(refused("hello"), HasSubstr("is no rawlog"));
    const mrpt::maps::CSimpleMap map;
    EXPECT_THAT(refused(archiveOf({&map})), HasSubstr("a simplemap"));
    EXPECT_THAT(refused("\x1f\x8b nothing"), HasSubstr("damaged"));
}
}  // namespace gr2to::test
