#pragma once

#include "Canvas.h"
#include "Layout.h"
#include "gr2to/view/Overlay.h"

namespace gr2to::view
{
/** Sets `mapLeft` for the picture's width and returns that width [px]: the map's, or what the legend needs at
 * least. */
double placeMap(Layout& layout, const TOverlayOptions& options);

/** Height [px] of the strip below the map; 0 when neither legend nor scale bar are wanted. */
double stripHeight(const OverlayInput& input, const TOverlayOptions& options, const Layout& layout,
                   double pictureWidth_px);

/** Draws the scale bar and one sign for each layer that is on into the strip, row by row. */
void drawStrip(Canvas& canvas, const OverlayInput& input, const TOverlayOptions& options,
               const Layout& layout, double pictureWidth_px);

/** Length [m] of a scale bar: the largest of 1, 2 and 5 times a power of ten that is at most `longest_m`. */
double scaleBarLength(double longest_m);
}  // namespace gr2to::view
