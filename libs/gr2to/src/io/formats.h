#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gr2to::io
{
enum class Format
{
    Png,
    Pgm,
    Gridmap,    //!< MRPT archive, compressed or not
    Simplemap,  //!< the same
    Yaml        //!< text that may be a map's YAML file
};

/** The format of a 2D map, told by its first bytes; the name only helps to word the refusal of others.
 * \throws InputError  the content is of no supported kind, or is text under the name of an image or an
 * archive
 */
Format formatOf(std::string_view bytes, const std::filesystem::path& path);

/** kindOfClass() of what an MRPT archive, compressed or not, begins with; empty when it is none. */
std::string archiveKind(std::string_view bytes, const std::string& name);
}  // namespace gr2to::io
