#include "io/formats.h"

#include <algorithm>
#include <array>

#include "gr2to/base/errors.h"
#include "io/Gridmap.h"
#include "io/Gzip.h"
#include "io/errorText.h"

namespace gr2to::io
{
namespace
{
struct Named
{
    std::string_view mark;
    std::string_view kind;
};

bool startsWith(std::string_view text, std::string_view start)
{
    return text.substr(0, start.size()) == start;
}

constexpr std::array<Named, 6> kOtherBinaryImages{{{"\xff\xd8\xff", "a JPEG image"},
                                                   {"BM", "a BMP image"},
                                                   {"GIF8", "a GIF image"},
                                                   {"II*", "a TIFF image"},
                                                   {"MM", "a TIFF image"},
                                                   {"RIFF", "a WebP image"}}};

constexpr std::array<Named, 5> kOtherNetpbm{{{"P1", "a PBM image"},
                                             {"P3", "a PPM image"},
                                             {"P4", "a PBM image"},
                                             {"P6", "a PPM image"},
                                             {"P7", "a PAM image"}}};

constexpr std::array<Named, 2> kUnsupportedNames{{{".rawlog", "a rawlog"}, {".pcd", "a 3D point cloud"}}};

constexpr std::array<std::string_view, 12> kBinaryNames{
    ".png", ".pgm", ".gridmap", ".simplemap", ".jpg", ".jpeg", ".bmp", ".gif", ".tif", ".tiff", ".bt", ".ot"};

/** The extension in lower case, without a `.gz` behind it. */
std::string extensionOf(std::filesystem::path path)
{
    const auto lower = [](std::string text) {
        std::transform(text.begin(), text.end(), text.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
        return text;
    };
    if (lower(path.extension().string()) == ".gz") path = path.stem();
    return lower(path.extension().string());
}

bool isText(std::string_view bytes)
{
    constexpr std::size_t sample = 4096;
    const auto isControl = [](char c) {
        return (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f') ||
               c == 0x7f;
    };
    bytes = bytes.substr(0, sample);
    return std::none_of(bytes.begin(), bytes.end(), isControl);
}

/** Whether the bytes start with the two characters of a Netpbm image, which a blank or a comment ends. */
bool isNetpbm(std::string_view bytes, std::string_view mark)
{
    constexpr std::string_view ends = " \t\r\n#";
    return startsWith(bytes, mark) &&
           (bytes.size() == mark.size() || ends.find(bytes[mark.size()]) != ends.npos);
}

/** The first bytes, for people to recognise. */
std::string startOf(std::string_view bytes)
{
    constexpr std::size_t shown = 12;
    std::string start(bytes.substr(0, shown));
    for (char& c : start)
        if (static_cast<unsigned char>(c) > 0x7e) c = '?';
    return inQuotes(start);
}

[[noreturn]] void refuseKind(const std::string& name, std::string_view kind)
{
    if (kind == "a rawlog")
        throw InputError(name + " is a rawlog, no map; make a simplemap of it by 'gr2to-rawlog " +
                         "FILE.rawlog -o FILE.simplemap'");
    throw InputError(name + " is " + std::string(kind) +
                     "; 3D maps are not supported by this version: give a 2D grid (.yaml, " +
                     ".png, .pgm or .gridmap) or a .simplemap");
}

void refuseKnownOthers(std::string_view bytes, const std::string& name)
{
    if (startsWith(bytes, "# Octomap OcTree"))
        throw InputError(name +
                         " is an OctoMap octree where a 2D grid is needed (.yaml, .png, .pgm or .gridmap); " +
                         "'gr2to extract' takes octrees");
    if (startsWith(bytes, "# .PCD")) refuseKind(name, "a 3D point cloud");
    const auto refuseImage = [&](std::string_view kind) {
        throw InputError(name + " is " + std::string(kind) + "; convert it to PNG or PGM");
    };
    for (const auto& other : kOtherBinaryImages)
        if (startsWith(bytes, other.mark) && !isText(bytes)) refuseImage(other.kind);
    for (const auto& other : kOtherNetpbm)
        if (isNetpbm(bytes, other.mark)) refuseImage(other.kind);
}
}  // namespace

Format formatOf(std::string_view bytes, const std::filesystem::path& path)
{
    const std::string name = pathInQuotes(path);
    if (startsWith(bytes, "\x89PNG\r\n\x1a\n")) return Format::Png;
    if (isNetpbm(bytes, "P5") || isNetpbm(bytes, "P2")) return Format::Pgm;
    const std::string extension = extensionOf(path);
    const auto* const unsupported = std::find_if(kUnsupportedNames.begin(), kUnsupportedNames.end(),
                                                 [&](const Named& named) { return named.mark == extension; });
    if (const std::string kind = archiveKind(bytes, name); kind == "a simplemap")
        return Format::Simplemap;
    else if (!kind.empty())
        refuseKind(name, kind);
    if (archiveHeader(bytes)) return Format::Gridmap;
    if (unsupported != kUnsupportedNames.end()) refuseKind(name, unsupported->kind);
    if (isGzip(bytes)) return Format::Gridmap;
    refuseKnownOthers(bytes, name);
    const bool named = std::find(kBinaryNames.begin(), kBinaryNames.end(), extension) != kBinaryNames.end();
    if (isText(bytes) && !named) return Format::Yaml;
    if (named)
        throw InputError(name + " is named as " + extension + " but holds " +
                         (isText(bytes) ? "text" : "other data") + " (it starts with " + startOf(bytes) +
                         "); check that it is the right file");
    throw InputError(name + " is not a map that this version knows (it starts with " + startOf(bytes) +
                     "); give a ROS .yaml, a .png or .pgm image, an MRPT .gridmap or .simplemap");
}

std::string archiveKind(std::string_view bytes, const std::string& name)
{
    constexpr std::size_t enoughForTheClass = 256;
    std::string start;
    if (isGzip(bytes)) {
        GzipReader(bytes, name).readUpTo(start, enoughForTheClass);
        bytes = start;
    }
    const auto archive = archiveHeader(bytes);
    return archive ? kindOfClass(archive->className) : "";
}
}  // namespace gr2to::io
