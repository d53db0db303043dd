#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <string>
#include <vector>

namespace gr2to::test
{
/** Objects as MRPT archives them one after the other, not compressed. */
std::string archiveOf(const std::vector<const mrpt::serialization::CSerializable*>& objects);

/** The rawlog of a robot that drives through the two rooms of twoSquareRooms(), 0.2 m a step from 1 m on to
 * the right, and scans all around: an action and a frame for each step.
 * \param timestamps  false for none, as in some old files
 */
std::string walkThroughRooms(int steps, bool timestamps = true);
}  // namespace gr2to::test
