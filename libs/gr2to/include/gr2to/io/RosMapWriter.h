#pragma once

#include <string>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to
{
/** Binary PGM (P5) as ROS's map savers write it: 254 free, 205 unknown, 0 occupied; the top row comes first.
 */
std::string encodePgm(const ClassifiedGrid& grid);

/** The YAML file that goes with such an image (PGM or PNG); numbers are printed shortest-exact.
 * \param imageName  path of the image relative to the YAML's folder
 */
std::string encodeRosYaml(const GridFrame& frame, const std::string& imageName);
}  // namespace gr2to
