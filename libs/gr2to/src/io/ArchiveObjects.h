#pragma once

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/CSerializable.h>

#include <optional>
#include <string>
#include <string_view>

#include "gr2to/base/errors.h"

namespace gr2to::io
{
/** The data end inside an object. */
class EarlyEnd : public InputError
{
 public:
    using InputError::InputError;
};

/** The objects of an unpacked MRPT archive, one after the other.
 *
 * MRPT reports whatever goes wrong inside an object as an early end of the file; here the reason is found: a
 * class that nobody registered is named, and damage is told from an early end.
 */
class ArchiveObjects
{
 public:
    /** \param bytes  outlive this object
     * \param name   of the file, quoted, for messages
     */
    ArchiveObjects(std::string_view bytes, std::string name);

    const std::string& name() const { return m_name; }
    std::size_t position() const { return m_position; }
    bool atEnd() const { return m_position >= m_bytes.size(); }
    std::string_view rest() const { return m_bytes.substr(m_position); }

    /** The next object; null when a null pointer was stored.
     * \throws EarlyEnd    the data end inside it
     * \throws InputError  its class, or one inside a frame of observations or actions, is not registered; or
     * it cannot be read
     */
    mrpt::serialization::CSerializable::Ptr next();
    /** The next little-endian number. \throws EarlyEnd */
    std::uint32_t nextNumber();
    void skip(std::size_t bytes) { m_position += bytes; }

 private:
    std::string_view m_bytes;
    std::string m_name;
    std::size_t m_position = 0;
};

/** The message for an object of a class that is not registered: names the class and the library that may hold
 * it. */
std::string foreignClassMessage(const std::string& fileName, const std::string& className);

/** The first class that is not registered, among the object at the start of the bytes and what it lists. */
std::optional<std::string> foreignClassAt(std::string_view bytes);
}  // namespace gr2to::io
