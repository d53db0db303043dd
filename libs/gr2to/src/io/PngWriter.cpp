#include "gr2to/io/PngWriter.h"

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <new>
#include <vector>

#include "gr2to/base/errors.h"
#include "io/greyCodes.h"

namespace gr2to
{
namespace
{
constexpr int kCompressionLevel = 4;  // of zlib: half the time of the default for some per cent more bytes

/** libpng's state. Its error callback jumps over frames, so that nothing with a destructor may live in a call
 * made through guarded(). */
class Encoder
{
 public:
    Encoder()
    {
        m_png = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, onError, onWarning);
        m_info = m_png == nullptr ? nullptr : png_create_info_struct(m_png);
        if (m_info == nullptr) {
            png_destroy_write_struct(&m_png, nullptr);
            throw std::bad_alloc();
        }
        png_set_write_fn(m_png, this, onWrite, nullptr);
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    ~Encoder() { png_destroy_write_struct(&m_png, &m_info); }

    template <class Calls>
    void guarded(const Calls& calls)
    {
        if (setjmp(png_jmpbuf(m_png)) == 0)
            calls(m_png, m_info);
        else
            throw OutputError(std::string("cannot encode a PNG image: ") + m_message);
    }
    std::string take() { return std::move(m_bytes); }

 private:
    static void onWrite(png_structp png, png_bytep bytes, std::size_t count)
    {
        bool stored = false;
        try {
            static_cast<Encoder*>(png_get_io_ptr(png))
                ->m_bytes.append(reinterpret_cast<const char*>(bytes), count);
            stored = true;
        } catch (const std::bad_alloc&) {
            stored = false;
        }
        if (!stored) png_error(png, "out of memory");
    }
    static void onError(png_structp png, png_const_charp message)
    {
        auto& self = *static_cast<Encoder*>(png_get_error_ptr(png));
        std::strncpy(self.m_message, message, sizeof self.m_message - 1);
        png_longjmp(png, 1);
    }
    static void onWarning(png_structp, png_const_charp) {}

    png_structp m_png = nullptr;
    png_infop m_info = nullptr;
    std::string m_bytes;
    char m_message[200] = {};
};

/** Encodes greys; `fillRow(y, bytes)` gives the row `y`, counted from the bottom, in big-endian samples. */
template <class FillRow>
std::string encodeGrey(int width, int height, int bits, const FillRow& fillRow)
{
    if (width <= 0 || height <= 0) throw OutputError("cannot encode a PNG image without pixels");
    std::vector<unsigned char> row(static_cast<std::size_t>(width) * static_cast<std::size_t>(bits / 8));
    Encoder encoder;
    encoder.guarded([&](png_structp png, png_infop info) {
        png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_set_compression_level(png, kCompressionLevel);
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);  // rows of a map repeat the one above
        png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
                     PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png, info);
        for (int y = height - 1; y >= 0; --y) {
            fillRow(y, row.data());
            png_write_row(png, row.data());
        }
        png_write_end(png, info);
    });
    return encoder.take();
}
}  // namespace

std::string encodePng16(const PlaceImage& image)
{
    return encodeGrey(image.width, image.height, 16, [&image](int y, unsigned char* out) {
        const PlaceId* ids = image.ids.data() + image.index({0, y});
        for (int x = 0; x < image.width; ++x) {
            *out++ = static_cast<unsigned char>(ids[x] >> 8U);
            *out++ = static_cast<unsigned char>(ids[x] & 0xffU);
        }
    });
}

std::string encodePng8(const ClassifiedGrid& grid)
{
    return encodeGrey(grid.width(), grid.height(), 8, [&grid](int y, unsigned char* out) {
        const CellState* row = grid.row(y);
        for (int x = 0; x < grid.width(); ++x) out[x] = io::greyCodeOf(row[x]);
    });
}
}  // namespace gr2to
