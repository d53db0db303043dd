#include <gr2to/pipeline/Gr2To.h>

#include <iostream>

int main()
{
    gr2to::GridFrame frame;
    frame.resolution_m = 0.1;
    gr2to::ClassifiedGrid grid(60, 40, frame, gr2to::CellState::Occupied);
    for (int y = 1; y < 39; ++y)
        for (int x = 1; x < 59; ++x)
            if (x != 30 || (y > 15 && y < 25)) grid.set({x, y}, gr2to::CellState::Free);
    const auto extraction = gr2to::Gr2To().extract(grid);
    std::cout << extraction.map.places().size() << " places\n";
    return extraction.map.places().empty() ? 1 : 0;
}
