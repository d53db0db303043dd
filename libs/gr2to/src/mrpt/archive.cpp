#include "gr2to/mrpt/archive.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/base/text.h"
#include "gr2to/io/XmlMap.h"
#include "gr2to/mrpt/CTopologicalMap.h"
#include "gz.h"
#include "io/Gridmap.h"
#include "io/Gzip.h"
#include "serializeMap.h"

namespace gr2to
{
namespace
{
constexpr std::size_t MOST_BYTES = std::size_t{1} << 30U;

/** How MRPT frames an object: its class name's length with the highest bit set, that name, a version,
 * content, a flag.
 *
 * It is done here rather than by MRPT's operators, which report every failure inside an object as an early
 * end of file when reading, and as an exception of their own type when writing.
 */
struct ObjectHeader
{
    std::string className;
    std::uint8_t version = 0;
    std::size_t size = 0;
};
constexpr std::uint8_t MARK = 0x80;
constexpr std::uint8_t END_FLAG = 0x88;

ObjectHeader readHeader(std::string_view bytes, const std::string& name)
{
    const auto first = static_cast<std::uint8_t>(bytes.empty() ? 0 : bytes.front());
    const std::size_t length = first & 0x7FU;
    if ((first & MARK) == 0 || bytes.size() < length + 2)
        throw InputError(name + ": is gz data, but not an MRPT archive");
    return {std::string(bytes.substr(1, length)), static_cast<std::uint8_t>(bytes[length + 1]), length + 2};
}

/** The map of an object that holds its grid; MRPT reads that. */
TopologicalMap mapOfGrid(std::string_view content, const std::string& name)
{
    mrpt::io::CMemoryStream stream;
    stream.assignMemoryNotOwn(content.data(), content.size());
    CTopologicalMap object;
    try {
        mrpt::serialization::archiveFrom(stream) >> object;
    } catch (const std::exception&) {
        throw InputError(name + ": the archive is truncated or corrupt: its grid and map cannot be read");
    }
    return object.map();
}

bool isXml(std::string_view bytes)
{
    const std::string_view text = bytes.substr(bytes.rfind("\xEF\xBB\xBF", 0) == 0 ? 3 : 0);
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    return start != std::string_view::npos && text[start] == '<';
}
}  // namespace

std::string toArchive(const TopologicalMap& map)
{
    const std::string className = CLASS_ID(CTopologicalMap)->className;
    mrpt::io::CMemoryStream stream;
    auto archive = mrpt::serialization::archiveFrom(stream);
    archive << static_cast<std::uint8_t>(MARK | className.size());
    archive.WriteBuffer(className.data(), className.size());
    archive << MAP_ARCHIVE_VERSION;
    writeMap(archive, map);
    archive << END_FLAG;
    return compressGz({static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()});
}

TopologicalMap fromArchive(std::string_view bytes, const std::string& name)
{
    const std::string content = decompressGz(bytes, name, MOST_BYTES);
    const ObjectHeader header = readHeader(content, name);
    const std::string wanted = CLASS_ID(CTopologicalMap)->className;
    if (header.className != wanted)
        throw InputError(name + ": holds an object of class " + excerpt(header.className) + ", not " +
                         wanted);
    if (header.version == GRID_ARCHIVE_VERSION) return mapOfGrid(content, name);
    mrpt::io::CMemoryStream stream;
    stream.assignMemoryNotOwn(content.data() + header.size, content.size() - header.size);
    auto archive = mrpt::serialization::archiveFrom(stream);
    TopologicalMap map = readMap(archive, header.version, name);
    const std::size_t end = header.size + static_cast<std::size_t>(stream.getPosition());
    if (end + 1 != content.size() || static_cast<std::uint8_t>(content[end]) != END_FLAG)
        throw InputError(name +
                         ": the archive is truncated or corrupt: the map does not end where the data do");
    return map;
}

bool isTopologicalMap(std::string_view bytes, const std::string& name)
{
    if (!isGz(bytes)) return isXml(bytes);
    constexpr std::size_t ENOUGH_FOR_THE_CLASS = 256;
    std::string start;
    io::GzipReader(bytes, name).readUpTo(start, ENOUGH_FOR_THE_CLASS);
    const auto header = io::archiveHeader(start);
    const std::string wanted = CLASS_ID(CTopologicalMap)->className;
    return header && header->className == wanted.substr(wanted.rfind(':') + 1);
}

TopologicalMap loadTopologicalMap(const std::filesystem::path& path)
{
    const std::string bytes = readFile(path);
    if (isGz(bytes)) return fromArchive(bytes, path.string());
    if (isXml(bytes)) return fromXml(bytes, path.string());
    throw InputError("'" + path.string() +
                     "' is neither XML nor a gz-compressed MRPT archive; name a topomap.xml or .gr2to file");
}
}  // namespace gr2to
