#pragma once

namespace gr2to
{
/** Makes MRPT's class registry know this library's classes, so that archives that hold them can be read.
 *
 * Loading the library does so already, but a linker drops a library of which an application names no symbol;
 * this function is a symbol to name. Calling it again is harmless.
 */
void registerAllClasses();
}  // namespace gr2to
