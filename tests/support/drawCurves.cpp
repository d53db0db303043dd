#include "support/drawCurves.h"

namespace gr2to::test
{
DrawnCurves drawCurves(const std::vector<std::string>& rows)
{
    DrawnCurves drawn;
    const int height = static_cast<int>(rows.size()), width = static_cast<int>(rows.front().size());
    drawn.distances.width = width;
    drawn.distances.height = height;
    Mask mask(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const char c = rows[static_cast<std::size_t>(height - 1 - y)].at(static_cast<std::size_t>(x));
            const int clearance = c >= '1' && c <= '9' ? c - '0' : 0;
            if (clearance > 0) mask[mask.index({x, y})] = 1;
            drawn.distances.squared.push_back(clearance * clearance);
        }
    drawn.voronoi = traceGraph(mask);
    return drawn;
}
}  // namespace gr2to::test
