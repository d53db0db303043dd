#include "gr2to/grid/VoxelColumns.h"

#include <string>

#include "gr2to/base/errors.h"

namespace gr2to
{
namespace
{
/** The voxels of a block column by column: bits 2 k and 2 k + 1 are those over each other, k and k + 4 of the
 * block. */
unsigned pairsOf(unsigned voxels)
{
    static constexpr std::uint8_t everyOther[16] = {0,  1,  4,  5,  16, 17, 20, 21,
                                                    64, 65, 68, 69, 80, 81, 84, 85};
    return everyOther[voxels & 15U] | (static_cast<unsigned>(everyOther[voxels >> 4]) << 1);
}
}  // namespace

std::size_t VoxelColumns::bytesFor(std::size_t columns, int layers, std::size_t words)
{
    const std::size_t bytes = 2 * columns * words * sizeof(Word);
    if (bytes > maxBytes())
        throw InputError(
            "the 3D map has " + std::to_string(columns) + " columns of " + std::to_string(layers) +
            " voxels, more than fit into 4 GB; give compression.z_min and compression.z_max, or cut the map");
    return bytes;
}

VoxelColumns::VoxelColumns(const VoxelBoxes& voxels, const VoxelBounds& bounds)
    : m_width(bounds.lastX - bounds.firstX),
      m_height(bounds.lastY - bounds.firstY),
      m_layers(bounds.lastZ - bounds.firstZ),
      m_words(static_cast<std::size_t>((m_layers + kBits - 1) / kBits)),
      m_memory(bytesFor(size(), m_layers, m_words))
{
    m_bits = static_cast<Word*>(m_memory.data());
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
    const std::size_t corner =
        static_cast<std::size_t>(block.y - bounds.firstY) * static_cast<std::size_t>(m_width) +
        static_cast<std::size_t>(block.x - bounds.firstX);
    const unsigned free = pairsOf(block.free), occupied = pairsOf(block.occupied);
    if (OneWord && z >= 0 && z + 2 <= m_layers) {
        Word* row = m_bits + 2 * corner;
        const std::size_t toNextRow = 2 * static_cast<std::size_t>(m_width);
        for (unsigned k = 0; k < 4; ++k) {
            Word* at = row + ((k & 1) != 0 ? 2 : 0) + ((k >> 1) != 0 ? toNextRow : 0);
            at[0] |= Word{(free >> (2 * k)) & 3U} << z;
            at[1] |= Word{(occupied >> (2 * k)) & 3U} << z;
        }
        return;
    }
    for (unsigned k = 0; k < 4; ++k) {
        const std::size_t column = corner + (k >> 1) * static_cast<std::size_t>(m_width) + (k & 1);
        Word* at = m_bits + 2 * column * m_words;
        for (int dz = 0; dz < 2; ++dz) {
            const int layer = z + dz;
            if (layer < 0 || layer >= m_layers) continue;
            const auto word = static_cast<std::size_t>(layer / kBits);
            const unsigned bit = 2 * k + static_cast<unsigned>(dz);
            at[word] |= Word{(free >> bit) & 1U} << (layer % kBits);
            at[m_words + word] |= Word{(occupied >> bit) & 1U} << (layer % kBits);
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
    const auto width = static_cast<std::size_t>(m_width), cells = static_cast<std::size_t>(side);
    const std::size_t corner = static_cast<std::size_t>(box.y - bounds.firstY) * width +
                               static_cast<std::size_t>(box.x - bounds.firstX);
    const std::size_t words = OneWord ? 1 : m_words;
    for (int word = from / kBits; word * kBits < to; ++word) {
        const Word layers = mask(std::max(0, from - word * kBits), std::min(kBits, to - word * kBits));
        Word* row = m_bits + (2 * corner + (box.occupied ? 1 : 0)) * words + static_cast<std::size_t>(word);
        for (std::size_t y = 0; y < cells; ++y, row += 2 * width * words)
            for (std::size_t x = 0; x < cells; ++x) row[2 * x * words] |= layers;
    }
}
}  // namespace gr2to
