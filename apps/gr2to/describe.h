#pragma once

#include <filesystem>
#include <string>

#include "gr2to/io/GridReader.h"
#include "gr2to/io/OctreeReader.h"
#include "gr2to/topology/TopologicalMap.h"

namespace gr2to::cli
{
/** What a grid holds, in lines of text or as JSON. */
std::string gridText(const std::filesystem::path& file, const ClassifiedGrid& grid, const GridSource& source);
std::string gridJson(const std::filesystem::path& file, const ClassifiedGrid& grid, const GridSource& source);

/** What a 3D map holds, with the floor and the ceiling that `gr2to extract` would find in it.
 * \throws InputError  it has no voxel
 */
std::string octreeText(const std::filesystem::path& file, const OctreeFile& octree);
std::string octreeJson(const std::filesystem::path& file, const OctreeFile& octree);

/** What a topological map holds, with a table of its places, as text or as JSON. */
std::string mapText(const std::filesystem::path& file, const TopologicalMap& map);
std::string mapJson(const std::filesystem::path& file, const TopologicalMap& map);

/** The map in a folder that `gr2to extract` wrote: topomap.xml, else topomap.gr2to; anything else as it is.
 * \throws InputError  a folder without either
 */
std::filesystem::path mapFileIn(const std::filesystem::path& path);
}  // namespace gr2to::cli
