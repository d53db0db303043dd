#include "support/plainPng.h"

#include <algorithm>

namespace gr2to::test
{
namespace
{
std::string bigEndian(std::uint32_t value)
{
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>((value >> static_cast<unsigned>(shift)) & 0xFFU);
    return bytes;
}

std::uint32_t crc32Of(const std::string& bytes)
{
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char c : bytes) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~crc;
}

std::uint32_t adler32Of(const std::string& bytes)
{
    std::uint32_t a = 1, b = 0;
    for (const char c : bytes) {
        a = (a + static_cast<std::uint8_t>(c)) % 65521U;
        b = (b + a) % 65521U;
    }
    return (b << 16U) | a;
}

std::string chunk(const std::string& type, const std::string& data)
{
    return bigEndian(static_cast<std::uint32_t>(data.size())) + type + data + bigEndian(crc32Of(type + data));
}

/** A zlib stream of stored blocks. */
std::string stored(const std::string& data)
{
    constexpr std::size_t kMostInBlock = 65535;
    std::string stream = "\x78\x01";
    for (std::size_t at = 0; at < data.size() || at == 0; at += kMostInBlock) {
        const std::size_t size = std::min(kMostInBlock, data.size() - at);
        stream += at + size == data.size() ? '\1' : '\0';
        for (const std::size_t word : {size, ~size}) {
            stream += static_cast<char>(word & 0xFFU);
            stream += static_cast<char>((word >> 8U) & 0xFFU);
        }
        stream += data.substr(at, size);
    }
    return stream + bigEndian(adler32Of(data));
}
}  // namespace

std::string plainPng(const PngLayout& layout, const std::string& rows, const std::string& palette)
{
    std::string header = bigEndian(layout.width) + bigEndian(layout.height);
    header += static_cast<char>(layout.bitDepth);
    header += static_cast<char>(layout.colourType);
    header += std::string(3, '\0');
    const std::size_t rowBytes = rows.size() / layout.height;
    std::string filtered;
    for (std::size_t y = 0; y < layout.height; ++y) filtered += '\0' + rows.substr(y * rowBytes, rowBytes);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + (palette.empty() ? "" : chunk("PLTE", palette)) +
           chunk("IDAT", stored(filtered)) + chunk("IEND", "");
}
}  // namespace gr2to::test
