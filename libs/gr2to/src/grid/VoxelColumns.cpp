#include "gr2to/grid/VoxelColumns.h"

#include <algorithm>
#include <string>

#include "gr2to/base/errors.h"

namespace gr2to
{
namespace
{
/** Bits [from, to) of a word, both in [0, 64]. */
std::uint64_t mask(int from, int to)
{
    if (from >= to) return 0;
    const std::uint64_t upTo = to == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << to) - 1;
    return upTo & ~((std::uint64_t{1} << from) - 1);
}

int countBits(std::uint64_t word)
{
    return __builtin_popcountll(word);
}
}  // namespace

VoxelColumns::VoxelColumns(const VoxelBoxes& voxels, const VoxelBounds& bounds)
    : m_width(bounds.lastX - bounds.firstX),
      m_height(bounds.lastY - bounds.firstY),
      m_layers(bounds.lastZ - bounds.firstZ),
      m_words(static_cast<std::size_t>((m_layers + kBits - 1) / kBits))
{
    const std::size_t words = 2 * size() * m_words;
    if (words > maxBytes() / sizeof(Word))
        throw InputError("the 3D map has " + std::to_string(m_width) + " x " + std::to_string(m_height) +
                         " columns of " + std::to_string(m_layers) +
                         " voxels, more than fit into 4 GB; give compression.z_min and "
                         "compression.z_max, or cut the map");
    m_bits.assign(words, 0);
    for (const VoxelBox& box : voxels.boxes) fill(box, bounds);
}

void VoxelColumns::fill(const VoxelBox& box, const VoxelBounds& bounds)
{
    const int side = box.side();
    const int from = std::max(0, box.z - bounds.firstZ),
              to = std::min(m_layers, box.z + side - bounds.firstZ);
    if (from >= to) return;
    const int left = std::max(0, box.x - bounds.firstX),
              right = std::min(m_width, box.x + side - bounds.firstX);
    const int bottom = std::max(0, box.y - bounds.firstY),
              top = std::min(m_height, box.y + side - bounds.firstY);
    for (int word = from / kBits; word * kBits < to; ++word) {
        const Word layers = mask(std::max(0, from - word * kBits), std::min(kBits, to - word * kBits));
        for (int y = bottom; y < top; ++y) {
            const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width);
            for (int x = left; x < right; ++x) {
                const std::size_t column = row + static_cast<std::size_t>(x);
                m_bits[(2 * column + (box.occupied ? 1 : 0)) * m_words + static_cast<std::size_t>(word)] |=
                    layers;
            }
        }
    }
}

int VoxelColumns::count(const Word* words) const
{
    int sum = 0;
    for (std::size_t w = 0; w < m_words; ++w) sum += countBits(words[w]);
    return sum;
}

int VoxelColumns::highestOccupied(std::size_t column) const
{
    const Word* words = bits(column, 1);
    for (std::size_t w = m_words; w-- > 0;)
        if (words[w] != 0) return static_cast<int>(w) * kBits + kBits - 1 - __builtin_clzll(words[w]);
    return -1;
}

int VoxelColumns::lowestOccupied(std::size_t column, int from) const
{
    const Word* words = bits(column, 1);
    for (int w = from / kBits; w < static_cast<int>(m_words); ++w)
        if (const Word rest = words[w] & mask(std::max(0, from - w * kBits), kBits); rest != 0)
            return w * kBits + __builtin_ctzll(rest);
    return -1;
}

int VoxelColumns::countFree(std::size_t column, int from, int to) const
{
    const Word* words = bits(column, 0);
    int sum = 0;
    for (int w = std::max(0, from) / kBits; w < static_cast<int>(m_words) && w * kBits < to; ++w)
        sum += countBits(words[w] & mask(std::max(0, from - w * kBits), std::min(kBits, to - w * kBits)));
    return sum;
}
}  // namespace gr2to
