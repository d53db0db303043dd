#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gr2to/grid/VoxelBoxes.h"

namespace gr2to
{
/** The voxels over every cell of a grid, one bit each for free and for occupied.
 *
 * Layers count from 0, the lowest. Columns are in the order of a grid's cells.
 */
class VoxelColumns
{
 public:
    /** Of all boxes within the bounds. Cost: linear in the boxes and in the columns that they cover.
     * \throws InputError  the columns would take more memory than maxBytes()
     */
    VoxelColumns(const VoxelBoxes& voxels, const VoxelBounds& bounds);

    static constexpr std::size_t maxBytes() { return std::size_t{4} << 30; }

    int width() const { return m_width; }
    int height() const { return m_height; }
    int layers() const { return m_layers; }
    std::size_t size() const
    {
        return static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height);
    }

    /** Whether a column has no known voxel at all. */
    bool isUnknown(std::size_t column) const;
    /** NF and NO of eq. (7): how many voxels of a column are free, how many occupied. */
    int countFree(std::size_t column) const { return count(bits(column, 0)); }
    int countOccupied(std::size_t column) const { return count(bits(column, 1)); }

    /** The highest occupied layer; -1 when there is none. */
    int highestOccupied(std::size_t column) const;
    /** The lowest occupied layer from `from` upwards; -1 when there is none. */
    int lowestOccupied(std::size_t column, int from = 0) const;
    /** The number of free layers in [from, to). */
    int countFree(std::size_t column, int from, int to) const;

 private:
    using Word = std::uint64_t;
    static constexpr int kBits = 64;

    const Word* bits(std::size_t column, std::size_t occupied) const
    {
        return m_bits.data() + (2 * column + occupied) * m_words;
    }
    int count(const Word* words) const;
    void fill(const VoxelBlock& block, const VoxelBounds& bounds);
    void fill(const VoxelBox& box, const VoxelBounds& bounds);

    int m_width;
    int m_height;
    int m_layers;
    std::size_t m_words;       //!< that hold the layers of a column
    std::vector<Word> m_bits;  //!< of each column the free ones, then the occupied ones
};
}  // namespace gr2to
