#pragma once

#include "gr2to/view/Overlay.h"
#include "support/picture.h"

namespace gr2to::test
{
/** An overlay without a strip below the map. */
inline TOverlayOptions bare()
{
    TOverlayOptions options;
    options.legend = options.scale_bar = false;
    return options;
}

/** Reads a picture without a strip by cells; fractions of a cell are allowed. */
class MapPicture
{
 public:
    MapPicture(const OverlayInput& input, const TOverlayOptions& options)
        : m_picture(decodePng(renderOverlayPng(input, options))),
          m_rows(input.grid.height()),
          m_scale(static_cast<double>(m_picture.width) / input.grid.width())
    {
    }
    const Picture& picture() const { return m_picture; }
    Rgb at(double x, double y) const
    {
        return m_picture.at(static_cast<int>((x + 0.5) * m_scale),
                            static_cast<int>((m_rows - 0.5 - y) * m_scale));
    }
    /** How many of 200 pixels on the straight line between two cells have the colour. */
    int countOn(double x0, double y0, double x1, double y1, Rgb color) const
    {
        int hits = 0;
        for (int i = 0; i < 200; ++i)
            hits += at(x0 + (x1 - x0) * i / 199.0, y0 + (y1 - y0) * i / 199.0) == color ? 1 : 0;
        return hits;
    }

 private:
    Picture m_picture;
    int m_rows;
    double m_scale;
};
}  // namespace gr2to::test
