#include "io/ArchiveObjects.h"

#include <mrpt/rtti/CObject.h>

#include <cstring>
#include <new>
#include <stdexcept>

#include "io/Gridmap.h"
#include "io/errorText.h"

namespace gr2to::io
{
using mrpt::serialization::CSerializable;

namespace
{
/** Reads one object. \param used  receives the bytes that were read, whether it worked or not */
CSerializable::Ptr readObject(std::string_view bytes, std::size_t& used)
{
    mrpt::io::CMemoryStream stream;
    stream.assignMemoryNotOwn(bytes.data(), bytes.size());
    auto archive = mrpt::serialization::archiveFrom(stream);
    CSerializable::Ptr object;
    try {
        object = archive.ReadObject<CSerializable>();
    } catch (...) {
        used = static_cast<std::size_t>(stream.getPosition());
        throw;
    }
    used = static_cast<std::size_t>(stream.getPosition());
    return object;
}

/** How many bytes of the object stand before a count and then that many objects; nothing when it is no such
 * list. */
std::optional<std::size_t> bytesBeforeCount(const ArchiveHeader& header)
{
    if (header.className == "CActionCollection" || header.className == "CRawlog") return 0;
    const bool isFrame = header.className == "CSensoryFrame" || header.className == "CSensorialFrame";
    if (isFrame && header.version >= 2) return 0;
    if (isFrame && header.version == 1) return sizeof(std::uint32_t);  // a number of the frame
    return {};
}

/** The libraries that register the classes of a namespace outside MRPT. */
std::string libraryOf(const std::string& className)
{
    const auto end = className.find("::");
    const std::string space = className.substr(0, end == std::string::npos ? 0 : end);
    if (space == "mrpt" || space.empty())
        return "a newer MRPT, or a library of it that is not linked here, may hold it";
    if (space == "mp2p_icp" || space == "mp2p_icp_filters") return "libmp2p_icp_map.so may hold it";
    return "lib" + space + ".so or another library of '" + space + "' may hold it";
}
}  // namespace

std::string foreignClassMessage(const std::string& fileName, const std::string& className)
{
    return fileName + " holds an object of class " + inQuotes(className) + ", which is not registered; " +
           libraryOf(className) + ": name its file with scans.plugins (--scans-plugins LIB.so)";
}

std::optional<std::string> foreignClassAt(std::string_view bytes)
{
    const auto header = archiveHeader(bytes);
    if (!header || header->className == "nullptr") return {};
    if (mrpt::rtti::findRegisteredClass(header->fullName, true) == nullptr) return header->fullName;
    const auto before = bytesBeforeCount(*header);
    std::uint32_t count = 0;
    if (!before || bytes.size() < header->size + *before + sizeof count) return {};
    bytes.remove_prefix(header->size + *before);
    std::memcpy(&count, bytes.data(), sizeof count);
    bytes.remove_prefix(sizeof count);
    for (; count > 0; --count) {
        if (auto found = foreignClassAt(bytes)) return found;
        std::size_t used = 0;
        try {
            readObject(bytes, used);
        } catch (const std::exception&) {
            return {};
        }
        bytes.remove_prefix(used);
    }
    return {};
}

ArchiveObjects::ArchiveObjects(std::string_view bytes, std::string name)
    : m_bytes(bytes), m_name(std::move(name))
{
}

CSerializable::Ptr ArchiveObjects::next()
{
    std::size_t used = 0;
    try {
        CSerializable::Ptr object = readObject(rest(), used);
        m_position += used;
        return object;
    } catch (const std::exception& error) {
        if (const auto foreign = foreignClassAt(rest()))
            throw InputError(foreignClassMessage(m_name, *foreign));
        if (m_position + used >= m_bytes.size())
            throw EarlyEnd(m_name + " is truncated: it ends within an object; get the whole file");
        throw InputError(m_name + " is damaged: the object at byte " + std::to_string(m_position) +
                         " of its unpacked data cannot be read (" + firstSentence(error.what()) + ")");
    }
}

std::uint32_t ArchiveObjects::nextNumber()
{
    std::uint32_t number = 0;
    if (rest().size() < sizeof number)
        throw EarlyEnd(m_name + " is truncated: it ends where a number is expected; get the whole file");
    std::memcpy(&number, rest().data(), sizeof number);
    m_position += sizeof number;
    return number;
}
}  // namespace gr2to::io
