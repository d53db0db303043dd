#include "io/Gzip.h"

#include <zlib.h>

#include <algorithm>
#include <new>

#include "gr2to/base/errors.h"

namespace gr2to::io
{
bool isGzip(std::string_view bytes)
{
    return bytes.size() >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b';
}

GzipReader::GzipReader(std::string_view bytes, std::string name)
    : m_name(std::move(name)), m_rest(bytes), m_stream(std::make_unique<z_stream>())
{
    constexpr int gzipOnly = 16;  // added to the window bits, as zlib's manual states
    if (inflateInit2(m_stream.get(), MAX_WBITS + gzipOnly) != Z_OK) throw std::bad_alloc();
}

GzipReader::~GzipReader()
{
    inflateEnd(m_stream.get());
}

void GzipReader::readUpTo(std::string& out, std::size_t limit)
{
    constexpr std::size_t largestStep = std::size_t{1} << 20U;
    while (!m_finished && out.size() < limit) {
        const std::size_t before = out.size();
        const std::size_t room = std::min(limit - before, largestStep);
        out.resize(before + room);
        m_stream->next_in = reinterpret_cast<Bytef*>(const_cast<char*>(m_rest.data()));
        m_stream->avail_in = static_cast<uInt>(std::min(m_rest.size(), largestStep));
        m_stream->next_out = reinterpret_cast<Bytef*>(out.data() + before);
        m_stream->avail_out = static_cast<uInt>(room);
        const auto offered = m_stream->avail_in;
        const int status = inflate(m_stream.get(), Z_NO_FLUSH);
        m_rest.remove_prefix(offered - m_stream->avail_in);
        out.resize(before + room - m_stream->avail_out);
        if (status == Z_STREAM_END)
            m_finished = true;
        else if (status == Z_BUF_ERROR || (status == Z_OK && m_rest.empty() && out.size() == before))
            throw InputError(m_name + " is truncated: its gzip data end early; get the whole file");
        else if (status == Z_MEM_ERROR)
            throw std::bad_alloc();
        else if (status != Z_OK)
            throw InputError(m_name + " is damaged: its gzip data do not unpack (" +
                             (m_stream->msg != nullptr ? m_stream->msg : "no reason given") + ")");
    }
}
}  // namespace gr2to::io
