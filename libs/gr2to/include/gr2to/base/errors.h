#pragma once

#include <stdexcept>
#include <string>

namespace gr2to
{
/** What the caller handed in cannot be used: a missing or broken file, an empty grid, contradictory options.
 *
 * The message is one line: what, where, which rule, what to do. Applications answer it with exit code 2.
 * An option out of its range is a std::invalid_argument instead, also answered with exit code 2.
 */
class InputError : public std::runtime_error
{
 public:
    using std::runtime_error::runtime_error;
};

/** A result could not be produced or stored, for example because the disk is full. Applications answer
 * with 1. */
class OutputError : public std::runtime_error
{
 public:
    using std::runtime_error::runtime_error;
};
}  // namespace gr2to
