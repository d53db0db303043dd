#include "gz.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>
#include <stdexcept>

#include "gr2to/base/errors.h"

namespace gr2to
{
namespace
{
constexpr int GZ_WINDOW_BITS =
    16 + MAX_WBITS;  // zlib: 16 more than the window's bits means a gz header and trailer
constexpr std::size_t CHUNK = 1U << 16U;

/** A zlib stream over bytes, which may be more than zlib's 32-bit counters hold. */
class Stream
{
 public:
    using Step = int (*)(z_streamp, int);
    using End = int (*)(z_streamp);

    Stream(std::string_view input, Step step, End end) : m_input(input), m_step(step), m_end(end) {}
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    ~Stream() { m_end(&m_state); }

    z_streamp state() { return &m_state; }
    std::size_t unread() const { return m_input.size() + m_state.avail_in; }

    /** Appends what the next step puts out. \return zlib's code */
    int advance(std::string& output)
    {
        if (m_state.avail_in == 0 && !m_input.empty()) {
            const std::size_t size = std::min(m_input.size(), CHUNK);
            m_state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(m_input.data()));
            m_state.avail_in = static_cast<uInt>(size);
            m_input.remove_prefix(size);
        }
        char buffer[CHUNK];
        m_state.next_out = reinterpret_cast<Bytef*>(buffer);
        m_state.avail_out = CHUNK;
        const int code = m_step(&m_state, m_input.empty() ? Z_FINISH : Z_NO_FLUSH);
        output.append(buffer, CHUNK - m_state.avail_out);
        return code;
    }
    /** Whether the last step could not have done more with what there is. */
    bool starved() const { return m_input.empty() && m_state.avail_out > 0; }

 private:
    std::string_view m_input;
    Step m_step;
    End m_end;
    z_stream m_state{};
};
}  // namespace

bool isGz(std::string_view bytes)
{
    return bytes.substr(0, 2) == "\x1f\x8b";
}

std::string compressGz(std::string_view bytes)
{
    constexpr int DEFAULT_MEMORY_LEVEL = 8;
    Stream stream(bytes, deflate, deflateEnd);
    if (deflateInit2(stream.state(), Z_BEST_COMPRESSION, Z_DEFLATED, GZ_WINDOW_BITS, DEFAULT_MEMORY_LEVEL,
                     Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::bad_alloc();
    std::string output;
    for (int code = Z_OK; code != Z_STREAM_END;) {
        code = stream.advance(output);
        if (code == Z_STREAM_ERROR) throw std::logic_error("zlib refuses its own state");
    }
    return output;
}

std::string decompressGz(std::string_view bytes, const std::string& name, std::size_t mostBytes)
{
    if (!isGz(bytes)) throw InputError(name + ": is not gz-compressed; an MRPT archive of a map is");
    Stream stream(bytes, inflate, inflateEnd);
    if (inflateInit2(stream.state(), GZ_WINDOW_BITS) != Z_OK) throw std::bad_alloc();
    std::string output;
    for (int code = Z_OK; code != Z_STREAM_END;) {
        code = stream.advance(output);
        if (code == Z_DATA_ERROR || code == Z_NEED_DICT)
            throw InputError(name + ": is corrupt gz data; copy or make the file anew");
        if (code == Z_MEM_ERROR) throw std::bad_alloc();
        if (code != Z_STREAM_END && stream.starved())
            throw InputError(name + ": is truncated gz data; copy or make the file anew");
        if (output.size() > mostBytes)
            throw InputError(name + ": unpacks to more than " + std::to_string(mostBytes) +
                             " bytes, more than a map may have");
    }
    if (stream.unread() > 0)
        throw InputError(name + ": has " + std::to_string(stream.unread()) +
                         " bytes after the end of its gz data");
    return output;
}
}  // namespace gr2to
