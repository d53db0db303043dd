#include "gr2to/grid/WallOrientation.h"

#include <algorithm>
#include <array>

namespace gr2to
{
namespace
{
constexpr double kPi = 3.14159265358979323846;

/** The structure tensor's three sums, as an image. */
struct Tensor
{
    std::vector<float> difference, mixed, energy;  // gx^2 - gy^2, 2 gx gy, gx^2 + gy^2
    explicit Tensor(std::size_t n) : difference(n), mixed(n), energy(n) {}
};

void gradients(const ClassifiedGrid& grid, Tensor& tensor)
{
    const int w = grid.width(), h = grid.height();
    constexpr std::array<int, 5> smooth{1, 4, 6, 4, 1}, derive{-1, -2, 0, 2, 1};
    std::vector<std::uint8_t> free(grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i) free[i] = grid[i] == CellState::Free;
    std::vector<std::int16_t> s(grid.size()), d(grid.size());
    for (int y = 0; y < h; ++y)
        for (int x = 2; x < w - 2; ++x) {
            const std::size_t i = grid.index({x, y});
            int a = 0, b = 0;
            for (int k = -2; k <= 2; ++k) {
                const int f = free[i + static_cast<std::size_t>(k + 2) - 2];
                a += smooth[static_cast<std::size_t>(k + 2)] * f;
                b += derive[static_cast<std::size_t>(k + 2)] * f;
            }
            s[i] = static_cast<std::int16_t>(a);
            d[i] = static_cast<std::int16_t>(b);
        }
    for (int y = 2; y < h - 2; ++y)
        for (int x = 2; x < w - 2; ++x) {
            const std::size_t i = grid.index({x, y});
            int gx = 0, gy = 0;
            for (int k = -2; k <= 2; ++k) {
                const std::size_t j = grid.index({x, y + k});
                gx += smooth[static_cast<std::size_t>(k + 2)] * d[j];
                gy += derive[static_cast<std::size_t>(k + 2)] * s[j];
            }
            const float fx = static_cast<float>(gx) / 48, fy = static_cast<float>(gy) / 48;
            tensor.difference[i] = fx * fx - fy * fy;
            tensor.mixed[i] = 2 * fx * fy;
            tensor.energy[i] = fx * fx + fy * fy;
        }
}

void boxBlur(std::vector<float>& image, int w, int h, int radius)
{
    const float norm = 1.0F / static_cast<float>(2 * radius + 1);
    std::vector<float> line(static_cast<std::size_t>(std::max(w, h)));
    const auto pass = [&](std::size_t begin, std::size_t stride, int n) {
        for (int k = 0; k < n; ++k)
            line[static_cast<std::size_t>(k)] = image[begin + static_cast<std::size_t>(k) * stride];
        float sum = 0;
        for (int k = 0; k < std::min(radius, n); ++k) sum += line[static_cast<std::size_t>(k)];
        for (int k = 0; k < n; ++k) {
            if (k + radius < n) sum += line[static_cast<std::size_t>(k + radius)];
            if (k - radius - 1 >= 0) sum -= line[static_cast<std::size_t>(k - radius - 1)];
            image[begin + static_cast<std::size_t>(k) * stride] = sum * norm;
        }
    };
    for (int y = 0; y < h; ++y) pass(static_cast<std::size_t>(y) * static_cast<std::size_t>(w), 1, w);
    for (int x = 0; x < w; ++x) pass(static_cast<std::size_t>(x), static_cast<std::size_t>(w), h);
}
}  // namespace

std::vector<WallCell> measureWallOrientation(const ClassifiedGrid& grid, double window_cells)
{
    Tensor tensor(grid.size());
    gradients(grid, tensor);
    const int radius = std::max(1, static_cast<int>(std::lround(window_cells)));
    for (auto* image : {&tensor.difference, &tensor.mixed, &tensor.energy})
        for (int pass = 0; pass < 2; ++pass) boxBlur(*image, grid.width(), grid.height(), radius);
    std::vector<WallCell> cells;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        if (grid[i] != CellState::Occupied || tensor.energy[i] < 0.005F) continue;
        const float e = tensor.energy[i];
        // Gradients point across the wall: a quarter turn, which is half a turn of the double angle.
        cells.push_back({grid.cell(i), -tensor.difference[i] / e, -tensor.mixed[i] / e, e});
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
