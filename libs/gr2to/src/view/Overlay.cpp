#include "gr2to/view/Overlay.h"

#include <cairo-svg.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "Canvas.h"
#include "OverlayLabels.h"
#include "OverlayLayers.h"
#include "OverlayLegend.h"
#include "OverlayRaster.h"
#include "gr2to/base/errors.h"
#include "svgIds.h"

namespace gr2to
{
namespace
{
using view::Canvas;
using view::Layout;
using view::Raster;
using view::Surface;

/** The picture's measures [px]. */
struct Sheet
{
    Layout layout;
    int width = 0;
    int height = 0;
};

void checkInput(const OverlayInput& input)
{
    if (input.grid.empty())
        throw InputError("the overlay's grid has no cells; give it the grid that was processed");
    const bool hasPlaces = !input.places.ids.empty();
    if (hasPlaces && (input.places.width != input.grid.width() || input.places.height != input.grid.height()))
        throw std::invalid_argument("the overlay's place image has " + std::to_string(input.places.width) +
                                    " x " + std::to_string(input.places.height) + " cells, its grid " +
                                    std::to_string(input.grid.width()) + " x " +
                                    std::to_string(input.grid.height()) + "; they must agree");
}

void checkCairo(cairo_status_t status)
{
    if (status != CAIRO_STATUS_SUCCESS)
        throw OutputError(std::string("cannot draw the overlay: ") + cairo_status_to_string(status));
}

Sheet layOut(const OverlayInput& input, const TOverlayOptions& options)
{
    Sheet sheet;
    const view::CellWindow whole{0, 0, input.grid.width(), input.grid.height()};
    const view::CellWindow window = options.crop ? view::knownWindow(input.grid) : whole;
    sheet.layout = Layout::of(window, options.min_side, options.max_side);
    const double width = view::placeMap(sheet.layout, options);
    const double strip = view::stripHeight(input, options, sheet.layout, width);
    sheet.width = static_cast<int>(width);
    sheet.height = sheet.layout.mapHeight + static_cast<int>(strip);
    return sheet;
}

Surface imageOf(const Raster& raster)
{
    Surface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24, raster.width, raster.height));
    checkCairo(cairo_surface_status(image.get()));
    unsigned char* out = cairo_image_surface_get_data(image.get());
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image.get()));
    const auto width = static_cast<std::size_t>(raster.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(raster.height); ++y)
        std::memcpy(out + y * stride, raster.pixels.data() + y * width, width * sizeof(std::uint32_t));
    cairo_surface_mark_dirty(image.get());
    return image;
}

void drawSheet(cairo_surface_t* surface, const OverlayInput& input, const TOverlayOptions& options,
               const Sheet& sheet)
{
    const Layout& layout = sheet.layout;
    Canvas canvas(surface);
    canvas.setColor(palette::halo);
    cairo_paint(canvas.context());
    const Surface cells = imageOf(view::drawCells(input, options, layout));
    cairo_set_source_surface(canvas.context(), cells.get(), layout.mapLeft, 0);
    cairo_pattern_set_filter(cairo_get_source(canvas.context()), CAIRO_FILTER_NEAREST);
    cairo_paint(canvas.context());
    view::drawLines(canvas, input, options, layout);
    if (options.ids) view::drawIds(canvas, input, options, layout);
    view::drawStrip(canvas, input, options, layout, sheet.width);
    checkCairo(cairo_status(canvas.context()));
}

/** Cairo's way out for bytes; an exception must not cross its C code. */
cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length)
{
    try {
        static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
        return CAIRO_STATUS_SUCCESS;
    } catch (const std::bad_alloc&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
}
}  // namespace

std::vector<OptionField> TOverlayOptions::fields()
{
    return {
        {"grid", &grid, "", "Draw occupied and unknown cells."},
        {"places", &places, "", "Tint the places; corridors are hatched."},
        {"removed", &removed, "", "Show what the filter took out of the grid in a colour of its own."},
        {"ids", &ids, "", "Write the places' ids."},
        {"voronoi", &voronoi, "", "Draw the Voronoi diagram."},
        {"critical_points", &critical_points, "", "Mark the critical points."},
        {"doors", &doors, "", "Draw doors as bars and virtual openings dashed."},
        {"walls", &walls, "", "Draw real walls solid and virtual ones dashed."},
        {"connections", &connections, "", "Draw places as vertices and the connections between them."},
        {"legend", &legend, "", "Explain the signs below the map."},
        {"scale_bar", &scale_bar, "", "Draw a scale bar below the map."},
        {"crop", &crop, "", "Leave out surroundings of which nothing is known."},
        {"min_side", &min_side, "px", "Least length of the longer side; small grids are enlarged.", 1, 16000},
        {"max_side", &max_side, "px", "Greatest length of the longer side; large grids are reduced.", 100,
         16000},
        {"wall_width", &wall_width, "px", "Width of walls in a picture of 1000 px.", 0.1, 50},
        {"door_width", &door_width, "px", "Thickness of doors in a picture of 1000 px.", 0.1, 50},
        {"voronoi_width", &voronoi_width, "px", "Width of the Voronoi diagram in a picture of 1000 px.", 0.1,
         50},
        {"connection_width", &connection_width, "px", "Width of connections in a picture of 1000 px.", 0.1,
         50},
        {"point_size", &point_size, "px", "Diameter of points in a picture of 1000 px.", 0.1, 100},
        {"text_size", &text_size, "px", "Largest height of ids in a picture of 1000 px.", 1, 200}};
}

void TOverlayOptions::checkRules() const
{
    if (min_side > max_side)
        throw std::invalid_argument("overlay.min_side = " + std::to_string(min_side) +
                                    " px must not exceed overlay.max_side = " + std::to_string(max_side) +
                                    " px");
}

std::string renderOverlayPng(const OverlayInput& input, const TOverlayOptions& options)
{
    options.check();
    checkInput(input);
    const Sheet sheet = layOut(input, options);
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, sheet.width, sheet.height));
    drawSheet(surface.get(), input, options, sheet);
    std::string bytes;
    checkCairo(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
    return bytes;
}

std::string renderOverlaySvg(const OverlayInput& input, const TOverlayOptions& options)
{
    options.check();
    checkInput(input);
    const Sheet sheet = layOut(input, options);
    std::string bytes;
    const Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, sheet.width, sheet.height));
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
    drawSheet(surface.get(), input, options, sheet);
    cairo_surface_finish(surface.get());
    checkCairo(cairo_surface_status(surface.get()));
    return view::withNumberedIds(bytes);
}
}  // namespace gr2to
