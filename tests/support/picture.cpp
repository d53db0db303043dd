#include "support/picture.h"

#include <png.h>

#include <stdexcept>

namespace gr2to::test
{
Picture decodePng(const std::string& bytes)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
        throw std::runtime_error(image.message);
    image.format = PNG_FORMAT_RGB;
    std::vector<png_byte> buffer(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, buffer.data(), 0, nullptr) == 0)
        throw std::runtime_error(image.message);
    Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
    for (std::size_t i = 0; i + 2 < buffer.size(); i += 3)
        picture.pixels.push_back({buffer[i], buffer[i + 1], buffer[i + 2]});
    return picture;
}
}  // namespace gr2to::test
