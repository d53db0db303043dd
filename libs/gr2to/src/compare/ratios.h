#pragma once

#include <cstddef>

namespace gr2to
{
/** a / b, and 0 of nothing: a share of an empty set scores nothing. */
inline double ratio(double a, double b)
{
    return b != 0.0 ? a / b : 0.0;
}
inline double ratio(std::size_t a, std::size_t b)
{
    return ratio(static_cast<double>(a), static_cast<double>(b));
}

/** Harmonic mean of precision and recall. */
inline double f1Of(double precision, double recall)
{
    return ratio(2 * precision * recall, precision + recall);
}
}  // namespace gr2to
