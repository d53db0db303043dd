#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gr2to/io/OccupancyGrid.h"

namespace gr2to::io
{
/** How an object in an MRPT archive starts. */
struct ArchiveHeader
{
    std::string className;  //!< without its namespaces
    std::string fullName;   //!< as it is stored
    int version = 0;
    bool hasEndFlag = true;  //!< of the object; MRPT before 0.5.5 wrote none
    std::size_t size = 0;    //!< bytes up to the object's data
};

/** The header, when the bytes start as an MRPT archive does. */
std::optional<ArchiveHeader> archiveHeader(std::string_view bytes);

/** What an MRPT class holds, in words, when it is one that people may take for a grid; else empty. */
std::string kindOfClass(const std::string& className);

/** Reads a COccupancyGridMap2D from an MRPT archive, compressed by gzip or not.
 * \param name  of the file, quoted, for messages
 * \throws InputError  the archive holds something else, is truncated, or contradicts itself
 */
ClassifiedGrid readGridmap(std::string_view bytes, const std::string& name,
                           const OccupancyThresholds& thresholds);
}  // namespace gr2to::io
