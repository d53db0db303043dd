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

/** Whether the object is a count and then that many objects. */
bool isList(const ArchiveHeader& header)
{
    constexpr int FRAMES_FROM = 2;  // older frames have other fields in front of the count
    return (header.className == "CSensoryFrame" && header.version >= FRAMES_FROM) ||
           header.className == "CActionCollection" || header.className == "CRawlog";
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
    if (!isList(*header)) return {};
    bytes.remove_prefix(header->size);
    std::uint32_t count = 0;
    if (bytes.size() < sizeof count) return {};
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
