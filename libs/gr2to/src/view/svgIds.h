#pragma once

#include <string>

namespace gr2to::view
{
/** The SVG with the number at the end of each id replaced by its rank of appearance among ids of the same
 * prefix.
 *
 * Cairo numbers images and surfaces by a counter of the process, so without this the second picture that a
 * program draws would differ from the first one.
 */
std::string withNumberedIds(const std::string& svg);
}  // namespace gr2to::view
