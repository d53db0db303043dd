#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "gr2to/base/ZeroedMemory.h"
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
    /** Of all voxels within the layers of the bounds.
     * \param bounds  along x and y those of boundsOf(), along z any. Cost: linear in the boxes and in the
     * columns that they cover. \throws InputError  the columns would take more memory than maxBytes()
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
    bool isUnknown(std::size_t column) const
    {
        const Word* words = bits(column, 0);
        Word known = 0;
        for (std::size_t w = 0; w < 2 * m_words; ++w) known |= words[w];
        return known == 0;
    }
    /** NF and NO of eq. (7): how many voxels of a column are free, how many occupied. */
    int countFree(std::size_t column) const { return count(bits(column, 0)); }
    int countOccupied(std::size_t column) const { return count(bits(column, 1)); }

    /** The highest occupied layer; -1 when there is none. */
    int highestOccupied(std::size_t column) const
    {
        const Word* words = bits(column, 1);
        for (std::size_t w = m_words; w-- > 0;)
            if (words[w] != 0) return static_cast<int>(w) * kBits + kBits - 1 - __builtin_clzll(words[w]);
        return -1;
    }
    /** The lowest occupied layer from `from` upwards; -1 when there is none. */
    int lowestOccupied(std::size_t column, int from = 0) const
    {
        const Word* words = bits(column, 1);
        for (int w = from / kBits; w < static_cast<int>(m_words); ++w)
            if (const Word rest = words[w] & mask(std::max(0, from - w * kBits), kBits); rest != 0)
                return w * kBits + __builtin_ctzll(rest);
        return -1;
    }
    /** The number of free layers in [from, to). */
    int countFree(std::size_t column, int from, int to) const
    {
        const Word* words = bits(column, 0);
        int sum = 0;
        for (int w = std::max(0, from) / kBits; w < static_cast<int>(m_words) && w * kBits < to; ++w)
            sum += countBits(words[w] & mask(std::max(0, from - w * kBits), std::min(kBits, to - w * kBits)));
        return sum;
    }

 private:
    using Word = std::uint64_t;
    static constexpr int kBits = 64;

    /** Bits [from, to) of a word, both in [0, 64]. */
    static Word mask(int from, int to)
    {
        if (from >= to) return 0;
        const Word upTo = to == kBits ? ~Word{0} : (Word{1} << to) - 1;
        return upTo & ~((Word{1} << from) - 1);
    }
    /** Compilers make the processor's instruction of it where code is for processors that have one. */
    static int countBits(Word word)
    {
        word -= (word >> 1) & 0x5555555555555555U;
        word = (word & 0x3333333333333333U) + ((word >> 2) & 0x3333333333333333U);
        word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0FU;
        return static_cast<int>((word * 0x0101010101010101U) >> 56);
    }
    const Word* bits(std::size_t column, std::size_t occupied) const
    {
        return m_bits + (2 * column + occupied) * m_words;
    }
    int count(const Word* words) const
    {
        int sum = 0;
        for (std::size_t w = 0; w < m_words; ++w) sum += countBits(words[w]);
        return sum;
    }
    static std::size_t bytesFor(std::size_t columns, int layers, std::size_t words);
    template <bool OneWord>
    void fill(const VoxelBlock& block, const VoxelBounds& bounds);
    template <bool OneWord>
    void fill(const VoxelBox& box, const VoxelBounds& bounds);
    template <bool OneWord>
    void fillAll(const VoxelBoxes& voxels, const VoxelBounds& bounds);

    int m_width;
    int m_height;
    int m_layers;
    std::size_t m_words;    //!< that hold the layers of a column
    ZeroedMemory m_memory;  //!< of each column the free ones, then the occupied ones
    Word* m_bits = nullptr;
};
}  // namespace gr2to
