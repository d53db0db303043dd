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

/** Without the processor's instruction, which not all have. */
int countBits(std::uint64_t word)
{
    word -= (word >> 1) & 0x5555555555555555U;
    word = (word & 0x3333333333333333U) + ((word >> 2) & 0x3333333333333333U);
    word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0FU;
    return static_cast<int>((word * 0x0101010101010101U) >> 56);
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
    for (const VoxelBlock& block : voxels.blocks) fill(block, bounds);
    for (const VoxelBox& box : voxels.boxes) fill(box, bounds);
}

/** Two voxels of a column at a time; by single voxels where the block is not whole within the layers of one
 * word. */
void VoxelColumns::fill(const VoxelBlock& block, const VoxelBounds& bounds)
{
    const int z = block.z - bounds.firstZ;
    if (z >= m_layers || z + 1 < 0) return;
    const int x = block.x - bounds.firstX, y = block.y - bounds.firstY;
    const bool whole = z >= 0 && z + 2 <= m_layers && z % kBits != kBits - 1;
    for (int k = 0; k < 4; ++k) {
        const unsigned known = (block.free | block.occupied) >> k;
        if ((known & 0x11U) == 0) continue;  // it may lie outside of the grid
        const std::size_t column =
            static_cast<std::size_t>(y + (k >> 1)) * static_cast<std::size_t>(m_width) +
            static_cast<std::size_t>(x + (k & 1));
        Word* words = m_bits.data() + 2 * column * m_words;
        if (whole) {
            // voxels k and k + 4 of the block lie over each other
            const auto pair = [k](unsigned bits) {
                return Word{((bits >> k) & 1U) | ((bits >> (k + 3)) & 2U)};
            };
            Word* at = words + z / kBits;
            at[0] |= pair(block.free) << (z % kBits);
            at[m_words] |= pair(block.occupied) << (z % kBits);
            continue;
        }
        for (int dz = 0; dz < 2; ++dz) {
            if (z + dz < 0 || z + dz >= m_layers || ((known >> (4 * dz)) & 1) == 0) continue;
            const bool occupied = (block.occupied >> (k + 4 * dz)) & 1;
            words[(occupied ? m_words : 0) + static_cast<std::size_t>((z + dz) / kBits)] |=
                Word{1} << ((z + dz) % kBits);
        }
    }
}

bool VoxelColumns::isUnknown(std::size_t column) const
{
    const Word* words = bits(column, 0);
    for (std::size_t w = 0; w < 2 * m_words; ++w)
        if (words[w] != 0) return false;
    return true;
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
