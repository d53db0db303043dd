#include "support/drawLabels.h"

namespace gr2to::test
{
PlaceImage drawLabels(const std::vector<std::string>& rows, int block)
{
    const int height = static_cast<int>(rows.size());
    const int width = static_cast<int>(rows.front().size());
    PlaceImage image(width * block, height * block);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto& row = rows[static_cast<std::size_t>(height - 1 - y / block)];
            const char c = row.at(static_cast<std::size_t>(x / block));
            if (c >= '0' && c <= '9') image.ids[image.index({x, y})] = static_cast<PlaceId>(c - '0');
        }
    return image;
}
}  // namespace gr2to::test
