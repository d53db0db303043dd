#pragma once

#include <pugixml.hpp>
#include <string>

namespace gr2to
{
/** Where a node is, below the root: `places/place[id=3]/walls/wall[2]/position`; the root's own name for the
 * root.
 *
 * Places and connections are told by their id, when they have a number for one; other members of lists by
 * their number among their like, from 1.
 */
std::string xmlPath(pugi::xml_node node);
}  // namespace gr2to
