#include "io/PngReader.h"

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <new>

#include "gr2to/base/errors.h"
#include "io/errorText.h"

namespace gr2to::io
{
namespace
{
// Deflate spends at least two bits on a match of 258 bytes.
constexpr std::uint64_t kLargestDeflateRatio = 1032;

/** libpng's state. Its error callback jumps over frames, so that nothing with a destructor may live in a call
 * made through guarded(). */
class Decoder
{
 public:
    Decoder(std::string_view bytes, const std::string& name) : m_bytes(bytes), m_name(name)
    {
        m_png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, onError, onWarning);
        m_info = m_png == nullptr ? nullptr : png_create_info_struct(m_png);
        if (m_info == nullptr) {
            png_destroy_read_struct(&m_png, nullptr, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(m_png, this, onRead);
    }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    ~Decoder() { png_destroy_read_struct(&m_png, &m_info, nullptr); }

    png_structp png() { return m_png; }
    png_infop info() { return m_info; }

    template <class Calls>
    void guarded(const Calls& calls)
    {
        if (setjmp(png_jmpbuf(m_png)) == 0)
            calls();
        else
            throw InputError(m_name + (m_ended ? " is truncated" : " is malformed") + ": " + m_message +
                             "; get a whole PNG file");
    }

 private:
    static void onRead(png_structp png, png_bytep target, std::size_t count)
    {
        auto& self = *static_cast<Decoder*>(png_get_io_ptr(png));
        if (count > self.m_bytes.size()) {
            self.m_ended = true;
            png_error(png, "the file ends early");
        }
        std::memcpy(target, self.m_bytes.data(), count);
        self.m_bytes.remove_prefix(count);
    }
    static void onError(png_structp png, png_const_charp message)
    {
        auto& self = *static_cast<Decoder*>(png_get_error_ptr(png));
        std::strncpy(self.m_message, message, sizeof self.m_message - 1);
        png_longjmp(png, 1);
    }
    static void onWarning(png_structp, png_const_charp) {}

    std::string_view m_bytes;
    const std::string& m_name;
    png_structp m_png = nullptr;
    png_infop m_info = nullptr;
    bool m_ended = false;
    char m_message[200] = {};
};

struct Layout
{
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::size_t rowBytes = 0;
    unsigned colours = 1;  //!< channels that are averaged
    bool alpha = false;
    bool wide = false;  //!< two bytes a channel
    bool interlaced = false;
    unsigned maximum() const { return wide ? 65535 : 255; }
};

void requirePlausible(Decoder& decoder, std::size_t fileBytes, const std::string& name)
{
    png_structp png = decoder.png();
    const std::uint64_t width = png_get_image_width(png, decoder.info());
    const std::uint64_t height = png_get_image_height(png, decoder.info());
    requireSize(width, height, name);
    const std::uint64_t bitsPerPixel =
        std::uint64_t{png_get_channels(png, decoder.info())} * png_get_bit_depth(png, decoder.info());
    const std::uint64_t rasterBytes = (width * bitsPerPixel + 7) / 8 * height;
    if (rasterBytes > kLargestDeflateRatio * fileBytes)
        throw InputError(name + " is truncated or malformed: its header claims " + std::to_string(width) +
                         " x " + std::to_string(height) + " pixels, more than a PNG file of " +
                         std::to_string(fileBytes) + " bytes can hold");
}

Layout prepareRows(Decoder& decoder)
{
    Layout layout;
    decoder.guarded([&] {
        png_structp png = decoder.png();
        png_infop info = decoder.info();
        png_set_expand(png);  // palettes to RGB, small greys to 8 bits, tRNS chunks to alpha
        if (png_set_interlace_handling(png) > 1) layout.interlaced = true;
        png_read_update_info(png, info);
        const unsigned channels = png_get_channels(png, info);
        layout.width = png_get_image_width(png, info);
        layout.height = png_get_image_height(png, info);
        layout.rowBytes = png_get_rowbytes(png, info);
        layout.alpha = (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0;
        layout.colours = channels - (layout.alpha ? 1U : 0U);
        layout.wide = png_get_bit_depth(png, info) == 16;
    });
    return layout;
}

template <unsigned Bytes>
void classifyRow(const unsigned char* pixel, const Layout& layout, const std::vector<CellState>& table,
                 CellState* out)
{
    const auto next = [&pixel] {
        unsigned value = *pixel++;
        if (Bytes == 2) value = (value << 8U) | *pixel++;
        return value;
    };
    for (std::uint32_t x = 0; x < layout.width; ++x) {
        unsigned sum = 0;
        for (unsigned c = 0; c < layout.colours; ++c) sum += next();
        const bool opaque = !layout.alpha || next() == layout.maximum();
        out[x] = opaque ? table[sum] : CellState::Unknown;
    }
}

void classifyRow(const unsigned char* pixels, const Layout& layout, const std::vector<CellState>& table,
                 CellState* out)
{
    if (layout.wide)
        classifyRow<2>(pixels, layout, table, out);
    else
        classifyRow<1>(pixels, layout, table, out);
}
}  // namespace

ClassifiedGrid readPng(std::string_view bytes, const std::string& name, const ImageRule& rule,
                       const GridFrame& frame)
{
    Decoder decoder(bytes, name);
    decoder.guarded([&] { png_read_info(decoder.png(), decoder.info()); });
    requirePlausible(decoder, bytes.size(), name);
    const Layout layout = prepareRows(decoder);
    const auto table = stateTable(rule, layout.colours, layout.maximum(), name);
    ClassifiedGrid grid(static_cast<int>(layout.width), static_cast<int>(layout.height), frame);
    const auto rowOf = [&](std::uint32_t fromTop) {
        return grid.row(static_cast<int>(layout.height - 1 - fromTop));
    };

    // The passes of an interlaced image fill the same rows in turn, so that it must be held as a whole.
    std::vector<unsigned char> raster(layout.rowBytes * (layout.interlaced ? layout.height : 1U));
    if (layout.interlaced) {
        std::vector<png_bytep> rows(layout.height);
        for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = raster.data() + y * layout.rowBytes;
        decoder.guarded([&] { png_read_image(decoder.png(), rows.data()); });
        for (std::uint32_t y = 0; y < layout.height; ++y) classifyRow(rows[y], layout, table, rowOf(y));
    } else
        decoder.guarded([&] {
            for (std::uint32_t y = 0; y < layout.height; ++y) {
                png_read_row(decoder.png(), raster.data(), nullptr);
                classifyRow(raster.data(), layout, table, rowOf(y));
            }
        });
    decoder.guarded([&] { png_read_end(decoder.png(), nullptr); });
    return grid;
}
}  // namespace gr2to::io
