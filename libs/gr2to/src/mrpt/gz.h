#pragma once

#include <string>
#include <string_view>

namespace gr2to
{
/** Whether bytes begin as a gz file does. */
bool isGz(std::string_view bytes);

/** One gz member without name or time: the same bytes in, the same bytes out. */
std::string compressGz(std::string_view bytes);

/** The content of a gz file of one member.
 * \throws InputError  not gz, truncated, corrupt, bytes after the end, or a content over `mostBytes`
 */
std::string decompressGz(std::string_view bytes, const std::string& name, std::size_t mostBytes);
}  // namespace gr2to
