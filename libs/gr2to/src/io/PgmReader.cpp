#include "io/PgmReader.h"

#include <cstring>

#include "gr2to/base/errors.h"
#include "io/errorText.h"

namespace gr2to::io
{
namespace
{
bool isSpace(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}
bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/** Walks over the whitespace, comments and decimal numbers of a PGM. */
class Scanner
{
 public:
    Scanner(std::string_view bytes, const std::string& name) : m_bytes(bytes), m_name(name) {}

    std::size_t remaining() const { return m_bytes.size() - m_at; }
    std::size_t position() const { return m_at; }
    void advance(std::size_t count) { m_at += count; }

    void skipBlanks()
    {
        while (m_at < m_bytes.size() && (isSpace(m_bytes[m_at]) || m_bytes[m_at] == '#')) {
            if (m_bytes[m_at] == '#')
                m_at = std::min(m_bytes.find_first_of("\r\n", m_at), m_bytes.size());
            else
                ++m_at;
        }
    }

    std::uint32_t number(const char* what, std::uint32_t largest)
    {
        skipBlanks();
        if (m_at == m_bytes.size()) throw InputError(m_name + " is truncated: it ends before " + what);
        const std::size_t start = m_at;
        std::uint64_t value = 0;
        for (; m_at < m_bytes.size() && isDigit(m_bytes[m_at]); ++m_at) {
            value = value * 10 + static_cast<std::uint64_t>(m_bytes[m_at] - '0');
            if (value > largest)
                throw InputError(m_name + " is malformed: " + what + " exceeds " + std::to_string(largest));
        }
        const bool ended = m_at == m_bytes.size() || isSpace(m_bytes[m_at]) || m_bytes[m_at] == '#';
        if (m_at == start || !ended)
            throw InputError(m_name + " is malformed: " + what + " is not a number but " +
                             inQuotes(m_bytes.substr(start, m_at - start + 1)));
        return static_cast<std::uint32_t>(value);
    }

 private:
    std::string_view m_bytes;
    const std::string& m_name;
    std::size_t m_at = 0;
};

struct Header
{
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t maximum = 0;
    std::uint64_t pixels() const { return std::uint64_t{width} * height; }
};

Header readHeader(Scanner& scan, const std::string& name)
{
    constexpr std::uint32_t longest = 0x7fffffff;
    scan.advance(2);  // P2 or P5, which the caller has seen
    Header header;
    header.width = scan.number("the width", longest);
    header.height = scan.number("the height", longest);
    header.maximum = scan.number("the largest grey", 65535);
    if (header.maximum == 0)
        throw InputError(name + " is malformed: the largest grey is 0; it must be 1 to 65535");
    return header;
}

void requireBytes(std::uint64_t needed, std::size_t present, const Header& header, const std::string& name)
{
    if (needed <= present) return;
    throw InputError(name + " is truncated: its header claims " + std::to_string(header.width) + " x " +
                     std::to_string(header.height) + " pixels, which take " + std::to_string(needed) +
                     " bytes, but only " + std::to_string(present) + " follow; get the whole file");
}

[[noreturn]] void complainOfGrey(std::uint32_t grey, const Header& header, const std::string& name)
{
    throw InputError(name + " is malformed: it holds the grey " + std::to_string(grey) + " but states " +
                     std::to_string(header.maximum) + " as the largest");
}

void readBinary(std::string_view raster, const Header& header, const std::vector<CellState>& table,
                const std::string& name, ClassifiedGrid& grid)
{
    const auto* byte = reinterpret_cast<const unsigned char*>(raster.data());
    const bool wide = header.maximum > 255;
    for (int y = grid.height() - 1; y >= 0; --y) {
        CellState* out = grid.row(y);
        for (int x = 0; x < grid.width(); ++x) {
            std::uint32_t grey = *byte++;
            if (wide) grey = (grey << 8U) | *byte++;
            if (grey > header.maximum) complainOfGrey(grey, header, name);
            out[x] = table[grey];
        }
    }
}

void readText(Scanner& scan, const Header& header, const std::vector<CellState>& table,
              const std::string& name, ClassifiedGrid& grid)
{
    for (int y = grid.height() - 1; y >= 0; --y) {
        CellState* out = grid.row(y);
        for (int x = 0; x < grid.width(); ++x) {
            const auto grey = scan.number("a pixel", 65535);
            if (grey > header.maximum) complainOfGrey(grey, header, name);
            out[x] = table[grey];
        }
    }
    scan.skipBlanks();
    if (scan.remaining() > 0)
        throw InputError(name + " is malformed: it holds more pixels than its header claims");
}
}  // namespace

ClassifiedGrid readPgm(std::string_view bytes, const std::string& name, const ImageRule& rule,
                       const GridFrame& frame)
{
    const bool binary = bytes[1] == '5';
    Scanner scan(bytes, name);
    const Header header = readHeader(scan, name);
    requireSize(header.width, header.height, name);
    if (binary) {
        requireBytes(1 + header.pixels() * (header.maximum > 255 ? 2 : 1), scan.remaining(), header, name);
        if (!isSpace(bytes[scan.position()]))
            throw InputError(name + " is malformed: no blank between its header and its pixels");
        scan.advance(1);  // exactly one: the next byte is a pixel even when it looks like a blank
    } else
        requireBytes(header.pixels() * 2, scan.remaining(), header, name);  // a blank and a digit each
    const auto table = stateTable(rule, 1, header.maximum, name);
    ClassifiedGrid grid(static_cast<int>(header.width), static_cast<int>(header.height), frame);
    if (binary)
        readBinary(bytes.substr(scan.position()), header, table, name, grid);
    else
        readText(scan, header, table, name, grid);
    return grid;
}
}  // namespace gr2to::io
