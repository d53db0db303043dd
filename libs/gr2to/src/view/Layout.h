#pragma once

#include <Eigen/Core>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to::view
{
/** A rectangle of cells. */
struct CellWindow
{
    int left = 0, bottom = 0, width = 0, height = 0;
};

/** The cells that are not unknown, with a margin of a fiftieth of the longer side; the whole grid when there
 * are none. */
CellWindow knownWindow(const ClassifiedGrid& grid);

/** Where the map lies in the picture. A grid is enlarged or reduced by a whole factor, so that cells stay
 * square. */
struct Layout
{
    CellWindow window;  //!< the cells that are shown
    int enlarge = 1;    //!< picture pixels a cell
    int reduce = 1;     //!< cells a picture pixel; 1 when enlarge > 1
    int mapWidth = 0;   //!< of the map's part of the picture [px]
    int mapHeight = 0;  //!< of the map's part of the picture, from its top [px]
    int mapLeft = 0;    //!< of the map's part [px]; above 0 when the legend is wider than the map
    double unit = 1;    //!< pixels that make one pixel of a picture of nominal size

    /** \param minSide, maxSide  bounds on the longer side of the map's part [px] */
    static Layout of(const CellWindow& window, int minSide, int maxSide);

    double pixelsPerCell() const { return static_cast<double>(enlarge) / reduce; }
    /** Picture position [px, y down] of continuous grid coordinates [cells, y up]. */
    Eigen::Vector2d toPicture(double column, double row) const;
    Eigen::Vector2d toPicture(const Eigen::Vector2d& p) const { return toPicture(p.x(), p.y()); }
};
}  // namespace gr2to::view
