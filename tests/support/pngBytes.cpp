#include "support/pngBytes.h"

#include <zlib.h>

#include <stdexcept>

namespace gr2to::test
{
namespace
{
std::string bigEndian(std::uint32_t value)
{
    return {static_cast<char>(value >> 24U), static_cast<char>(value >> 16U), static_cast<char>(value >> 8U),
            static_cast<char>(value)};
}

std::uint32_t fromBigEndian(std::string_view bytes)
{
    std::uint32_t value = 0;
    for (const char c : bytes.substr(0, 4)) value = (value << 8U) | static_cast<unsigned char>(c);
    return value;
}

std::string chunk(const std::string& type, const std::string& data)
{
    const std::string body = type + data;
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return bigEndian(static_cast<std::uint32_t>(data.size())) + body +
           bigEndian(static_cast<std::uint32_t>(crc));
}

std::string deflated(const std::string& plain)
{
    std::string out(compressBound(plain.size()), '\0');
    uLongf size = out.size();
    if (compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(plain.data()),
                 plain.size()) != Z_OK)
        throw std::runtime_error("zlib cannot compress");
    out.resize(size);
    return out;
}

/** The scan lines of the seven passes of Adam7. */
std::string adam7(const PngImage& image)
{
    constexpr unsigned x0[] = {0, 4, 0, 2, 0, 1, 0}, dx[] = {8, 8, 4, 4, 2, 2, 1};
    constexpr unsigned y0[] = {0, 0, 4, 0, 2, 0, 1}, dy[] = {8, 8, 8, 4, 4, 2, 2};
    std::string out;
    for (unsigned pass = 0; pass < 7; ++pass)
        for (unsigned y = y0[pass]; y < image.height; y += dy[pass]) {
            if (x0[pass] >= image.width) continue;
            out += '\0';
            for (unsigned x = x0[pass]; x < image.width; x += dx[pass]) out += image.rows[y][x];
        }
    return out;
}
}  // namespace

std::string encodePng(const PngImage& image)
{
    std::string header = bigEndian(image.width) + bigEndian(image.height);
    header += {static_cast<char>(image.bits), static_cast<char>(image.type), '\0', '\0',
               image.interlaced ? '\1' : '\0'};
    std::string raster;
    if (image.interlaced)
        raster = adam7(image);
    else
        for (const auto& row : image.rows) raster += '\0' + row;
    std::string out = "\x89PNG\r\n\x1a\n" + chunk("IHDR", header);
    if (!image.palette.empty()) out += chunk("PLTE", image.palette);
    if (!image.transparency.empty()) out += chunk("tRNS", image.transparency);
    return out + chunk("IDAT", deflated(raster)) + chunk("IEND", "");
}

PngImage pngOf(PngImage::ColourType type, std::uint32_t width, const std::vector<std::string>& rows)
{
    PngImage image;
    image.width = width;
    image.height = static_cast<std::uint32_t>(rows.size());
    image.type = type;
    image.rows = rows;
    return image;
}

PngImage decodeGreyPng(std::string_view bytes)
{
    PngImage image;
    std::string packed;
    for (std::size_t at = 8; at < bytes.size();) {
        const auto length = fromBigEndian(bytes.substr(at));
        const auto type = bytes.substr(at + 4, 4), data = bytes.substr(at + 8, length);
        if (type == "IHDR") {
            image.width = fromBigEndian(data);
            image.height = fromBigEndian(data.substr(4));
            image.bits = static_cast<std::uint8_t>(data[8]);
            if (data[9] != PngImage::Grey || data[12] != 0) throw std::runtime_error("not a plain grey PNG");
        }
        if (type == "IDAT") packed += data;
        at += 12 + length;
    }
    const std::size_t pixel = image.bits / 8U, rowBytes = image.width * pixel;
    std::string raster((rowBytes + 1) * image.height, '\0');
    uLongf size = raster.size();
    if (uncompress(reinterpret_cast<Bytef*>(raster.data()), &size,
                   reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
        size != raster.size())
        throw std::runtime_error("the PNG does not unpack to its size");
    std::string above(rowBytes, '\0');
    for (std::size_t y = 0; y < image.height; ++y) {
        const char filter = raster[y * (rowBytes + 1)];
        std::string row = raster.substr(y * (rowBytes + 1) + 1, rowBytes);
        if (filter < 0 || filter > 2) throw std::runtime_error("a filter that this decoder does not know");
        for (std::size_t i = 0; i < rowBytes; ++i) {
            if (filter == 1 && i >= pixel) row[i] = static_cast<char>(row[i] + row[i - pixel]);
            if (filter == 2) row[i] = static_cast<char>(row[i] + above[i]);
        }
        image.rows.push_back(above = row);
    }
    return image;
}
}  // namespace gr2to::test
