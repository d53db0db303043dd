#pragma once

#include <mrpt/serialization/CArchive.h>

#include <cstdint>
#include <string>

#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
/** Version of what writeMap() writes, from 0. */
constexpr std::uint8_t MAP_ARCHIVE_VERSION = 0;
/** Version of a CTopologicalMap with its grid. */
constexpr std::uint8_t GRID_ARCHIVE_VERSION = 1;

/** Every attribute of the map, in MRPT's byte order. */
void writeMap(mrpt::serialization::CArchive& out, const TopologicalMap& map);

/** What writeMap() of that version wrote.
 * \param name  where the archive comes from, for messages
 * \throws InputError  a newer version, an early end, or content that no map has, such as an id twice
 */
TopologicalMap readMap(mrpt::serialization::CArchive& in, std::uint8_t version, const std::string& name);
}  // namespace gr2to
