#include "gr2to/grid/Partition.h"

#include <algorithm>

#include "gr2to/grid/DistanceMap.h"

namespace gr2to
{
namespace
{
/** Not a place; stands on free cells that labels may not enter yet. Never leaves this file. */
constexpr PlaceId kClosed = 0xFFFF;

/** Labels that spread over the free cells, wave by wave. */
class Spreading
{
 public:
    Spreading(const ClassifiedGrid& grid, PlaceImage& image) : m_grid(grid), m_image(image) {}

    void start(std::size_t i, PlaceId label)
    {
        m_image.ids[i] = label;
        m_front.push_back(i);
    }

    void run()
    {
        bool overCorners = false;
        std::vector<std::size_t> next;
        while (!m_front.empty()) {
            next.clear();
            for (const std::size_t i : m_front) enterAround(i, overCorners, next);
            m_front.swap(next);
            overCorners = !overCorners;
        }
    }

 private:
    void enterAround(std::size_t i, bool overCorners, std::vector<std::size_t>& next)
    {
        const auto width = static_cast<std::size_t>(m_image.width);
        const std::size_t x = i % width;
        const bool right = x + 1 < width, left = x > 0, up = i + width < m_image.ids.size(),
                   down = i >= width;
        const PlaceId label = m_image.ids[i];
        const bool canRight = right && enter(i + 1, label, next), canLeft = left && enter(i - 1, label, next);
        const bool canUp = up && enter(i + width, label, next),
                   canDown = down && enter(i - width, label, next);
        if (!overCorners) return;
        // Over a corner only past two open sides, so that no label slips through a diagonal wall.
        if (canRight && canUp) enter(i + width + 1, label, next);
        if (canLeft && canUp) enter(i + width - 1, label, next);
        if (canRight && canDown) enter(i - width + 1, label, next);
        if (canLeft && canDown) enter(i - width - 1, label, next);
    }

    /** Labels a cell when it is free and still open. \return whether labels may pass it */
    bool enter(std::size_t i, PlaceId label, std::vector<std::size_t>& next)
    {
        if (m_grid[i] != CellState::Free || m_image.ids[i] == kClosed) return false;
        if (m_image.ids[i] == 0) {
            m_image.ids[i] = label;
            next.push_back(i);
        }
        return true;
    }

    const ClassifiedGrid& m_grid;
    PlaceImage& m_image;
    std::vector<std::size_t> m_front;
};

/** Opens the closed cells and lets the labels beside them in. */
void fillClosed(const ClassifiedGrid& grid, PlaceImage& image, const std::vector<Cell>& closed)
{
    for (const Cell c : closed)
        if (image.at(c) == kClosed) image.ids[image.index(c)] = 0;
    Spreading spreading(grid, image);
    for (const Cell c : closed)
        for (const Cell n : {Cell{c.x + 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x - 1, c.y}, Cell{c.x, c.y - 1}})
            if (grid.isFree(n) && image.at(n) != 0) spreading.start(image.index(n), image.at(n));
    spreading.run();
}

/** Gives unlabelled free cells the label that is nearest in a straight line. */
void fillUnreached(const ClassifiedGrid& grid, PlaceImage& image)
{
    const auto isUnreached = [&](std::size_t i) { return grid[i] == CellState::Free && image.ids[i] == 0; };
    bool any = false;
    for (std::size_t i = 0; i < grid.size() && !any; ++i) any = isUnreached(i);
    if (!any) return;
    ClassifiedGrid seeds(grid.width(), grid.height(), grid.frame());
    for (std::size_t i = 0; i < grid.size(); ++i)
        if (grid[i] == CellState::Free) seeds[i] = image.ids[i] ? CellState::Occupied : CellState::Free;
    NearestObstacles nearest;
    const DistanceMap distances = measureDistances(seeds, Obstacles::Occupied, &nearest);
    for (std::size_t i = 0; i < grid.size(); ++i)
        if (isUnreached(i) && distances.squared[i] != DistanceMap::unreachable())
            image.ids[i] = image.at(nearest.at(i));
}
}  // namespace

PlaceImage partition(const ClassifiedGrid& grid, const VoronoiGraph& voronoi,
                     const std::vector<PlaceId>& placeOfCell, const std::vector<Cell>& closed)
{
    PlaceImage image(grid.width(), grid.height());
    for (const Cell c : closed)
        if (grid.isFree(c)) image.ids[image.index(c)] = kClosed;
    Spreading spreading(grid, image);
    for (std::size_t k = 0; k < voronoi.cells.size(); ++k)
        if (placeOfCell[k] != 0 && image.ids[voronoi.cells[k]] == 0)
            spreading.start(voronoi.cells[k], placeOfCell[k]);
    spreading.run();
    fillClosed(grid, image, closed);
    fillUnreached(grid, image);
    return image;
}
}  // namespace gr2to
