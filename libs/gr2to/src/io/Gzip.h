#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

struct z_stream_s;

namespace gr2to::io
{
bool isGzip(std::string_view bytes);

/** Unpacks gzip data step by step, so that what it claims can be checked before it fills the memory. */
class GzipReader
{
 public:
    /** \param name  of the file, quoted, for messages */
    GzipReader(std::string_view bytes, std::string name);
    ~GzipReader();

    /** Appends to `out` until it has `limit` bytes or the data end, where their checksum is verified.
     * \throws InputError  the data are truncated or damaged
     */
    void readUpTo(std::string& out, std::size_t limit);
    bool finished() const { return m_finished; }

 private:
    std::string m_name;
    std::string_view m_rest;
    std::unique_ptr<z_stream_s> m_stream;
    bool m_finished = false;
};
}  // namespace gr2to::io
