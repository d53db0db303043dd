#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "gr2to/grid/PlaceImage.h"

namespace gr2to
{
/** A stretch of the border between two labels along the sides of cells, from node to node. */
struct LabelArc
{
    PlaceId left = 0;   //!< label of the cells on the left of the way from first to last point
    PlaceId right = 0;  //!< of those on the right; 0 where there is none, also beyond the image
    int from = -1;      //!< node that it starts at; -1: closed, without a node
    int to = -1;
    /** Its corners in continuous grid coordinates [cells], both ends included; of a closed arc the first is
     * repeated at the end. */
    std::vector<Eigen::Vector2d> points;

    bool isClosed() const { return from < 0; }
};

/** An arc as one of the two labels beside it sees it. */
struct HalfArc
{
    std::size_t arc = 0;
    bool reversed = false;  //!< the label is that on the arc's right
};

/** A closed curve of arcs with one label on its left. */
struct LabelRing
{
    PlaceId label = 0;
    std::vector<HalfArc> sides;
    /** That it encloses: positive around cells of its label, negative around a hole in them [cells]. */
    double area_cells = 0;
};

/** A label image as a planar subdivision: arcs that meet in nodes, every arc once for both of its labels. */
struct LabelArcs
{
    std::vector<Eigen::Vector2d> nodes;  //!< corners of cells where three or four labels meet [cells]
    std::vector<LabelArc> arcs;
    std::vector<LabelRing> rings;  //!< of all labels but 0, in the order of their first arcs
};

/** Area between a chain of points and the origin, positive where it turns left around it; summed over the
 * chains of a ring the area that it encloses. */
double areaBeside(const std::vector<Eigen::Vector2d>& chain);

/** Traces the borders of the labels of an image.
 *
 * Where two equal labels meet two others over a corner, as on a chequerboard, one equal pair is taken for
 * joined: that of label 0 (obstacles are 8-connected), else the only one, else the smaller label. Arcs then
 * cut a quarter of a cell off the corners of the other pair. So no ring touches itself or
 * another ring of the same label, and a ring passes a node only once. Cost: linear in the number of cells,
 * quick where neighbours are equal, and in that of cell sides between different labels.
 */
LabelArcs traceArcs(const PlaceImage& image);
}  // namespace gr2to
