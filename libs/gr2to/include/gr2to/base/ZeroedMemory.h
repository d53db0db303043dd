#pragma once

#include <cstddef>

namespace gr2to
{
/** Asks the system for large pages in memory that is about to be filled; part of a large page stays as it is.
 */
void wishLargePages(void* from, std::size_t bytes);

/** Zeroed memory for a large table that is filled in no order.
 *
 * It asks the system for large pages: with small ones, the first touch of each costs more than the work on
 * it.
 */
class ZeroedMemory
{
 public:
    ZeroedMemory() = default;
    /** \throws std::bad_alloc  there is not as much */
    explicit ZeroedMemory(std::size_t bytes);
    ZeroedMemory(const ZeroedMemory&) = delete;
    ZeroedMemory& operator=(const ZeroedMemory&) = delete;
    ~ZeroedMemory();

    /** Aligned for any type. */
    void* data() const { return m_data; }

 private:
    void* m_mapping = nullptr;
    std::size_t m_mapped = 0;
    void* m_data = nullptr;
};
}  // namespace gr2to
