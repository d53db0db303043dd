#include "gr2to/io/RosMapWriter.h"

#include "io/errorText.h"
#include "io/greyCodes.h"

namespace gr2to
{
namespace
{
/** The text as a double-quoted YAML scalar, which any character fits. */
std::string yamlQuoted(const std::string& text)
{
    constexpr const char* digits = "0123456789abcdef";
    std::string out = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7f)
            (out += "\\x").append({digits[code >> 4U], digits[code & 15U]});
        else
            (c == '"' || c == '\\' ? out += '\\' : out) += c;
    }
    return out + "\"";
}
}  // namespace

std::string encodePgm(const ClassifiedGrid& grid)
{
    std::string out = "P5\n" + std::to_string(grid.width()) + " " + std::to_string(grid.height()) + "\n255\n";
    out.reserve(out.size() + grid.size());
    for (int y = grid.height() - 1; y >= 0; --y) {
        const CellState* row = grid.row(y);
        for (int x = 0; x < grid.width(); ++x) out += static_cast<char>(io::greyCodeOf(row[x]));
    }
    return out;
}

std::string encodeRosYaml(const GridFrame& frame, const std::string& imageName)
{
    return "image: " + yamlQuoted(imageName) +
           "\nmode: trinary\nresolution: " + io::numberText(frame.resolution_m) + "\norigin: [" +
           io::numberText(frame.origin_x_m) + ", " + io::numberText(frame.origin_y_m) + ", " +
           io::numberText(frame.yaw_rad) + "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}
}  // namespace gr2to
