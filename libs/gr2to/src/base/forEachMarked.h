#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace gr2to
{
/** Calls a function with the position of every byte that is not 0, in order; where few are set, at the cost
 * of reading eight bytes at a time. The function may read the bytes, not change them. */
template <class Function>
void forEachMarked(const std::uint8_t* marks, std::size_t count, const Function& function)
{
    std::size_t i = 0;
    for (; i + 8 <= count; i += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, marks + i, sizeof eight);
        if (eight == 0) continue;
        for (std::size_t k = i; k < i + 8; ++k)
            if (marks[k]) function(k);
    }
    for (; i < count; ++i)
        if (marks[i]) function(i);
}
}  // namespace gr2to
