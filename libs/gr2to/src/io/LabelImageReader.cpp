#include "gr2to/io/LabelImageReader.h"

#include <png.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to
{
namespace
{
namespace fs = std::filesystem;

constexpr std::uint32_t kMaxLabel = std::numeric_limits<PlaceId>::max();

/** A PNG in memory while libpng decodes it; owns libpng's structures.
 *
 * libpng reports errors by longjmp, so the decode functions hold no objects that need destruction.
 */
class PngDecoder
{
 public:
    explicit PngDecoder(const std::string& bytes) : m_next(bytes.data()), m_end(bytes.data() + bytes.size())
    {
        m_png =
            png_create_read_struct(PNG_LIBPNG_VER_STRING, this, onError, [](png_structp, png_const_charp) {});
        m_info = m_png ? png_create_info_struct(m_png) : nullptr;
        if (m_info) png_set_read_fn(m_png, this, read);
    }
    PngDecoder(const PngDecoder&) = delete;
    PngDecoder& operator=(const PngDecoder&) = delete;
    ~PngDecoder() { png_destroy_read_struct(&m_png, &m_info, nullptr); }

    /** Reads up to the pixels; false on an error. Then width(), height() and so on are known. */
    bool decodeHeader()
    {
        if (!m_info || setjmp(png_jmpbuf(m_png))) return false;
        png_set_user_limits(m_png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_read_info(m_png, m_info);
        return true;
    }
    /** Asks for one whole byte, or more, a channel and no alpha; false on an error. */
    bool decodeFormat()
    {
        if (setjmp(png_jmpbuf(m_png))) return false;
        png_set_packing(m_png);
        png_set_strip_alpha(m_png);
        png_set_interlace_handling(m_png);
        png_read_update_info(m_png, m_info);
        return true;
    }
    /** Fills the rows; false on an error, a truncated file included. */
    bool decodePixels(png_bytepp rows)
    {
        if (setjmp(png_jmpbuf(m_png))) return false;
        png_read_image(m_png, rows);
        png_read_end(m_png, nullptr);
        return true;
    }

    std::size_t width() const { return png_get_image_width(m_png, m_info); }
    std::size_t height() const { return png_get_image_height(m_png, m_info); }
    std::size_t rowBytes() const { return png_get_rowbytes(m_png, m_info); }
    const std::string& error() const { return m_error; }

 private:
    static void onError(png_structp png, png_const_charp message)
    {
        static_cast<PngDecoder*>(png_get_error_ptr(png))->m_error = message;
        png_longjmp(png, 1);
    }
    static void read(png_structp png, png_bytep target, std::size_t size)
    {
        auto* self = static_cast<PngDecoder*>(png_get_io_ptr(png));
        if (size > static_cast<std::size_t>(self->m_end - self->m_next))
            png_error(png, "the file ends too early");
        std::memcpy(target, self->m_next, size);
        self->m_next += size;
    }

    const char* m_next;
    const char* m_end;
    png_structp m_png = nullptr;
    png_infop m_info = nullptr;
    std::string m_error;
};

/** Decoded pixels, rows from the top. */
struct Pixels
{
    std::size_t width = 0;
    std::size_t height = 0;
    std::size_t rowBytes = 0;
    std::size_t bytesEach = 1;  //!< 1 or 2: grey or index, 3: RGB; most significant byte first
    std::vector<png_byte> bytes;

    std::uint32_t at(std::size_t x, std::size_t y) const
    {
        const png_byte* p = bytes.data() + y * rowBytes + x * bytesEach;
        std::uint32_t value = 0;
        for (std::size_t k = 0; k < bytesEach; ++k) value = (value << 8U) | p[k];
        return value;
    }
};

/** Refuses sizes that cannot be: before memory is taken for the pixels. */
void checkSize(const PngDecoder& png, const fs::path& path, std::size_t fileBytes)
{
    // Deflate packs at most 1032 bytes into one.
    constexpr std::size_t kMostPacked = 1032;
    const std::string size = std::to_string(png.width()) + " x " + std::to_string(png.height());
    const std::size_t longest = ClassifiedGrid::maxSide();
    if (png.width() > longest || png.height() > longest)
        throw InputError("'" + path.string() + "' has " + size + " pixels; at most " +
                         std::to_string(longest) + " a side are supported");
    if (png.rowBytes() * png.height() > fileBytes * kMostPacked)
        throw InputError("'" + path.string() + "' is too short for its " + size + " pixels; it is damaged");
}

Pixels decode(const fs::path& path)
{
    const std::string file = readFile(path);
    if (file.size() < 8 || png_sig_cmp(reinterpret_cast<png_const_bytep>(file.data()), 0, 8) != 0)
        throw InputError("'" + path.string() + "' is not a PNG image; a label image must be one");
    PngDecoder png(file);
    const auto fail = [&] {
        throw InputError("'" + path.string() + "' is a damaged PNG image: " + png.error());
    };
    if (!png.decodeHeader()) fail();
    checkSize(png, path, file.size());
    if (!png.decodeFormat()) fail();
    Pixels pixels{png.width(), png.height(), png.rowBytes(), png.rowBytes() / png.width(), {}};
    if (pixels.bytesEach > 3)
        throw InputError("'" + path.string() +
                         "' has 16 bits a colour; label images have 8, or 16 bits of grey");
    pixels.bytes.resize(pixels.rowBytes * pixels.height);
    std::vector<png_bytep> rows(pixels.height);
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = pixels.bytes.data() + y * pixels.rowBytes;
    if (!png.decodePixels(rows.data())) fail();
    return pixels;
}

/** The values that occur, ascending, with 0 in front. */
std::vector<std::uint32_t> valuesOf(const Pixels& pixels)
{
    std::vector<bool> occurs(std::size_t{1} << 24U, false);
    occurs[0] = true;
    for (std::size_t y = 0; y < pixels.height; ++y)
        for (std::size_t x = 0; x < pixels.width; ++x) occurs[pixels.at(x, y)] = true;
    std::vector<std::uint32_t> values;
    for (std::uint32_t value = 0; value < occurs.size(); ++value)
        if (occurs[value]) values.push_back(value);
    return values;
}
}  // namespace

LabelImage readLabelImage(const fs::path& path)
{
    const Pixels pixels = decode(path);
    LabelImage image;
    std::vector<PlaceId> idOf;
    if (pixels.bytesEach == 3) {
        image.values = valuesOf(pixels);
        if (image.values.size() - 1 > kMaxLabel)
            throw InputError("'" + path.string() + "' has " + std::to_string(image.values.size() - 1) +
                             " colours; at most 65535 labels are supported");
        idOf.assign(image.values.back() + std::size_t{1}, 0);
        for (std::size_t id = 0; id < image.values.size(); ++id)
            idOf[image.values[id]] = static_cast<PlaceId>(id);
    }
    image.labels = PlaceImage(static_cast<int>(pixels.width), static_cast<int>(pixels.height));
    for (std::size_t y = 0; y < pixels.height; ++y)
        for (std::size_t x = 0; x < pixels.width; ++x) {
            const std::uint32_t value = pixels.at(x, y);
            image.labels.ids[(pixels.height - 1 - y) * pixels.width + x] =
                idOf.empty() ? static_cast<PlaceId>(value) : idOf[value];
        }
    return image;
}
}  // namespace gr2to
