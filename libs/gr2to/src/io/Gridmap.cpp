#include "io/Gridmap.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <cstring>

#include "gr2to/base/errors.h"
#include "io/Gzip.h"
#include "io/ImageRule.h"
#include "io/errorText.h"

namespace gr2to::io
{
namespace
{
constexpr std::size_t kPrefixBytes = 512;        // more than any header and the fields before the cells
constexpr std::size_t kLargestTail = 1U << 16U;  // the options behind the cells take some 500 bytes
constexpr std::size_t kLongestName = 100;
constexpr std::size_t kLargestDeflateRatio = 1032;

template <class T>
bool take(std::string_view& bytes, T& value)
{
    if (bytes.size() < sizeof value) return false;
    std::memcpy(&value, bytes.data(),
                sizeof value);  // archives are little-endian, and so are MRPT's platforms
    bytes.remove_prefix(sizeof value);
    return true;
}

bool isClassName(std::string_view text)
{
    const auto isNameCharacter = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' ||
               c == ':';
    };
    for (const char c : text)
        if (!isNameCharacter(c)) return false;
    return text.size() > 2 && (text.front() < '0' || text.front() > '9');
}

bool startsWith(const std::string& text, std::string_view start)
{
    return text.rfind(start, 0) == 0;
}

/** The fields in front of the cells, which say how long the archive must be. */
struct GridHeader
{
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::size_t bytesBeforeTail = 0;
};

GridHeader readHeader(std::string_view bytes, const std::string& name)
{
    const auto archive = archiveHeader(bytes);
    if (!archive)
        throw InputError(name + " is compressed but holds no MRPT archive; a .gridmap.gz is expected");
    if (archive->className != "COccupancyGridMap2D") {
        const std::string kind = kindOfClass(archive->className);
        throw InputError(
            name + " holds " + (kind.empty() ? "an MRPT " + inQuotes(archive->className) : kind) +
            ", which is not supported by this version; give a 2D grid (.yaml, .png, .pgm or .gridmap)");
    }
    std::string_view rest = bytes.substr(archive->size);
    GridHeader grid;
    std::uint8_t bits = 8;
    float xMin = 0, xMax = 0, yMin = 0, yMax = 0, resolution = 0;
    const bool complete = (archive->version < 2 || take(rest, bits)) && take(rest, grid.width) &&
                          take(rest, grid.height) && take(rest, xMin) && take(rest, xMax) &&
                          take(rest, yMin) && take(rest, yMax) && take(rest, resolution);
    if (!complete) throw InputError(name + " is truncated: it ends within its header; get the whole file");
    requireSize(grid.width, grid.height, name);
    // Written so that NaN and infinity fail as well.
    const auto spans = [&](float low, float high, std::uint32_t cells) {
        return std::abs((double{high} - double{low}) / double{resolution} - static_cast<double>(cells)) < 0.5;
    };
    if (!(resolution > 0) || !spans(xMin, xMax, grid.width) || !spans(yMin, yMax, grid.height) ||
        (bits != 8 && bits != 16))
        throw InputError(name +
                         " is damaged: its size in cells, limits and resolution contradict one another");
    grid.bytesBeforeTail = bytes.size() - rest.size() + std::size_t{grid.width} * grid.height * (bits / 8U);
    return grid;
}

/** The archive's bytes, checked against what its header claims before the memory for them is taken. */
std::string unpack(std::string_view bytes, const std::string& name)
{
    GzipReader gzip(bytes, name);
    std::string plain;
    gzip.readUpTo(plain, kPrefixBytes);
    const std::size_t expected = readHeader(plain, name).bytesBeforeTail;
    if (expected / kLargestDeflateRatio > bytes.size())
        throw InputError(name + " is truncated: it is too short for the grid that its header claims");
    plain.reserve(expected + kPrefixBytes);
    gzip.readUpTo(plain, expected + kLargestTail);
    if (!gzip.finished()) throw InputError(name + " is damaged: more data follow than a grid has");
    return plain;
}

void requireTail(std::string_view bytes, const std::string& name)
{
    const std::size_t before = readHeader(bytes, name).bytesBeforeTail;
    if (bytes.size() <= before)
        throw InputError(name + " is truncated: " + std::to_string(bytes.size()) + " bytes of more than " +
                         std::to_string(before) + " are there; get the whole file");
    // MRPT allocates this list by the length that the file states, without a check of its own.
    constexpr std::size_t weightCountOffset = 78;
    std::string_view tail = bytes.substr(before);
    std::uint32_t weights = 0;
    if (tail.size() < weightCountOffset) return;
    tail.remove_prefix(weightCountOffset);
    if (take(tail, weights) && weights > tail.size() / sizeof(float))
        throw InputError(name + " is truncated or damaged behind its cells; get the whole file");
}

mrpt::maps::COccupancyGridMap2D readObject(std::string_view bytes, const std::string& name)
{
    mrpt::maps::COccupancyGridMap2D map;
    try {
        mrpt::io::CMemoryStream stream;
        stream.assignMemoryNotOwn(bytes.data(), bytes.size());
        auto archive = mrpt::serialization::archiveFrom(stream);
        archive >> map;
    } catch (const std::exception& e) {
        throw InputError(name + " cannot be read as an MRPT grid: " + firstSentence(e.what()));
    }
    return map;
}
}  // namespace

std::optional<ArchiveHeader> archiveHeader(std::string_view bytes)
{
    const std::size_t total = bytes.size();
    ArchiveHeader header;
    std::uint8_t first = 0;
    std::uint32_t length = 0;
    const bool marked = !bytes.empty() && (static_cast<unsigned char>(bytes[0]) & 0x80U) != 0;
    if (marked) {
        take(bytes, first);
        length = first & 0x7fU;
    } else if (!take(bytes, length))  // the form of MRPT before 0.5.5, with wide numbers
        return {};
    if (length > kLongestName || bytes.size() < length) return {};
    header.className = bytes.substr(0, length);
    bytes.remove_prefix(length);
    std::int8_t narrow = 0;
    std::int32_t wide = 0;
    if (!isClassName(header.className) || !(marked ? take(bytes, narrow) : take(bytes, wide))) return {};
    header.version = marked ? narrow : wide;
    header.hasEndFlag = marked;
    header.size = total - bytes.size();
    header.fullName = header.className;
    if (const auto colon = header.className.rfind(':'); colon != std::string::npos)
        header.className.erase(0, colon + 1);
    return header;
}

std::string kindOfClass(const std::string& name)
{
    if (name == "CSimpleMap" || name == "CSensFrameProbSequence") return "a simplemap";
    if (startsWith(name, "CAction") || startsWith(name, "CObservation") || startsWith(name, "CSensor") ||
        name == "CRawlog")
        return "a rawlog";
    if (startsWith(name, "COctoMap") || startsWith(name, "CColouredOctoMap") ||
        name == "COccupancyGridMap3D" || name.find("Points") != std::string::npos)
        return "a 3D map";
    return "";
}

ClassifiedGrid readGridmap(std::string_view bytes, const std::string& name,
                           const OccupancyThresholds& thresholds)
{
    std::string unpacked;
    if (isGzip(bytes)) {
        unpacked = unpack(bytes, name);
        bytes = unpacked;
    }
    const GridHeader header = readHeader(bytes, name);
    requireTail(bytes, name);
    const auto map = readObject(bytes, name);
    if (map.getSizeX() != header.width || map.getSizeY() != header.height)
        throw InputError(name + " is damaged: its size in cells does not match its limits");
    unpacked = std::string();  // three copies of the cells would be alive below
    return fromOccupancyGrid(map, thresholds);
}
}  // namespace gr2to::io
