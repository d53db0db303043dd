#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
/** The map as XML, version 1.0 of share/topomap.xsd; the same map gives the same bytes.
 *
 * Numbers are printed with the fewest digits that read back to the same double. Left out are a height that
 * was not measured, a covariance that is zero, and a view's time that is zero. \throws std::invalid_argument
 * XML cannot hold the map: a number that is not finite, a covariance that is not exactly symmetric, an
 * enumerator without a name, text that is not UTF-8 or has control characters
 */
std::string toXml(const TopologicalMap& map);

/** One place as its `<place>` element in toXml() of its map. \throws std::invalid_argument  as there */
std::string toXml(const Place& place);

/** The map that XML of version 1.0 holds: fromXml(toXml(map), name) == map.
 *
 * Nothing is skipped but comments, processing instructions and white space between elements. Whether the
 * values make sense (an area greater than 0, a unit normal) is for TopologicalMap::validate() to say. \param
 * text  UTF-8, as the whole file \param name  the file's name, for messages \throws InputError  not
 * well-formed (with line and byte), or something is unknown, missing, twice, out of order, unreadable or
 * refers to a place that does not exist (with the path of the element)
 */
TopologicalMap fromXml(std::string_view text, const std::string& name);

/** fromXml() of a file. \throws InputError  it cannot be read, or as fromXml() */
TopologicalMap readXml(const std::filesystem::path& path);
}  // namespace gr2to
