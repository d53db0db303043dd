#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace octomap
{
class OcTree;
}

namespace gr2to
{
/** Whether the bytes start as OctoMap's files do, `.bt` or `.ot`. */
bool isOctree(std::string_view bytes);
/** The same of a file; false when it cannot be read. */
bool isOctreeFile(const std::filesystem::path& path);

/** An octree as it was read. Shared, so that those who hand it on need not know OctoMap. */
struct OctreeFile
{
    std::shared_ptr<octomap::OcTree> tree;
    std::string format;       //!< for people
    double resolution_m = 0;  //!< side of a voxel
    std::size_t nodes = 0;    //!< inner ones and leaves
    std::size_t bytes = 0;    //!< that the tree takes in memory
};

/** Reads an octree of the type OcTree from OctoMap's binary file (`.bt`: free, occupied, unknown) or full
 * file (`.ot`: probabilities); told by the content.
 *
 * The nodes are counted before the tree is built, because OctoMap's own reader builds random branches of a
 * file that ends too early. \throws InputError  the file cannot be read, is no OctoMap, holds another type of
 * tree, or is truncated or malformed; one line that names the file
 */
OctreeFile readOctree(const std::filesystem::path& path);
}  // namespace gr2to
