#include "gr2to/grid/WallOrientation.h"

#include <algorithm>
#include <array>

namespace gr2to
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

constexpr int kLargestRadius = 12;      // sums of whole numbers then fit 32 bits
constexpr double kLeastEnergy = 0.005;  // of the squared gradient across a straight rim: there is a rim near

/** The structure tensor's three sums, as images of whole numbers: exact, whatever the order of adding. */
struct Tensor
{
    std::vector<std::int32_t> difference, mixed, energy;  // gx^2 - gy^2, 2 gx gy, gx^2 + gy^2
    explicit Tensor(std::size_t n) : difference(n), mixed(n), energy(n) {}
};

constexpr double kGradient = 48;  // what the filters below make of a straight rim

/** Smoothed (1 4 6 4 1) and differentiated (-1 -2 0 2 1) along a row. */
void filterRow(const CellState* cells, int width, std::vector<std::int16_t>& smooth,
               std::vector<std::int16_t>& slope)
{
    const auto free = [&](int x) { return static_cast<int>(cells[x] == CellState::Free); };
    for (int x = 2; x < width - 2; ++x) {
        const int a = free(x - 2), b = free(x - 1), c = free(x), d = free(x + 1), e = free(x + 2);
        smooth[static_cast<std::size_t>(x)] = static_cast<std::int16_t>(a + e + 4 * (b + d) + 6 * c);
        slope[static_cast<std::size_t>(x)] = static_cast<std::int16_t>(e - a + 2 * (d - b));
    }
}

void squareGradients(const ClassifiedGrid& grid, Tensor& tensor)
{
    const auto width = static_cast<std::size_t>(grid.width());
    std::vector<std::vector<std::int16_t>> smooth(5, std::vector<std::int16_t>(width)), slope = smooth;
    for (int y = 0; y < grid.height(); ++y) {
        filterRow(grid.row(y), grid.width(), smooth[static_cast<std::size_t>(y) % 5],
                  slope[static_cast<std::size_t>(y) % 5]);
        if (y < 4) continue;
        const auto row = [&](std::vector<std::vector<std::int16_t>>& rows, int k) {
            return rows[static_cast<std::size_t>(y - 4 + k) % 5].data();
        };
        const std::int16_t *s0 = row(smooth, 0), *s1 = row(smooth, 1), *s3 = row(smooth, 3),
                           *s4 = row(smooth, 4);
        const std::int16_t *d0 = row(slope, 0), *d1 = row(slope, 1), *d2 = row(slope, 2), *d3 = row(slope, 3),
                           *d4 = row(slope, 4);
        const std::size_t begin = grid.index({0, y - 2});
        std::int32_t *difference = tensor.difference.data() + begin, *mixed = tensor.mixed.data() + begin,
                     *energy = tensor.energy.data() + begin;
        for (std::size_t x = 0; x < width; ++x) {
            const std::int32_t gx = d0[x] + d4[x] + 4 * (d1[x] + d3[x]) + 6 * d2[x];
            const std::int32_t gy = s4[x] - s0[x] + 2 * (s3[x] - s1[x]);
            difference[x] = gx * gx - gy * gy;
            mixed[x] = 2 * gx * gy;
            energy[x] = gx * gx + gy * gy;
        }
    }
}

/** Sums over square windows, those beyond the border cut off: along rows, then row by row over columns. */
void sumBoxes(std::vector<std::int32_t>& image, int width, int height, int radius)
{
    const auto w = static_cast<std::size_t>(width);
    const auto r = static_cast<std::size_t>(radius);
    std::vector<std::int32_t> line(w + 2 * r + 2, 0);  // the row with zeros around: cell x is at x + r + 1
    for (int y = 0; y < height; ++y) {
        std::int32_t* row = image.data() + static_cast<std::size_t>(y) * w;
        std::copy(row, row + w, line.begin() + radius + 1);
        std::int32_t sum = 0;
        for (std::size_t k = 0; k < r; ++k) sum += line[r + 1 + k];
        for (std::size_t x = 0; x < w; ++x) {
            sum += line[x + 2 * r + 1] - line[x];
            row[x] = sum;
        }
    }
    std::vector<std::int32_t> result(image.size()), sums(w, 0);
    for (int y = -radius; y < height; ++y) {
        if (y + radius < height) {
            const std::int32_t* in = image.data() + static_cast<std::size_t>(y + radius) * w;
            for (std::size_t x = 0; x < w; ++x) sums[x] += in[x];
        }
        if (y - radius - 1 >= 0) {
            const std::int32_t* out = image.data() + static_cast<std::size_t>(y - radius - 1) * w;
            for (std::size_t x = 0; x < w; ++x) sums[x] -= out[x];
        }
        if (y >= 0)
            std::copy(sums.begin(), sums.end(),
                      result.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * w));
    }
    image.swap(result);
}
}  // namespace

std::vector<WallCell> measureWallOrientation(const ClassifiedGrid& grid, double window_cells)
{
    Tensor tensor(grid.size());
    squareGradients(grid, tensor);
    const int radius = std::clamp(static_cast<int>(std::lround(window_cells)), 1, kLargestRadius);
    for (auto* image : {&tensor.difference, &tensor.mixed, &tensor.energy})
        for (int pass = 0; pass < 2; ++pass) sumBoxes(*image, grid.width(), grid.height(), radius);
    const double straight = kGradient * kGradient * std::pow(2 * radius + 1, 4);
    std::vector<WallCell> cells;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        if (grid[i] != CellState::Occupied || tensor.energy[i] < kLeastEnergy * straight) continue;
        const auto energy = static_cast<float>(tensor.energy[i]);
        // Gradients point across the wall: a quarter turn, which is half a turn of the double angle.
        cells.push_back({grid.cell(i), -static_cast<float>(tensor.difference[i]) / energy,
                         -static_cast<float>(tensor.mixed[i]) / energy,
                         static_cast<float>(tensor.energy[i] / straight)});
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
