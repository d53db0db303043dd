#pragma once

#include "Canvas.h"
#include "Layout.h"
#include "gr2to/view/Overlay.h"

namespace gr2to::view
{
/** Length of dashes [px of a picture of nominal size], here and in the legend. */
inline constexpr double kDash = 6.0;
/** Diameter of a place's vertex, of a critical point's. */
inline constexpr double kVertexShare = 1.2;

/** Draws every layer over the cells that its switch asks for, from the bottom: Voronoi diagram, walls,
 * connections, doors, critical points, vertices. */
void drawLines(Canvas& canvas, const OverlayInput& input, const TOverlayOptions& options,
               const Layout& layout);

/** Signs, shared with the legend. Positions and sizes in picture pixels. */
void drawRealDoor(Canvas& canvas, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double width_px);
void drawVirtualOpening(Canvas& canvas, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double width_px,
                        double dash_px);
void drawWall(Canvas& canvas, const Eigen::Vector2d& a, const Eigen::Vector2d& b, bool real, double width_px,
              double dash_px);
void drawCriticalPoint(Canvas& canvas, const Eigen::Vector2d& p, double size_px);
void drawVertex(Canvas& canvas, const Eigen::Vector2d& p, double size_px);
}  // namespace gr2to::view
