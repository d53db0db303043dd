#pragma once

#include <string>
#include <vector>

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/PlaceImage.h"
#include "gr2to/grid/VoronoiGraph.h"
#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
/** What an overlay is drawn from; the referenced objects must outlive it. */
struct OverlayInput
{
    const ClassifiedGrid& grid;
    const PlaceImage& places;  //!< of the grid's size, or empty when there are no places
    const VoronoiGraph& voronoi;
    const std::vector<CriticalPoint>& criticalPoints;
    const TopologicalMap& map;
};

/** What an overlay shows and how large.
 *
 * Widths and text sizes are in pixels of a picture whose longer side has 1000 of them and grow with the
 * picture, so that it looks the same when it is shown at any one size.
 */
struct TOverlayOptions : OptionTable
{
    bool grid = true;             //!< occupied and unknown cells
    bool places = true;           //!< a tint a place; corridors are hatched
    bool removed = true;          //!< what the filter took away: cells of places that are not free
    bool ids = true;              //!< number of each place
    bool voronoi = true;          //!< Voronoi diagram
    bool critical_points = true;  //!< where its clearance is least
    bool doors = true;            //!< real doors as bars, virtual openings dashed
    bool walls = true;            //!< real walls solid, virtual ones dashed
    bool connections = true;      //!< lines from place to doorway to place
    bool legend = true;           //!< below the map
    bool scale_bar = true;        //!< below the map

    bool crop = true;  //!< leave out surroundings of which nothing is known, but for a narrow margin
    int min_side =
        1000;  //!< the longer side has at least these pixels: small grids are enlarged by a whole factor
    int max_side =
        2400;  //!< and at most these: large grids are reduced by a whole factor; without the legend

    double wall_width = 2.2;
    double door_width = 5.0;
    double voronoi_width = 1.3;
    double connection_width = 1.3;
    double point_size = 7.0;  //!< diameter of critical points and place vertices
    double text_size = 22.0;  //!< largest height of an id; smaller in small places

    std::string section() const override { return "overlay"; }
    std::vector<OptionField> fields() override;

 protected:
    void checkRules() const override;
};

/** The overlay as the bytes of a PNG file: the grid with everything that was found in it, as in figs. 2-5 of
 * the paper.
 *
 * The picture is aligned with the grid, whatever the yaw of the frame: columns run to the right, rows
 * upwards. Without `crop` its left edge is column 0 and its top edge the highest row. Cells that are pooled
 * into one pixel are occupied when any of them is, so that thin walls survive. The legend and the scale bar
 * lie in a strip below the map. Text is in cairo's built-in line font, so no fonts are needed. Same input and
 * options, same bytes.
 *
 * \throws InputError             the grid is empty
 * \throws std::invalid_argument  an option is out of range, or the place image has not the grid's size
 * \throws OutputError            the picture could not be made, for example for want of memory
 * Cost: one pass over the cells, plus the picture.
 */
std::string renderOverlayPng(const OverlayInput& input, const TOverlayOptions& options = {});

/** The same picture as the bytes of an SVG file, one unit a pixel: cells are an embedded image, all else is
 * lines.
 *
 * \throws InputError, std::invalid_argument, OutputError  as renderOverlayPng()
 */
std::string renderOverlaySvg(const OverlayInput& input, const TOverlayOptions& options = {});
}  // namespace gr2to
