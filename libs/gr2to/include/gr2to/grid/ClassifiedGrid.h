#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gr2to
{
/** What is known about one cell. */
enum class CellState : std::uint8_t
{
    Unknown = 0,
    Free = 1,
    Occupied = 2
};

/** A cell by column (x, to the right) and row (y, upwards); (0, 0) is the bottom-left cell of the grid. */
struct Cell
{
    int x = 0;
    int y = 0;
    friend bool operator==(const Cell& a, const Cell& b) { return a.x == b.x && a.y == b.y; }
    friend bool operator!=(const Cell& a, const Cell& b) { return !(a == b); }
};

/** The order of cells row by row from the lowest, each from the left. */
inline bool rasterLess(Cell a, Cell b)
{
    return a.y != b.y ? a.y < b.y : a.x < b.x;
}

/** Where a grid lies in the map frame: metres, x right, y up, square cells.
 *
 * The origin is the map-frame position of the bottom-left *corner* of cell (0, 0); yaw turns the grid about
 * it, counter-clockwise. Continuous grid coordinates are in cells, with the *centre* of cell (c, r) at (c,
 * r).
 */
struct GridFrame
{
    double resolution_m = 0.05;  //!< side of a cell [m]
    double origin_x_m = 0.0;
    double origin_y_m = 0.0;
    double yaw_rad = 0.0;

    /** Map-frame position [m] of a point in continuous grid coordinates [cells]. */
    Eigen::Vector2d toMap(double column, double row) const;
    Eigen::Vector2d toMap(Cell c) const { return toMap(c.x, c.y); }
    /** Continuous grid coordinates [cells] of a map-frame point [m]; inverse of toMap. */
    Eigen::Vector2d toGrid(double x_m, double y_m) const;
    /** Map-frame direction of a direction given along the grid's axes. */
    Eigen::Vector2d directionToMap(const Eigen::Vector2d& direction) const;
};

/** A grid of free, occupied and unknown cells: what the pixels say, however they were stored.
 *
 * Rows are stored from the bottom (y = 0) to the top, each from left to right; index = y * width + x.
 */
class ClassifiedGrid
{
 public:
    ClassifiedGrid() = default;
    /** A grid of cells in one state.
     * \throws InputError  a side is not positive, exceeds maxSide(), or the resolution is not a positive
     * number
     */
    ClassifiedGrid(int width, int height, GridFrame frame, CellState fill = CellState::Unknown);

    /** Most cells along a side: the squared diagonal and cell indices then fit 32 bits. */
    static constexpr int maxSide() { return 32767; }

    int width() const { return m_width; }
    int height() const { return m_height; }
    std::size_t size() const { return m_cells.size(); }
    bool empty() const { return m_cells.empty(); }
    const GridFrame& frame() const { return m_frame; }
    double resolution_m() const { return m_frame.resolution_m; }

    bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < m_width && c.y < m_height; }
    std::size_t index(Cell c) const
    {
        return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(m_width) +
               static_cast<std::size_t>(c.x);
    }
    Cell cell(std::size_t index) const
    {
        const auto w = static_cast<std::size_t>(m_width);
        return {static_cast<int>(index % w), static_cast<int>(index / w)};
    }

    CellState operator[](std::size_t index) const { return m_cells[index]; }
    CellState& operator[](std::size_t index) { return m_cells[index]; }
    CellState at(Cell c) const { return m_cells[index(c)]; }
    void set(Cell c, CellState state) { m_cells[index(c)] = state; }
    bool isFree(Cell c) const { return contains(c) && at(c) == CellState::Free; }
    bool isOccupied(Cell c) const { return contains(c) && at(c) == CellState::Occupied; }

    const CellState* row(int y) const { return m_cells.data() + index({0, y}); }
    CellState* row(int y) { return m_cells.data() + index({0, y}); }
    const std::vector<CellState>& cells() const { return m_cells; }

    /** How many cells are in the state. */
    std::size_t count(CellState state) const;

    friend bool operator==(const ClassifiedGrid& a, const ClassifiedGrid& b);

 private:
    int m_width = 0;
    int m_height = 0;
    GridFrame m_frame;
    std::vector<CellState> m_cells;
};
}  // namespace gr2to
