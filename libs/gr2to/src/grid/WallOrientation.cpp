#include "gr2to/grid/WallOrientation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vectorised.h"

namespace gr2to
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

constexpr int kLargestRadius = 12;      // sums of whole numbers then fit 32 bits
constexpr double kLeastEnergy = 0.005;  // of the squared gradient across a straight rim: there is a rim near

constexpr double kGradient = 48;  // what the filters below make of a straight rim

/** One value for each column of the grid. */
using Line = std::vector<std::int32_t>;

/** The structure tensor's three sums in a row of cells: gx^2 - gy^2, 2 gx gy, gx^2 + gy^2, whole numbers, so
 * that sums of them are exact whatever the order of adding. */
using TensorRow = std::array<Line, 3>;

/** Smoothed (1 4 6 4 1) and differentiated (-1 -2 0 2 1) along a row. */
GR2TO_VECTORISED
void filterRow(const CellState* cells, int width, std::int16_t* smooth, std::int16_t* slope)
{
    const auto free = [&](int x) { return static_cast<int>(cells[x] == CellState::Free); };
    for (int x = 2; x < width - 2; ++x) {
        const int a = free(x - 2), b = free(x - 1), c = free(x), d = free(x + 1), e = free(x + 2);
        smooth[x] = static_cast<std::int16_t>(a + e + 4 * (b + d) + 6 * c);
        slope[x] = static_cast<std::int16_t>(e - a + 2 * (d - b));
    }
}

/** The tensor in the middle of five filtered rows. */
GR2TO_VECTORISED
void squareGradients(const std::array<const std::int16_t*, 5>& smooth,
                     const std::array<const std::int16_t*, 5>& slope, std::size_t width,
                     std::int32_t* difference, std::int32_t* mixed, std::int32_t* energy)
{
    const std::int16_t *s0 = smooth[0], *s1 = smooth[1], *s3 = smooth[3], *s4 = smooth[4];
    const std::int16_t *d0 = slope[0], *d1 = slope[1], *d2 = slope[2], *d3 = slope[3], *d4 = slope[4];
    for (std::size_t x = 0; x < width; ++x) {
        const std::int32_t gx = d0[x] + d4[x] + 4 * (d1[x] + d3[x]) + 6 * d2[x];
        const std::int32_t gy = s4[x] - s0[x] + 2 * (s3[x] - s1[x]);
        difference[x] = gx * gx - gy * gy;
        mixed[x] = 2 * gx * gy;
        energy[x] = gx * gx + gy * gy;
    }
}

/** Gives the tensor of one row of the grid after the other, 0 near the border, where the filters end. */
class TensorRows
{
 public:
    explicit TensorRows(const ClassifiedGrid& grid) : m_grid(grid)
    {
        for (auto* rows : {&m_smooth, &m_slope})
            for (auto& row : *rows) row.assign(static_cast<std::size_t>(grid.width()), 0);
    }

    /** \param row  the next row, from the bottom; its lines have the grid's width at `offset` */
    void next(TensorRow& row, std::size_t offset)
    {
        const auto width = static_cast<std::size_t>(m_grid.width());
        for (Line& line : row) std::fill(line.begin(), line.end(), 0);
        for (; m_filtered < std::min(m_grid.height(), m_y + 3); ++m_filtered)
            filterRow(m_grid.row(m_filtered), m_grid.width(), m_smooth[slot(m_filtered)].data(),
                      m_slope[slot(m_filtered)].data());
        if (m_y >= 2 && m_y + 2 < m_grid.height()) {
            std::array<const std::int16_t*, 5> smooth{}, slope{};
            for (int k = 0; k < 5; ++k) {
                smooth[static_cast<std::size_t>(k)] = m_smooth[slot(m_y - 2 + k)].data();
                slope[static_cast<std::size_t>(k)] = m_slope[slot(m_y - 2 + k)].data();
            }
            squareGradients(smooth, slope, width, row[0].data() + offset, row[1].data() + offset,
                            row[2].data() + offset);
        }
        ++m_y;
    }

 private:
    static std::size_t slot(int y) { return static_cast<std::size_t>(y) % 5; }

    const ClassifiedGrid& m_grid;
    std::array<std::vector<std::int16_t>, 5> m_smooth, m_slope;  //!< of the last five filtered rows
    int m_filtered = 0;                                          //!< rows
    int m_y = 0;
};

/** Sums over windows along three lines at once; lines have the grid's width between radius + 1 zeros. */
void sumAlong(const TensorRow& in, std::size_t width, std::size_t radius, TensorRow& out)
{
    const std::int32_t *a = in[0].data(), *b = in[1].data(), *c = in[2].data();
    std::int32_t *outA = out[0].data() + radius + 1, *outB = out[1].data() + radius + 1,
                 *outC = out[2].data() + radius + 1;
    std::int32_t sumA = 0, sumB = 0, sumC = 0;
    for (std::size_t x = radius + 1; x < 2 * radius + 1; ++x) {
        sumA += a[x];
        sumB += b[x];
        sumC += c[x];
    }
    for (std::size_t x = 0; x < width; ++x) {
        outA[x] = sumA += a[x + 2 * radius + 1] - a[x];
        outB[x] = sumB += b[x + 2 * radius + 1] - b[x];
        outC[x] = sumC += c[x + 2 * radius + 1] - c[x];
    }
}

/** Adds a line to sums and takes away the one that it replaces. */
GR2TO_VECTORISED
void replaceInSums(const std::int32_t* line, std::size_t width, std::int32_t* replaced, std::int32_t* sums)
{
    for (std::size_t x = 0; x < width; ++x) {
        sums[x] += line[x] - replaced[x];
        replaced[x] = line[x];
    }
}

/** Sums over the last rows of a window, for each column. */
class ColumnSums
{
 public:
    ColumnSums(std::size_t width, std::size_t radius) : m_rows(2 * radius + 1)
    {
        for (Line& line : m_sums) line.assign(width, 0);
        for (TensorRow& row : m_rows) row = m_sums;
    }

    /** Takes the next row, its lines from `offset` on. */
    void add(const TensorRow& row, std::size_t offset)
    {
        TensorRow& replaced = m_rows[m_next++ % m_rows.size()];
        for (std::size_t k = 0; k < row.size(); ++k)
            replaceInSums(row[k].data() + offset, m_sums[k].size(), replaced[k].data(), m_sums[k].data());
    }
    const TensorRow& sums() const { return m_sums; }

 private:
    std::vector<TensorRow> m_rows;  //!< of the window
    std::size_t m_next = 0;
    TensorRow m_sums;
};

/** Appends the wall cells of a row, given its smoothed tensor. */
void addWallCells(const ClassifiedGrid& grid, int y, const TensorRow& tensor, double straight,
                  std::vector<WallCell>& cells)
{
    const CellState* row = grid.row(y);
    for (std::size_t x = 0; x < tensor[0].size(); ++x) {
        if (row[x] != CellState::Occupied || tensor[2][x] < kLeastEnergy * straight) continue;
        const auto energy = static_cast<float>(tensor[2][x]);
        // Gradients point across the wall: a quarter turn, which is half a turn of the double angle.
        cells.push_back({{static_cast<int>(x), y},
                         -static_cast<float>(tensor[0][x]) / energy,
                         -static_cast<float>(tensor[1][x]) / energy,
                         static_cast<float>(tensor[2][x] / straight)});
    }
}
}  // namespace

/** Two sums over square windows in a row, those beyond the border cut off, weigh near cells more. Rows pass
 * through all filters one after the other, so that few of them are kept. */
std::vector<WallCell> measureWallOrientation(const ClassifiedGrid& grid, double window_cells)
{
    const auto width = static_cast<std::size_t>(grid.width());
    const int reach = std::clamp(static_cast<int>(std::lround(window_cells)), 1, kLargestRadius);
    const auto radius = static_cast<std::size_t>(reach);
    const std::size_t offset = radius + 1;
    TensorRow row, once;
    for (TensorRow* lines : {&row, &once})
        for (Line& line : *lines) line.assign(width + 2 * offset, 0);
    const TensorRow nothing = row;
    TensorRows tensors(grid);
    ColumnSums first(width, radius), second(width, radius);
    const double straight = kGradient * kGradient * std::pow(2 * reach + 1, 4);
    std::vector<WallCell> cells;
    for (int y = 0; y < grid.height() + 2 * reach; ++y) {
        if (y < grid.height()) {
            tensors.next(row, offset);
            sumAlong(row, width, radius, once);
            sumAlong(once, width, radius, row);
        }
        first.add(y < grid.height() ? row : nothing, offset);
        if (y < reach) continue;
        if (y < grid.height() + reach)
            second.add(first.sums(), 0);
        else
            second.add(nothing, 0);
        if (y >= 2 * reach) addWallCells(grid, y - 2 * reach, second.sums(), straight, cells);
    }
    return cells;
}

std::vector<LineDirection> dominantDirections(const std::vector<WallCell>& cells, std::size_t most,
                                              double least)
{
    constexpr int bins = 180;
    std::array<double, bins> histogram{};
    for (const WallCell& cell : cells) {
        const double coherence = std::hypot(cell.doubleCos, cell.doubleSin);
        if (coherence < 0.5) continue;
        const double angle = 0.5 * std::atan2(cell.doubleSin, cell.doubleCos) * 180 / kPi;  // -90 to 90
        histogram[static_cast<std::size_t>(std::lround(angle) + bins) % bins] += coherence * cell.weight;
    }
    std::array<double, bins> smooth{};
    for (int b = 0; b < bins; ++b)
        for (int k = -2; k <= 2; ++k)
            smooth[static_cast<std::size_t>(b)] +=
                (3 - std::abs(k)) * histogram[static_cast<std::size_t>(b + k + bins) % bins];
    std::vector<LineDirection> directions;
    double strongest = 0;
    while (directions.size() < most) {
        const auto peak = std::max_element(smooth.begin(), smooth.end());
        if (*peak <= 0 || *peak < least * strongest) break;
        strongest = std::max(strongest, *peak);
        const auto b = static_cast<int>(peak - smooth.begin());
        double sum = 0, moment = 0;  // the peak's centre, finer than a bin
        for (int k = -2; k <= 2; ++k) {
            const double v = histogram[static_cast<std::size_t>(b + k + bins) % bins];
            sum += v;
            moment += k * v;
        }
        directions.emplace_back((b + (sum > 0 ? moment / sum : 0)) * kPi / 180);
        for (int k = -10; k <= 10; ++k) smooth[static_cast<std::size_t>(b + k + bins) % bins] = 0;
    }
    return directions;
}
}  // namespace gr2to
