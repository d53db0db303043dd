#pragma once

#include <cairo.h>

#include <Eigen/Core>
#include <memory>
#include <string>

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/view/Palette.h"

namespace gr2to::view
{
struct SurfaceDeleter
{
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;

/** Where the map lies in the picture. A grid is enlarged or reduced by a whole factor, so that cells stay square. */
struct Layout
{
    int enlarge = 1;   //!< picture pixels a cell
    int reduce = 1;    //!< cells a picture pixel; 1 when enlarge > 1
    int gridWidth = 0, gridHeight = 0;  //!< [cells]
    int mapWidth = 0, mapHeight = 0;    //!< of the map's part of the picture, from its top [px]
    int mapLeft = 0;                    //!< of the map's part [px]; above 0 when the legend is wider than the map
    double unit = 1;   //!< pixels that make one pixel of a picture of nominal size

    /** \param minSide, maxSide  bounds on the longer side of the map's part [px] */
    static Layout of(const ClassifiedGrid& grid, int minSide, int maxSide);

    double pixelsPerCell() const { return static_cast<double>(enlarge) / reduce; }
    /** Picture position [px, y down] of continuous grid coordinates [cells, y up]. */
    Eigen::Vector2d toPicture(double column, double row) const;
    Eigen::Vector2d toPicture(const Eigen::Vector2d& p) const { return toPicture(p.x(), p.y()); }
};

/** A cairo context with the few verbs that the overlay needs. Positions and widths in picture pixels. */
class Canvas
{
   public:
    /** \throws OutputError  cairo has no memory for it */
    explicit Canvas(cairo_surface_t* surface);

    cairo_t* context() const { return m_context.get(); }

    void setColor(Rgb color, double opacity = 1.0);
    void moveTo(const Eigen::Vector2d& p) { cairo_move_to(context(), p.x(), p.y()); }
    void lineTo(const Eigen::Vector2d& p) { cairo_line_to(context(), p.x(), p.y()); }
    /** Draws the current path; `dash_px` of 0 is a solid line. */
    void stroke(Rgb color, double width_px, double dash_px = 0.0, double opacity = 1.0);
    /** As stroke() and keeps the path for another one. */
    void strokeAndKeep(Rgb color, double width_px);
    void line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Rgb color, double width_px, double dash_px = 0.0);
    /** A filled circle with an outline. */
    void dot(const Eigen::Vector2d& center, double diameter_px, Rgb fill, Rgb outline, double outline_px);
    void setTextSize(double size_px, bool bold);
    /** Width of a text [px] at the current size. */
    double textWidth(const std::string& text);
    /** Text with its baseline's left end at `p`; a halo of 0 is none. */
    void text(const Eigen::Vector2d& p, const std::string& text, Rgb color, double halo_px = 0.0);

   private:
    struct ContextDeleter
    {
        void operator()(cairo_t* context) const { cairo_destroy(context); }
    };
    std::unique_ptr<cairo_t, ContextDeleter> m_context;
};
}  // namespace gr2to::view
