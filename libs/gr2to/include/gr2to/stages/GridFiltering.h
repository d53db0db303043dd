#pragma once

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/WallSegments.h"

namespace gr2to
{
struct TFilterOptions : OptionTable
{
    double max_blob_area = 2;
    double min_wall = 1;
    double min_aligned_wall = 0.7;
    double max_wall_thickness = 0.7;
    double max_lone_thickness = 0.3;

    std::string section() const override { return "filter"; }
    std::vector<OptionField> fields() override;
};

/** What the filter makes. */
struct FilteredGrid
{
    ClassifiedGrid grid;
    std::size_t blobs = 0;  //!< how many were removed
    std::size_t cells = 0;  //!< how many cells they had
};

/** First stage on 2D input: takes free-standing things out of the grid, which delimit no place.
 *
 * A blob is an 8-connected patch of cells that are not free, all around it free cells. One of less than
 * `max_blob_area` becomes free: table and chair legs, bins, people, pillars; what touches a wall or the
 * unknown surroundings stays, and so do pieces of wall. Source: Gr2To paper, section 4, first stage
 * ("Compression ... and Filtering").
 */
class GridFilter
{
 public:
    /** \throws std::invalid_argument  an option is out of range */
    explicit GridFilter(TFilterOptions options);

    /** \param segments  straight walls: a blob that holds one of `min_wall` or more, no thicker than
     * `max_lone_thickness`, stays, being a piece of wall, and so does one that holds one of
     * `min_aligned_wall`, no thicker than `max_wall_thickness`, in line with a wall or another piece
     * \param directions  that the segments run in
     * Cost: one pass over the cells. */
    FilteredGrid filter(const ClassifiedGrid& grid, const std::vector<WallSegment>& segments = {},
                        const std::vector<LineDirection>& directions = {}) const;

 private:
    TFilterOptions m_options;
};
}  // namespace gr2to
