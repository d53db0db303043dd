#include "gr2to/view/Scene3D.h"

#include <cairo.h>
#include <mrpt/opengl/CFBORender.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "Canvas.h"
#include "gr2to/base/errors.h"

namespace gr2to
{
namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr float kFieldOfView_deg = 30;
constexpr double kMargin = 1.1;  // of what the camera sees around the map

struct Extent
{
    mrpt::math::TPoint2D min{0, 0};
    mrpt::math::TPoint2D max{1, 1};
    double floor_m = 0;
};

Extent extentOf(const TopologicalMap& map)
{
    Extent extent;
    bool first = true;
    for (const auto& [id, place] : map.places())
        for (const auto& p : place.boundary) {
            if (first) extent = {p, p, place.center.z};
            first = false;
            extent.min = {std::min(extent.min.x, p.x), std::min(extent.min.y, p.y)};
            extent.max = {std::max(extent.max.x, p.x), std::max(extent.max.y, p.y)};
        }
    return extent;
}

/** Puts the camera where it sees the whole extent, and the clipping planes close around it: far ones cost
 * depth precision. */
void aimCamera(mrpt::opengl::COpenGLScene& scene, const Extent& extent, const TSceneOptions& options)
{
    const double azimuth = options.azimuth * kPi / 180, elevation = options.elevation * kPi / 180;
    const double dx = extent.max.x - extent.min.x, dy = extent.max.y - extent.min.y;
    const double wide = std::abs(dx * std::sin(azimuth)) + std::abs(dy * std::cos(azimuth));
    const double deep = std::abs(dx * std::cos(azimuth)) + std::abs(dy * std::sin(azimuth));
    const double tall = deep * std::sin(elevation) + options.graph_height * std::cos(elevation);
    const double tangent = std::tan(static_cast<double>(kFieldOfView_deg) / 2 * kPi / 180);
    const double aspect = static_cast<double>(options.width) / options.height;
    const double distance =
        kMargin * std::max(tall, wide / aspect) / 2 / tangent + deep / 2 * std::cos(elevation);
    auto viewport = scene.getViewport();
    auto& camera = viewport->getCamera();
    camera.setProjectiveModel(true);
    camera.setProjectiveFOVdeg(kFieldOfView_deg);
    const mrpt::math::TPoint2D middle = (extent.min + extent.max) * 0.5;
    camera.setPointingAt(static_cast<float>(middle.x), static_cast<float>(middle.y),
                         static_cast<float>(extent.floor_m));
    camera.setAzimuthDegrees(static_cast<float>(options.azimuth));
    camera.setElevationDegrees(static_cast<float>(options.elevation));
    camera.setZoomDistance(static_cast<float>(distance));
    const double reach = std::hypot(dx, dy) / 2 + 2 * options.graph_height;
    viewport->setViewportClipDistances(static_cast<float>(std::max(0.1, distance - reach)),
                                       static_cast<float>(distance + reach));
    viewport->setCustomBackgroundColor({1.0F, 1.0F, 1.0F});
}

/** Mostly light from everywhere: the colours of places have to be told apart on whatever side they are seen.
 */
void light(mrpt::opengl::COpenGLViewport& viewport)
{
    constexpr float fromAround = 0.6F, fromAbove = 0.45F;
    auto& lights = viewport.lightParameters();
    lights.ambient = {fromAround, fromAround, fromAround, 1.0F};
    lights.diffuse = {fromAbove, fromAbove, fromAbove, 1.0F};
    lights.specular = {0.0F, 0.0F, 0.0F, 1.0F};
}

std::string encodePng(const mrpt::img::CImage& image)
{
    const auto width = static_cast<int>(image.getWidth()), height = static_cast<int>(image.getHeight());
    const view::Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
        throw OutputError("no memory for a picture of " + std::to_string(width) + " x " +
                          std::to_string(height));
    cairo_surface_flush(surface.get());
    const bool blueFirst = image.getChannelsOrder() == "BGR";
    unsigned char* const data = cairo_image_surface_get_data(surface.get());
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        const auto* in = image.ptrLine<std::uint8_t>(static_cast<unsigned>(y));
        unsigned char* out =
            data + y * stride;  // blue, green, red, unused: 32-bit words of a little-endian machine
        for (int x = 0; x < width; ++x, in += 3, out += 4) {
            out[0] = in[blueFirst ? 0 : 2];
            out[1] = in[1];
            out[2] = in[blueFirst ? 2 : 0];
        }
    }
    cairo_surface_mark_dirty(surface.get());
    std::string bytes;
    const auto append = [](void* to, const unsigned char* from, unsigned size) {
        static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(from), size);
        return CAIRO_STATUS_SUCCESS;
    };
    if (cairo_surface_write_to_png_stream(surface.get(), append, &bytes) != CAIRO_STATUS_SUCCESS)
        throw OutputError("no memory to encode a picture");
    return bytes;
}
}  // namespace

std::vector<OptionField> TSceneOptions::fields()
{
    return {{"wall_height", &wall_height, "m", "Height of walls that was not measured.", 0.1, 100},
            {"wall_opacity", &wall_opacity, "ratio", "How far walls hide what is behind them; 1 does wholly.",
             0.05, 1},
            {"door_height", &door_height, "m", "Height of doors that was not measured.", 0.1, 100},
            {"graph", &graph, "", "Draw places and connections as a graph above the walls."},
            {"graph_height", &graph_height, "m", "Height of that graph above the floor.", 0, 100},
            {"azimuth", &azimuth, "deg",
             "Where the eye is, seen from the map's middle, counter-clockwise from the x axis.", -360, 360},
            {"elevation", &elevation, "deg", "How high the eye is above the floor; 90 looks straight down.",
             5, 90},
            {"width", &width, "px", "Width of a picture.", 16, 16384},
            {"height", &height, "px", "Height of a picture.", 16, 16384}};
}

mrpt::opengl::COpenGLScene::Ptr makeScene(const TopologicalMap& map, const TSceneOptions& options)
{
    auto scene = mrpt::opengl::COpenGLScene::Create();
    scene->insert(drawMap(map, options));
    aimCamera(*scene, extentOf(map), options);
    light(*scene->getViewport());
    return scene;
}

std::string renderPng(const mrpt::opengl::COpenGLScene& scene, const TSceneOptions& options)
{
    options.check();
    mrpt::img::CImage picture;
    try {
        mrpt::opengl::CFBORender renderer(static_cast<unsigned>(options.width),
                                          static_cast<unsigned>(options.height));
        renderer.setCamera(scene, scene.getViewport()->getCamera());
        renderer.render_RGB(scene, picture);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw OutputError(
            "no off-screen OpenGL context (EGL) can be had; install libegl-mesa0, or write a 3Dscene: " +
            std::string(error.what()));
    }
    return encodePng(picture);
}
}  // namespace gr2to
