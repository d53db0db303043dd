#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace gr2to::bench
{
/** CPU time that the process has used so far, all threads [s]; other programs do not disturb it much. */
double cpuSeconds();

template <class Work>
double cpuSecondsOf(const Work& work)
{
    const double start = cpuSeconds();
    work();
    return cpuSeconds() - start;
}

/** The middle value, of an even number the mean of the two middle ones. \throws std::invalid_argument  none
 * is given */
double median(std::vector<double> values);

/** Slope of the line of least squares through (log x, log y): the exponent e of y = c x^e.
 * \throws std::invalid_argument  fewer than two points, or not as many x as y
 */
double fittedExponent(const std::vector<double>& x, const std::vector<double>& y);

/** By how much the work raises the memory that the process holds, at its peak [bytes].
 *
 * Both steps run in a child process, so that nothing stays behind. What this process has freed already may be
 * reused there unseen, or be in the way: measure memory before anything else. \param prepare  its memory does
 * not count, nor do the pages of libraries that it touches \throws std::runtime_error  the child cannot be
 * made, or a step fails in it
 */
std::size_t peakBytesOf(const std::function<void()>& prepare, const std::function<void()>& work);
}  // namespace gr2to::bench
