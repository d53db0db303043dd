#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
/** The map as a gz-compressed MRPT archive that holds one CTopologicalMap; the same map gives the same bytes.
 *
 * MRPT reads it by `CFileGZInputStream` and `archiveFrom(file) >> object`.
 */
std::string toArchive(const TopologicalMap& map);

/** The map of such an archive: fromArchive(toArchive(map), name) == map.
 * \param bytes  the whole file
 * \param name   the file's name, for messages
 * \throws InputError  not gz, truncated, corrupt, holds another class, a newer version or more than one
 * object, or would unpack to more than 1 GiB
 */
TopologicalMap fromArchive(std::string_view bytes, const std::string& name);

/** Whether bytes begin as a topological map does: as XML, or as a gz-compressed archive of this library's
 * class. \param bytes  the whole file \throws InputError  the bytes begin as a gz file but cannot be unpacked
 */
bool isTopologicalMap(std::string_view bytes, const std::string& name);

/** Reads a map from XML or an archive, told apart by their content.
 * \throws InputError  the file is neither, or as readFile(), fromXml() and fromArchive()
 */
TopologicalMap loadTopologicalMap(const std::filesystem::path& path);
}  // namespace gr2to
