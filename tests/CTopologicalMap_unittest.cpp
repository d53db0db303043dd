#include "gr2to/mrpt/CTopologicalMap.h"

#include <gmock/gmock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <unistd.h>

#include <filesystem>
#include <random>
#include <stdexcept>

#include "../libs/gr2to/src/mrpt/gz.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/io/XmlMap.h"
#include "gr2to/mrpt/archive.h"
#include "gr2to/mrpt/registerAllClasses.h"
#include "support/messageOf.h"
#include "support/randomTopologicalMap.h"
#include "support/someTopologicalMap.h"

namespace gr2to::test
{
namespace
{
using testing::HasSubstr;
using testing::Not;

/** What an archive holds below its compression. */
std::string unpacked(const TopologicalMap& map)
{
    mrpt::io::CMemoryStream stream;
    mrpt::serialization::archiveFrom(stream) << CTopologicalMap(map);
    return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}

bool readOrRefuse(const std::string& bytes)
{
    try {
        fromArchive(bytes, "a.gr2to");
        return true;
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
        EXPECT_THAT(error.what(), testing::StartsWith("a.gr2to: "));
        return false;
    }
}

std::string readingMessage(const std::string& bytes)
{
    return messageOf<InputError>([&] { fromArchive(bytes, "a.gr2to"); });
}

/** A file that goes when the test does. */
class TemporaryFile
{
 public:
    explicit TemporaryFile(const std::string& bytes) { writeFile(path, bytes); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile()
    {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("gr2to-archive-" + std::to_string(::getpid()));
};
}  // namespace

TEST(CTopologicalMap, roundTripLosesNothing)
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        const TopologicalMap map = randomTopologicalMap(seed);
        const std::string bytes = toArchive(map);
        EXPECT_TRUE(fromArchive(bytes, "a.gr2to") == map) << "seed " << seed;
        EXPECT_EQ(toArchive(fromArchive(bytes, "a.gr2to")), bytes) << "seed " << seed;
    }
}

TEST(CTopologicalMap, theArchiveNamesNoTimeAndNoFile)
{
    const std::string bytes = toArchive(someMap());
    ASSERT_GT(bytes.size(), 10u);
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x1f\x8b\x08\x00\x00\x00\x00\x00", 8));
}

TEST(CTopologicalMap, theArchiveHoldsWhatMrptWouldWrite)
{
    const TopologicalMap map = randomTopologicalMap(15);
    EXPECT_TRUE(decompressGz(toArchive(map), "a.gr2to", 1000000) == unpacked(map));
}

TEST(CTopologicalMap, mrptReadsTheArchiveIntoAnObject)
{
    registerAllClasses();
    const TopologicalMap map = randomTopologicalMap(15);
    const TemporaryFile file(toArchive(map));
    mrpt::io::CFileGZInputStream stream(file.path.string());
    CTopologicalMap object;
    mrpt::serialization::archiveFrom(stream) >> object;
    EXPECT_TRUE(object.map() == map);
}

TEST(CTopologicalMap, mrptMakesTheObjectFromItsRegistry)
{
    registerAllClasses();
    registerAllClasses();
    const TopologicalMap map = randomTopologicalMap(15);
    const TemporaryFile file(toArchive(map));
    mrpt::io::CFileGZInputStream stream(file.path.string());
    const auto object = mrpt::serialization::archiveFrom(stream).ReadObject<CTopologicalMap>();
    ASSERT_TRUE(object);
    EXPECT_STREQ(object->GetRuntimeClass()->className, "gr2to::CTopologicalMap");
    EXPECT_TRUE(object->map() == map);
}

TEST(CTopologicalMap, refusesOtherContents)
{
    const std::string content = unpacked(someMap());
    const std::string name = "gr2to::CTopologicalMap";
    const auto header = [](const std::string& className, char version) {
        return std::string(1, static_cast<char>(0x80U | className.size())) + className + version;
    };
    ASSERT_EQ(content.substr(0, name.size() + 2), header(name, 0));
    EXPECT_EQ(readingMessage("<topological_map/>"),
              "a.gr2to: is not gz-compressed; an MRPT archive of a map is");
    EXPECT_EQ(readingMessage(""), "a.gr2to: is not gz-compressed; an MRPT archive of a map is");
    EXPECT_EQ(readingMessage(compressGz("hello")), "a.gr2to: is gz data, but not an MRPT archive");
    EXPECT_EQ(readingMessage(compressGz(header("mrpt::poses::CPose3D", 3) + "...")),
              "a.gr2to: holds an object of class 'mrpt::poses::CPose3D', not gr2to::CTopologicalMap");
    EXPECT_EQ(readingMessage(compressGz(header(name, 2) + content.substr(name.size() + 2))),
              "a.gr2to: the map is stored in version 2, this library reads up to version 1; read it with a "
              "newer gr2to");
    EXPECT_EQ(readingMessage(compressGz(content + content)),
              "a.gr2to: the archive is truncated or corrupt: the map does not end where the data do");
    EXPECT_EQ(readingMessage(toArchive(someMap()) + "tail"),
              "a.gr2to: has 4 bytes after the end of its gz data");
}

TEST(CTopologicalMap, mrptRefusesNewerVersionsToo)
{
    registerAllClasses();
    std::string content = unpacked(someMap());
    content[std::string("gr2to::CTopologicalMap").size() + 1] = 2;
    mrpt::io::CMemoryStream stream(content.data(), content.size());
    CTopologicalMap object;
    auto archive = mrpt::serialization::archiveFrom(stream);
    EXPECT_THROW(archive >> object, std::exception);
}

TEST(CTopologicalMap, refusesEveryPrefixOfAnArchive)
{
    const std::string bytes = toArchive(randomTopologicalMap(15));
    ASSERT_GT(bytes.size(), 500u);
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(readOrRefuse(bytes.substr(0, size))) << "prefix of " << size << " bytes";
}

TEST(CTopologicalMap, refusesEveryFlippedByteOfAnArchive)
{
    const TopologicalMap map = randomTopologicalMap(16);
    const std::string bytes = toArchive(map);
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ 0x55);
        // The gz header's time, extra flags and operating system say nothing about the content.
        const bool irrelevant = at >= 4 && at < 10;
        EXPECT_EQ(readOrRefuse(changed), irrelevant) << "byte " << at;
    }
}

TEST(CTopologicalMap, survivesPrefixesOfItsContent)
{
    const std::string content = unpacked(randomTopologicalMap(15));
    ASSERT_GT(content.size(), 500u);
    for (std::size_t size = 0; size < content.size(); ++size)
        EXPECT_FALSE(readOrRefuse(compressGz(content.substr(0, size)))) << "prefix of " << size << " bytes";
}

TEST(CTopologicalMap, survivesMutationsOfItsContent)
{
    const std::string content = unpacked(randomTopologicalMap(15));
    int read = 0;
    int refused = 0;
    for (unsigned seed = 0; seed < 2000; ++seed) {
        std::mt19937 random(seed);
        std::string changed = content;
        for (int i = 0; i < 4; ++i)
            changed[std::uniform_int_distribution<std::size_t>(0, changed.size() - 1)(random)] =
                static_cast<char>(std::uniform_int_distribution<int>(-128, 127)(random));
        SCOPED_TRACE("seed " + std::to_string(seed));
        ++(readOrRefuse(compressGz(changed)) ? read : refused);
    }
    EXPECT_GT(read, 0);
    EXPECT_GT(refused, 0);
}

TEST(CTopologicalMap, aMapWithoutMeaningIsNotArchived)
{
    TopologicalMap map = someMap();
    map.place(3).kind = static_cast<PlaceKind>(2);
    EXPECT_THAT(messageOf<std::invalid_argument>([&] { toArchive(map); }),
                HasSubstr("is 2, which has no meaning"));
}

TEST(Gz, unpacksWhatItPackedWhateverTheSize)
{
    std::mt19937 random(1);
    for (const std::size_t size : std::vector<std::size_t>{0, 1, 65535, 65536, 65537, 1000000}) {
        std::string noise(size, 'a');
        for (char& c : noise) c = static_cast<char>(std::uniform_int_distribution<int>(-128, 127)(random));
        for (const std::string& content : {noise, std::string(size, 'a')})
            EXPECT_TRUE(decompressGz(compressGz(content), "a.gz", size) == content) << size << " bytes";
    }
}

TEST(Gz, refusesAContentOverTheLimit)
{
    const std::string bytes = compressGz(std::string(8000000, '\0'));
    ASSERT_LT(bytes.size(), 100000u);
    EXPECT_EQ(messageOf<InputError>([&] { decompressGz(bytes, "a.gz", 1000000); }),
              "a.gz: unpacks to more than 1000000 bytes, more than a map may have");
}

TEST(LoadTopologicalMap, tellsXmlAndArchiveApartByContent)
{
    const TopologicalMap map = randomTopologicalMap(15);
    EXPECT_TRUE(loadTopologicalMap(TemporaryFile(toArchive(map)).path) == map);
    EXPECT_TRUE(loadTopologicalMap(TemporaryFile(toXml(map)).path) == map);
    EXPECT_TRUE(loadTopologicalMap(TemporaryFile("\xEF\xBB\xBF" + toXml(map)).path) == map);
    for (const char* const other : {"P5 1 1 255", "\x89PNG", "image: a.pgm", "  ", "\xEF\xBB\xBF"}) {
        const TemporaryFile file(other);
        EXPECT_THAT(messageOf<InputError>([&] { loadTopologicalMap(file.path); }),
                    testing::AllOf(HasSubstr(file.path.string()), HasSubstr("neither XML nor")));
    }
    EXPECT_THROW(loadTopologicalMap("/nowhere/topomap.xml"), InputError);
    EXPECT_THROW(loadTopologicalMap("/"), InputError);
}
}  // namespace gr2to::test
