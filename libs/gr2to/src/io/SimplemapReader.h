#pragma once

#include <mrpt/maps/CSimpleMap.h>

#include <string>
#include <string_view>

#include "gr2to/io/GridReader.h"
#include "gr2to/io/OccupancyGrid.h"

namespace gr2to::io
{
/** Reads an MRPT simplemap of version 0 or 1, compressed by gzip or not.
 * \param name  of the file, quoted, for messages
 * \throws InputError  truncated, damaged, of a newer version, or with an object whose class is not registered
 */
mrpt::maps::CSimpleMap readSimplemap(std::string_view bytes, const std::string& name);

/** The grid that MRPT builds of a simplemap's observations.
 * \param counts  receives how many observations there were and were used
 * \throws InputError  no observation that a grid can take, or the grid would be larger than one can be
 */
ClassifiedGrid gridOfSimplemap(const mrpt::maps::CSimpleMap& map, const std::string& name,
                               double resolution_m, const TScanOptions& options,
                               const OccupancyThresholds& thresholds, ScanCounts& counts);
}  // namespace gr2to::io
