#include "gr2to/grid/SimpleCells.h"

namespace gr2to
{
namespace
{
/** Runs around the ring of neighbours; a 4-connected run counts when it holds a cell that shares a side. */
int figureRuns(std::uint8_t ring)
{
    if (ring == 0xFF) return 1;
    int start = 0;
    while ((ring >> start) & 1) ++start;
    int runs = 0;
    bool touchesSide = false;
    for (int k = 1; k <= 8; ++k) {
        const int i = (start + k) % 8;
        if ((ring >> i) & 1)
            touchesSide = touchesSide || i % 2 == 0;
        else {
            runs += touchesSide ? 1 : 0;
            touchesSide = false;
        }
    }
    return runs;
}

/** Components of the ground among the neighbours, corners joined by sides (8-connected). */
int groundRuns(std::uint8_t ring)
{
    const auto ground = static_cast<std::uint8_t>(~ring);
    if (ground == 0) return 0;
    const std::uint8_t sides = ground & 0x55U;
    if (sides == 0) return __builtin_popcount(ground);
    // Two ground sides next to each other share a corner and touch across it even when that corner is figure.
    std::uint8_t joined = ground;
    for (int corner = 1; corner < 8; corner += 2) {
        const int before = corner - 1, after = (corner + 1) % 8;
        if (((ground >> before) & 1) && ((ground >> after) & 1))
            joined = static_cast<std::uint8_t>(joined | 1U << corner);
    }
    if (joined == 0xFF) return 1;
    int runs = 0;
    for (int i = 0; i < 8; ++i)
        if (((joined >> i) & 1) && !((joined >> ((i + 7) % 8)) & 1)) ++runs;
    return runs;
}

std::array<bool, 256> makeSimpleTable()
{
    std::array<bool, 256> table{};
    for (unsigned ring = 0; ring < 256; ++ring)
        table[ring] = figureRuns(static_cast<std::uint8_t>(ring)) == 1 &&
                      groundRuns(static_cast<std::uint8_t>(ring)) == 1;
    return table;
}
}  // namespace

const std::array<bool, 256>& simpleTable()
{
    static const std::array<bool, 256> table = makeSimpleTable();
    return table;
}

bool isSimple(std::uint8_t neighbours)
{
    return simpleTable()[neighbours];
}
}  // namespace gr2to
