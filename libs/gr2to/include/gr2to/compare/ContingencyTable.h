#pragma once

#include <cstddef>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/PlaceImage.h"

namespace gr2to
{
/** How the labels of two images of the same cells overlap: segments (the answer) against rooms (the
 * reference).
 *
 * Only overlaps that occur are stored, so tens of thousands of labels on either side cost no more than the
 * cells do.
 */
class ContingencyTable
{
 public:
    /** A label that occurs; its index in segments() or rooms() is how overlaps refer to it. */
    struct Region
    {
        PlaceId id = 0;
        std::size_t cells = 0;  //!< all its cells, labelled in the other image or not
    };
    struct Overlap
    {
        std::size_t segment = 0;  //!< index into segments()
        std::size_t room = 0;     //!< index into rooms()
        std::size_t cells = 0;    //!< at least 1
    };

    /** Counts every cell or, with a grid, only its free cells; 0 is no label in both images.
     * \throws InputError  the sizes differ
     */
    ContingencyTable(const PlaceImage& segments, const PlaceImage& rooms,
                     const ClassifiedGrid* freeCellsOf = nullptr);

    const std::vector<Region>& segments() const { return m_segments; }   //!< by ascending id
    const std::vector<Region>& rooms() const { return m_rooms; }         //!< by ascending id
    const std::vector<Overlap>& overlaps() const { return m_overlaps; }  //!< by segment, then room
    std::size_t countedCells() const { return m_counted; }               //!< labelled or not
    std::size_t segmentCells() const { return m_inSegments; }            //!< labelled in the answer
    std::size_t labelledCells() const { return m_labelled; }             //!< labelled in either image

 private:
    std::vector<Region> m_segments;
    std::vector<Region> m_rooms;
    std::vector<Overlap> m_overlaps;
    std::size_t m_counted = 0;
    std::size_t m_inSegments = 0;
    std::size_t m_labelled = 0;
};
}  // namespace gr2to
