#include "Canvas.h"

#include <cmath>

#include "gr2to/base/errors.h"

namespace gr2to::view
{
namespace
{
constexpr double kFullTurn_rad = 6.283185307179586;
// Cairo's own line font: the same letters on every machine, whatever fonts are installed, and none at all
// needed.
constexpr int kHaloCopies = 12;
constexpr const char* kBuiltInFont = "@cairo:";
}  // namespace

Canvas::Canvas(cairo_surface_t* surface) : m_context(cairo_create(surface))
{
    if (const auto status = cairo_status(context()); status != CAIRO_STATUS_SUCCESS)
        throw OutputError(std::string("cannot draw the overlay: ") + cairo_status_to_string(status));
    cairo_set_line_cap(context(), CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(context(), CAIRO_LINE_JOIN_ROUND);
}

void Canvas::setColor(Rgb color, double opacity)
{
    cairo_set_source_rgba(context(), color.red / 255.0, color.green / 255.0, color.blue / 255.0, opacity);
}

void Canvas::stroke(Rgb color, double width_px, double dash_px, double opacity)
{
    setColor(color, opacity);
    cairo_set_line_width(context(), width_px);
    if (dash_px > 0) cairo_set_dash(context(), &dash_px, 1, 0.0);
    cairo_stroke(context());
    if (dash_px > 0) cairo_set_dash(context(), nullptr, 0, 0.0);
}

void Canvas::strokeAndKeep(Rgb color, double width_px)
{
    setColor(color);
    cairo_set_line_width(context(), width_px);
    cairo_stroke_preserve(context());
}

void Canvas::line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Rgb color, double width_px,
                  double dash_px)
{
    moveTo(a);
    lineTo(b);
    stroke(color, width_px, dash_px);
}

void Canvas::dot(const Eigen::Vector2d& center, double diameter_px, Rgb fill, Rgb outline, double outline_px)
{
    cairo_new_path(context());
    cairo_arc(context(), center.x(), center.y(), diameter_px / 2, 0, kFullTurn_rad);
    setColor(fill);
    cairo_fill_preserve(context());
    stroke(outline, outline_px);
}

void Canvas::setTextSize(double size_px, bool bold)
{
    cairo_select_font_face(context(), kBuiltInFont, CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context(), size_px);
}

double Canvas::textWidth(const std::string& text)
{
    cairo_text_extents_t extents;
    cairo_text_extents(context(), text.c_str(), &extents);
    return extents.x_advance;
}

void Canvas::text(const Eigen::Vector2d& p, const std::string& text, Rgb color, double halo_px)
{
    const auto show = [&](const Eigen::Vector2d& at) {
        moveTo(at);
        cairo_show_text(context(), text.c_str());
    };
    if (halo_px > 0) {
        // Shifted copies share the font's glyphs; outlines of the text would make up most of an SVG file.
        setColor(palette::halo);
        for (int i = 0; i < kHaloCopies; ++i) {
            const double angle = kFullTurn_rad * i / kHaloCopies;
            show(p + halo_px * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
        }
    }
    setColor(color);
    show(p);
}
}  // namespace gr2to::view
