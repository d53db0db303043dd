#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gr2to::cli
{
/** One `name = value` of an ini file. */
struct IniEntry
{
    std::string key;  //!< `section.name`
    std::string value;
    std::size_t line = 0;  //!< from 1
};

/** The entries of an ini file in MRPT's format, in the order of the file.
 *
 * Values are read by MRPT, so that `//` starts a comment in them; a line that MRPT would skip without a word
 * is an error here, and so is a key that comes twice. \throws InputError  the file cannot be read, or a line
 * is neither a section, a comment nor `name = value`
 */
std::vector<IniEntry> readIniFile(const std::filesystem::path& path);
}  // namespace gr2to::cli
