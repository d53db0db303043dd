#pragma once

#include "Canvas.h"
#include "Layout.h"
#include "gr2to/view/Overlay.h"

namespace gr2to::view
{
/** Writes every place's id beside its vertex (on it, when the connections layer is off).
 *
 * A label is as large as its place allows, within half and the whole of `text_size`, and avoids the labels of
 * larger places where one of four positions around the vertex is free.
 */
void drawIds(Canvas& canvas, const OverlayInput& input, const TOverlayOptions& options, const Layout& layout);
}  // namespace gr2to::view
