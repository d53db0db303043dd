#include "gr2to/grid/VoxelColumns.h"

#include <new>
#include <string>

#include "gr2to/base/errors.h"

namespace gr2to
{
VoxelColumns::VoxelColumns(const VoxelBoxes& voxels, const VoxelBounds& bounds)
    : m_width(bounds.lastX - bounds.firstX),
      m_height(bounds.lastY - bounds.firstY),
      m_layers(bounds.lastZ - bounds.firstZ),
      m_words(static_cast<std::size_t>((m_layers + kBits - 1) / kBits))
{
    const std::size_t words = 2 * size() * m_words;
    if (words > maxBytes() / sizeof(Word))
        throw InputError(
            "the 3D map has " + std::to_string(m_width) + " x " + std::to_string(m_height) + " columns of " +
            std::to_string(m_layers) +
            " voxels, more than fit into 4 GB; give compression.z_min and compression.z_max, or cut the map");
    // Large zeroed memory comes from the system as it is needed, without a pass over it.
    m_bits.reset(static_cast<Word*>(std::calloc(words, sizeof(Word))));
    if (!m_bits) throw std::bad_alloc();
    m_words == 1 ? fillAll<true>(voxels, bounds) : fillAll<false>(voxels, bounds);
}

template <bool OneWord>
void VoxelColumns::fillAll(const VoxelBoxes& voxels, const VoxelBounds& bounds)
{
    for (const VoxelBlock& block : voxels.blocks) fill<OneWord>(block, bounds);
    for (const VoxelBox& box : voxels.boxes) fill<OneWord>(box, bounds);
}

/** Two voxels of a column at a time; by single voxels where the block is not whole within the layers of one
 * word. */
template <bool OneWord>
void VoxelColumns::fill(const VoxelBlock& block, const VoxelBounds& bounds)
{
    const int z = block.z - bounds.firstZ;
    if (z >= m_layers || z + 1 < 0) return;
    const bool whole = z >= 0 && z + 2 <= m_layers && (OneWord || z % kBits != kBits - 1);
    const std::size_t corner =
        static_cast<std::size_t>(block.y - bounds.firstY) * static_cast<std::size_t>(m_width) +
        static_cast<std::size_t>(block.x - bounds.firstX);
    for (unsigned k = 0; k < 4; ++k) {
        const std::size_t column = corner + (k >> 1) * static_cast<std::size_t>(m_width) + (k & 1);
        // voxels k and k + 4 of the block lie over each other
        const unsigned free = (block.free >> k) & 0x11U, occupied = (block.occupied >> k) & 0x11U;
        const Word freePair = (free | (free >> 3)) & 3U, occupiedPair = (occupied | (occupied >> 3)) & 3U;
        if (OneWord && whole) {
            Word* at = m_bits.get() + 2 * column;
            at[0] |= freePair << z;
            at[1] |= occupiedPair << z;
            continue;
        }
        Word* at = m_bits.get() + 2 * column * m_words;
        for (int dz = 0; dz < 2; ++dz) {
            const int layer = z + dz;
            if (layer < 0 || layer >= m_layers) continue;
            const auto word = static_cast<std::size_t>(layer / kBits);
            at[word] |= ((freePair >> dz) & 1U) << (layer % kBits);
            at[m_words + word] |= ((occupiedPair >> dz) & 1U) << (layer % kBits);
        }
    }
}

template <bool OneWord>
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
    const std::size_t words = OneWord ? 1 : m_words;
    for (int word = from / kBits; word * kBits < to; ++word) {
        const Word layers = mask(std::max(0, from - word * kBits), std::min(kBits, to - word * kBits));
        for (int y = bottom; y < top; ++y) {
            const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                                      static_cast<std::size_t>(left);
            Word* at =
                m_bits.get() + (2 * first + (box.occupied ? 1 : 0)) * words + static_cast<std::size_t>(word);
            for (int x = left; x < right; ++x, at += 2 * words) *at |= layers;
        }
    }
}
}  // namespace gr2to
