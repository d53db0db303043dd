#pragma once

#include <cairo.h>

#include <Eigen/Core>
#include <memory>
#include <string>

#include "gr2to/view/Palette.h"

namespace gr2to::view
{
struct SurfaceDeleter
{
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;

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
    void line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Rgb color, double width_px,
              double dash_px = 0.0);
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
