#include "gr2to/compare/ContingencyTable.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>

#include "gr2to/base/errors.h"

namespace gr2to
{
namespace
{
constexpr std::size_t kIds = std::size_t{std::numeric_limits<PlaceId>::max()} + 1;

/** Both labels of a cell in one number, ordered by segment, then room. */
using PairKey = std::uint32_t;
using PairCounts = std::vector<std::pair<PairKey, std::size_t>>;

PairKey keyOf(PlaceId segment, PlaceId room)
{
    return (PairKey{segment} << 16U) | room;
}
PlaceId segmentOf(PairKey key)
{
    return static_cast<PlaceId>(key >> 16U);
}
PlaceId roomOf(PairKey key)
{
    return static_cast<PlaceId>(key & 0xFFFFU);
}

std::string sizeText(int width, int height)
{
    return std::to_string(width) + " x " + std::to_string(height);
}

/** Counts the pairs of labels; neighbours mostly agree, so runs are counted before they are looked up. */
PairCounts countPairs(const PlaceImage& segments, const PlaceImage& rooms, const ClassifiedGrid* grid)
{
    std::unordered_map<PairKey, std::size_t> counts;
    PairKey runKey = 0;
    std::size_t run = 0;
    for (std::size_t i = 0; i < segments.ids.size(); ++i) {
        if (grid && (*grid)[i] != CellState::Free) continue;
        const PairKey key = keyOf(segments.ids[i], rooms.ids[i]);
        if (key != runKey) {
            if (run > 0) counts[runKey] += run;
            runKey = key;
            run = 0;
        }
        ++run;
    }
    if (run > 0) counts[runKey] += run;
    PairCounts sorted(counts.begin(), counts.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

std::vector<ContingencyTable::Region> regionsOf(const std::vector<std::size_t>& cellsOfId)
{
    std::vector<ContingencyTable::Region> regions;
    for (std::size_t id = 1; id < cellsOfId.size(); ++id)
        if (cellsOfId[id] > 0) regions.push_back({static_cast<PlaceId>(id), cellsOfId[id]});
    return regions;
}

std::vector<std::size_t> indexOfId(const std::vector<ContingencyTable::Region>& regions)
{
    std::vector<std::size_t> index(kIds, 0);
    for (std::size_t i = 0; i < regions.size(); ++i) index[regions[i].id] = i;
    return index;
}
}  // namespace

ContingencyTable::ContingencyTable(const PlaceImage& segments, const PlaceImage& rooms,
                                   const ClassifiedGrid* freeCellsOf)
{
    if (segments.width != rooms.width || segments.height != rooms.height)
        throw InputError("the map has " + sizeText(segments.width, segments.height) +
                         " cells, the reference " + sizeText(rooms.width, rooms.height) +
                         "; they must be of the same grid");
    if (freeCellsOf && (freeCellsOf->width() != rooms.width || freeCellsOf->height() != rooms.height))
        throw InputError("the grid has " + sizeText(freeCellsOf->width(), freeCellsOf->height()) +
                         " cells, the reference " + sizeText(rooms.width, rooms.height) +
                         "; they must be of the same grid");
    const PairCounts counts = countPairs(segments, rooms, freeCellsOf);
    std::vector<std::size_t> segmentCells(kIds, 0), roomCells(kIds, 0);
    for (const auto& [key, cells] : counts) {
        segmentCells[segmentOf(key)] += cells;
        roomCells[roomOf(key)] += cells;
        m_counted += cells;
        if (segmentOf(key) != 0) m_inSegments += cells;
        if (key != 0) m_labelled += cells;
    }
    m_segments = regionsOf(segmentCells);
    m_rooms = regionsOf(roomCells);
    const auto segmentIndex = indexOfId(m_segments), roomIndex = indexOfId(m_rooms);
    for (const auto& [key, cells] : counts)
        if (segmentOf(key) != 0 && roomOf(key) != 0)
            m_overlaps.push_back({segmentIndex[segmentOf(key)], roomIndex[roomOf(key)], cells});
}
}  // namespace gr2to
