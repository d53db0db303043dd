#pragma once

#include <cstdint>
#include <random>

namespace gr2to::test
{
/** Seeded numbers that are the same on every platform, which std::uniform_*_distribution does not promise.
 *
 * A purpose gives each use a stream of its own, so that adding furniture, say, does not move a wall.
 */
class SeededRandom
{
 public:
    enum class Purpose : std::uint32_t
    {
        Layout = 1,
        Doors,
        Furniture,
        Jitter,
        Noise
    };

    SeededRandom(int seed, Purpose purpose, std::size_t index = 0)
        : m_engine(
              mixed(mixed(static_cast<std::uint64_t>(seed)) ^
                    mixed((static_cast<std::uint64_t>(purpose) << 40U) + static_cast<std::uint64_t>(index))))
    {
    }

    /** In [0, 1). */
    double unit() { return static_cast<double>(m_engine()) * 0x1p-32; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    bool chance(double probability) { return unit() < probability; }
    /** In [low, high], both included. */
    int integer(int low, int high) { return low + static_cast<int>(unit() * (high - low + 1)); }

 private:
    /** The finaliser of MurmurHash3: neighbouring seeds give unrelated streams. */
    static std::uint32_t mixed(std::uint64_t value)
    {
        value ^= value >> 33U;
        value *= 0xff51afd7ed558ccdULL;
        value ^= value >> 33U;
        value *= 0xc4ceb9fe1a85ec53ULL;
        value ^= value >> 33U;
        return static_cast<std::uint32_t>(value);
    }

    std::mt19937 m_engine;
};
}  // namespace gr2to::test
