#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to
{
/** An image with a border of one cell of zeros, so that every cell has eight neighbours. */
template <class Value>
class Padded
{
 public:
    Padded(int width, int height)
        : m_width(width),
          m_height(height),
          m_stride(static_cast<std::size_t>(width) + 2),
          m_values(m_stride * (static_cast<std::size_t>(height) + 2), Value{0})
    {
    }
    int width() const { return m_width; }
    int height() const { return m_height; }
    std::size_t stride() const { return m_stride; }
    std::size_t size() const { return m_values.size(); }  //!< with the border
    std::size_t index(Cell c) const
    {
        return (static_cast<std::size_t>(c.y) + 1) * m_stride + static_cast<std::size_t>(c.x) + 1;
    }
    Cell cell(std::size_t index) const
    {
        return {static_cast<int>(index % m_stride) - 1, static_cast<int>(index / m_stride) - 1};
    }
    const Value& operator[](std::size_t i) const { return m_values[i]; }
    Value& operator[](std::size_t i) { return m_values[i]; }
    /** Index steps to the eight neighbours, counter-clockwise from the right; even ones share a side. */
    std::array<std::ptrdiff_t, 8> neighbourSteps() const
    {
        const auto s = static_cast<std::ptrdiff_t>(m_stride);
        return {1, s + 1, s, s - 1, -1, -s - 1, -s, -s + 1};
    }

 private:
    int m_width;
    int m_height;
    std::size_t m_stride;
    std::vector<Value> m_values;
};

/** A binary image: 1 on the cells of the figure. */
using Mask = Padded<std::uint8_t>;
}  // namespace gr2to
