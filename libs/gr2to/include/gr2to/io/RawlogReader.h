#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <filesystem>
#include <memory>
#include <string>

namespace gr2to
{
/** The entries of an MRPT rawlog, compressed by gzip or not, one after the other.
 *
 * A file that ends within an entry, or is damaged from some entry on, is read up to there; warning() says so.
 * The unpacked file is held in memory.
 */
class RawlogReader
{
 public:
    /** \throws InputError  the file cannot be read or holds no rawlog */
    explicit RawlogReader(const std::filesystem::path& path);
    RawlogReader(const RawlogReader&) = delete;
    RawlogReader& operator=(const RawlogReader&) = delete;
    ~RawlogReader();

    /** The next entry: an observation, a frame of observations, a collection of actions, or something else.
     * \return null at the end
     * \throws InputError  an entry's class is not registered; it cannot be skipped, since only the class
     * knows its length
     */
    mrpt::serialization::CSerializable::Ptr next();
    /** How many entries next() has given. */
    std::size_t entries() const { return m_entries; }
    /** How much of the file has been read, within [0, 1]. */
    double progress() const;
    /** Why and where the file was left before its end, in one line; empty when it was not. */
    const std::string& warning() const { return m_warning; }

 private:
    struct State;
    std::unique_ptr<State> m_state;
    std::size_t m_entries = 0;
    std::string m_warning;
};
}  // namespace gr2to
