#include "gr2to/grid/Partition.h"

#include <algorithm>

#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/Runs.h"

namespace gr2to
{
namespace
{
constexpr PlaceId kMixed =
    0xFFFF;  // no place has this id; stands for borders and for several places in one region

/** Gives each region of free cells between borders its place, when all of the diagram in it has the same.
 * \param image  kMixed on the borders, else 0
 */
void paintRegions(const ClassifiedGrid& grid, const VoronoiGraph& voronoi,
                  const std::vector<PlaceId>& placeOfCell, PlaceImage& image)
{
    Runs runs(grid.width(), grid.height(), Runs::Connectivity::Sides,
              [&](std::size_t i) { return grid[i] == CellState::Free && image.ids[i] == 0; });
    std::vector<PlaceId> placeOfRoot(runs.runs().size(), 0);
    for (std::size_t k = 0; k < voronoi.cells.size(); ++k) {
        const std::size_t run = placeOfCell[k] != 0 ? runs.find(voronoi.cells[k]) : placeOfRoot.size();
        if (run == placeOfRoot.size()) continue;
        PlaceId& place = placeOfRoot[runs.root(run)];
        place = place == 0 || place == placeOfCell[k] ? placeOfCell[k] : kMixed;
    }
    for (std::size_t r = 0; r < placeOfRoot.size(); ++r)
        if (const PlaceId place = placeOfRoot[runs.root(r)]; place != 0 && place != kMixed)
            std::fill(image.ids.begin() + runs.runs()[r].begin, image.ids.begin() + runs.runs()[r].end,
                      place);
}

/** Labels that spread over the unlabelled free cells, wave by wave: over sides and over corners in turn. */
void spread(const ClassifiedGrid& grid, PlaceImage& image, std::vector<Cell> front)
{
    std::vector<Cell> next;
    const auto enter = [&](Cell c, PlaceId label) {
        if (!grid.isFree(c)) return false;
        PlaceId& there = image.ids[image.index(c)];
        if (there == 0) {
            there = label;
            next.push_back(c);
        }
        return true;
    };
    for (bool overCorners = false; !front.empty(); overCorners = !overCorners) {
        next.clear();
        for (const Cell c : front) {
            const PlaceId label = image.at(c);
            const bool right = enter({c.x + 1, c.y}, label), left = enter({c.x - 1, c.y}, label);
            const bool up = enter({c.x, c.y + 1}, label), down = enter({c.x, c.y - 1}, label);
            if (!overCorners) continue;
            // Over a corner only past two free sides, so that no label slips through a diagonal wall.
            if (right && up) enter({c.x + 1, c.y + 1}, label);
            if (left && up) enter({c.x - 1, c.y + 1}, label);
            if (right && down) enter({c.x + 1, c.y - 1}, label);
            if (left && down) enter({c.x - 1, c.y - 1}, label);
        }
        front.swap(next);
    }
}

/** Indices of the free cells without a label, in raster order. */
std::vector<std::size_t> unlabelledCells(const ClassifiedGrid& grid, const PlaceImage& image)
{
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < grid.size(); ++i)
        if (grid[i] == CellState::Free && image.ids[i] == 0) cells.push_back(i);
    return cells;
}

/** Labelled cells beside unlabelled free ones, in raster order: where labels can spread from. */
std::vector<Cell> rimOfLabels(const ClassifiedGrid& grid, const PlaceImage& image,
                              const std::vector<std::size_t>& unlabelled)
{
    std::vector<std::size_t> rim;
    for (const std::size_t i : unlabelled) {
        const auto [x, y] = grid.cell(i);
        for (const Cell n : {Cell{x + 1, y}, Cell{x, y + 1}, Cell{x - 1, y}, Cell{x, y - 1}})
            if (grid.isFree(n) && image.at(n) != 0) rim.push_back(image.index(n));
    }
    std::sort(rim.begin(), rim.end());
    rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
    std::vector<Cell> cells;
    cells.reserve(rim.size());
    for (const std::size_t i : rim) cells.push_back(grid.cell(i));
    return cells;
}

/** Gives free cells that no label reaches the label that is nearest in a straight line, one for each patch of
 * them. */
class PatchFiller
{
 public:
    PatchFiller(const ClassifiedGrid& grid, PlaceImage& image)
        : m_grid(grid), m_image(image), m_budget(grid.size() / 2)
    {
    }

    /** \param unlabelled  free cells, some of which may have got a label since */
    void fill(const std::vector<std::size_t>& unlabelled)
    {
        for (const std::size_t i : unlabelled) {
            if (m_image.ids[i] != 0) continue;
            const PlaceId nearest = nearestLabel(m_grid.cell(i));
            if (nearest == 0) return fillAllAtOnce();
            m_image.ids[i] = nearest;
            spread(m_grid, m_image, {m_grid.cell(i)});
        }
    }

 private:
    /** Searches square rings around a cell; 0 when there is no label or the budget of looks is spent. */
    PlaceId nearestLabel(Cell center)
    {
        PlaceId best = 0;
        std::int64_t bestSquared = INT64_MAX;
        const auto look = [&](Cell c) {
            if (!m_grid.contains(c) || m_image.at(c) == 0) return;
            const std::int64_t dx = c.x - center.x, dy = c.y - center.y;
            if (dx * dx + dy * dy >= bestSquared) return;
            bestSquared = dx * dx + dy * dy;
            best = m_image.at(c);
        };
        const int farthest = std::max(m_grid.width(), m_grid.height());
        for (int r = 1; r <= farthest && std::int64_t{r} * r < bestSquared; ++r) {
            const std::size_t looks = 8 * static_cast<std::size_t>(r);
            if (looks > m_budget) return 0;
            m_budget -= looks;
            for (int k = -r; k < r; ++k) {
                look({center.x + k, center.y - r});
                look({center.x + r, center.y + k});
                look({center.x - k, center.y + r});
                look({center.x - r, center.y - k});
            }
        }
        return best;
    }

    /** For far-off patches, linear in the number of cells however many there are. */
    void fillAllAtOnce()
    {
        ClassifiedGrid seeds(m_grid.width(), m_grid.height(), m_grid.frame());
        for (std::size_t i = 0; i < m_grid.size(); ++i)
            if (m_grid[i] == CellState::Free)
                seeds[i] = m_image.ids[i] ? CellState::Occupied : CellState::Free;
        DistanceMap distances;
        measureDistances(seeds, Obstacles::Occupied, distances, [&](int y, const std::uint32_t* nearest) {
            const std::size_t row = m_grid.index({0, y});
            for (std::size_t x = 0; x < static_cast<std::size_t>(m_grid.width()); ++x)
                if (seeds[row + x] == CellState::Free &&
                    distances.squared[row + x] != DistanceMap::unreachable())
                    m_image.ids[row + x] = m_image.at(unpackCell(nearest[x]));
        });
    }

    const ClassifiedGrid& m_grid;
    PlaceImage& m_image;
    std::size_t m_budget;  //!< cells that may still be looked at, so that the search stays linear
};
}  // namespace

PlaceImage partition(const ClassifiedGrid& grid, const VoronoiGraph& voronoi,
                     const std::vector<PlaceId>& placeOfCell, const std::vector<Cell>& borders)
{
    PlaceImage image(grid.width(), grid.height());
    for (const Cell c : borders) image.ids[image.index(c)] = kMixed;
    paintRegions(grid, voronoi, placeOfCell, image);
    for (const Cell c : borders) image.ids[image.index(c)] = 0;
    std::vector<Cell> front;  // in mixed regions the diagram's own labels spread
    for (std::size_t k = 0; k < voronoi.cells.size(); ++k)
        if (PlaceId& there = image.ids[voronoi.cells[k]]; there == 0 && placeOfCell[k] != 0) {
            there = placeOfCell[k];
            front.push_back(grid.cell(voronoi.cells[k]));
        }
    spread(grid, image, std::move(front));
    fillUnlabelled(grid, image);
    return image;
}

void fillUnlabelled(const ClassifiedGrid& grid, PlaceImage& image)
{
    const std::vector<std::size_t> unlabelled = unlabelledCells(grid, image);
    spread(grid, image, rimOfLabels(grid, image, unlabelled));
    PatchFiller(grid, image).fill(unlabelled);
}
}  // namespace gr2to
