#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gr2to/io/GridReader.h"
#include "gr2to/pipeline/Gr2To.h"

namespace gr2to::cli
{
/** A map as the second stage takes it, and how it came about. */
struct InputMap
{
    CompressedGrid map;                    //!< of a 2D grid without heights
    std::string format;                    //!< for people
    std::filesystem::path image;           //!< that a YAML names; empty for other formats
    std::optional<CompressedRange> range;  //!< of a 3D map
    std::vector<CapturedView> views;       //!< images in a simplemap's keyframes
    std::vector<StageReport> stages;       //!< reading, and compression of a 3D map
};

/** Reads a 2D grid, or an octree and compresses it.
 * \param preset  the options of `stages` were set from: an option that cannot apply to the input must have
 * its value \throws InputError  the file cannot be used, or an option that does not apply to it was given;
 * names the file
 */
InputMap readInput(const std::filesystem::path& path, TGridReaderOptions& reader, Gr2ToOptions& stages,
                   const std::string& preset);

/** \throws InputError  a field of `given` has another value than that of `standard`, being of no use for the
 * input */
void requireUnused(OptionTable& given, OptionTable& standard, const std::string& input);
}  // namespace gr2to::cli
