#include "gr2to/topology/CutEnds.h"

#include <algorithm>

#include "grid/thickness.h"

namespace gr2to
{
namespace
{
/** A walk along a digital line into the obstacle at its end. */
struct Walk
{
    const ClassifiedGrid& grid;
    const LineDirection& direction;
    int step, row;  // of the first cell that is not free
    int sense;      // 1 or -1

    Cell at(int depth, int aside) const { return direction.cell(step + sense * depth, row + aside); }
    bool isObstacle(Cell c) const { return grid.contains(c) && !grid.isFree(c); }

    /** The row nearest to the line that has an obstacle, as an offset; none within two rows: `nowhere`. */
    static constexpr int nowhere = 99;
    int obstacleBeside(int depth) const
    {
        for (const int aside : {0, 1, -1, 2, -2})
            if (isObstacle(at(depth, aside))) return aside;
        return nowhere;
    }

    /** Rows that the obstacle is thick at a depth. */
    int thickness(int depth, int aside, int most) const
    {
        return thicknessAcross(grid, direction, step + sense * depth, row + aside, most);
    }
};

double finLength(const Walk& walk, const CutEndRules& rules)
{
    constexpr int widestGap = 2;  // steps: an obstacle of scattered cells is a wall all the same
    const double stretch = walk.direction.stretch();
    const int thickest = std::max(2, static_cast<int>(rules.thickest_cells * stretch));
    const int longest = static_cast<int>(rules.longest_cells / stretch);
    double fin = 0;
    int gap = 0;
    for (int depth = 0; depth <= longest && walk.grid.contains(walk.at(depth, 0)); ++depth) {
        const int aside = walk.obstacleBeside(depth);
        if (aside == Walk::nowhere) {
            if (++gap > widestGap) break;
            continue;
        }
        gap = 0;
        if (walk.thickness(depth, aside, thickest) > thickest) break;
        fin = (depth + 1) * stretch;
    }
    return fin;
}

/** Whether a square of the obstacle behind the end is full: straight behind it, or to one side of the line.
 */
bool isSolid(const Walk& walk, const CutEndRules& rules)
{
    constexpr double full = 0.9;
    const int deep = std::max(2, static_cast<int>(rules.solid_cells / walk.direction.stretch()));
    const int half = std::max(1, static_cast<int>(rules.solid_cells * walk.direction.stretch() / 2));
    for (const int shift : {-half, 0, half}) {
        int occupied = 0;
        for (int depth = 0; depth < deep; ++depth)
            for (int aside = -half; aside <= half; ++aside)
                occupied += walk.grid.isOccupied(walk.at(depth, shift + aside)) ? 1 : 0;
        if (occupied > full * deep * (2 * half + 1)) return true;
    }
    return false;
}
}  // namespace

std::array<CutEnd, 2> examineEnds(const ClassifiedGrid& grid, const LineDirection& direction,
                                  const std::vector<Cell>& line, const CutEndRules& rules)
{
    const bool upwards = direction.step(line.front()) <= direction.step(line.back());
    const Cell low = upwards ? line.front() : line.back(), high = upwards ? line.back() : line.front();
    const auto examine = [&](Cell last, int sense) {
        const Walk walk{grid, direction, direction.step(last) + sense, direction.row(last), sense};
        return CutEnd{finLength(walk, rules), isSolid(walk, rules)};
    };
    return {examine(low, -1), examine(high, 1)};
}
}  // namespace gr2to
