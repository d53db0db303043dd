#pragma once

#include <cmath>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to
{
/** A direction in the grid, as a family of parallel digital lines: every cell lies on exactly one of them.
 *
 * A line is a *row*; along it cells are counted in *steps* of one column (or one grid row, for directions
 * nearer to the vertical). For horizontal directions rows and steps are those of the grid.
 */
class LineDirection
{
 public:
    LineDirection() = default;
    /** \param angle_rad  counter-clockwise from the grid's rows; half turns are the same direction */
    explicit LineDirection(double angle_rad) : LineDirection(std::cos(angle_rad), std::sin(angle_rad)) {}
    /** The direction of a vector that is not zero. */
    LineDirection(double dx, double dy)
        : m_alongColumns(std::abs(dx) >= std::abs(dy)),
          m_slope(m_alongColumns ? dy / dx : dx / dy),
          m_stretch(std::sqrt(1 + m_slope * m_slope))
    {
    }

    int step(Cell c) const { return m_alongColumns ? c.x : c.y; }
    int row(Cell c) const { return m_alongColumns ? c.y - rise(c.x) : c.x - rise(c.y); }
    Cell cell(int step, int row) const
    {
        return m_alongColumns ? Cell{step, row + rise(step)} : Cell{row + rise(step), step};
    }
    /** Length of a step along the line [cells]; rows are 1 / stretch() apart. */
    double stretch() const { return m_stretch; }
    /** Steps to go back when going up by some rows, to leave at right angles. */
    double skew(double rows) const { return -rows * m_slope / (m_stretch * m_stretch); }
    /** Cosine and sine of twice the angle: the same for both senses of the direction. */
    double doubleCos() const
    {
        const double c = (1 - m_slope * m_slope) / (m_stretch * m_stretch);
        return m_alongColumns ? c : -c;
    }
    double doubleSin() const { return 2 * m_slope / (m_stretch * m_stretch); }

 private:
    int rise(int step) const  // rounds down without a call
    {
        const double value = m_slope * step + 0.5;
        const int towardsZero = static_cast<int>(value);
        return towardsZero - (value < towardsZero ? 1 : 0);
    }

    bool m_alongColumns = true;
    double m_slope = 0;
    double m_stretch = 1;
};
}  // namespace gr2to
