#include "gr2to/topology/WallFit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gr2to/grid/Jambs.h"

namespace gr2to
{
WallSupport cellsAlong(const ClassifiedGrid& grid, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const int samples = std::max(1, static_cast<int>(std::ceil((to - from).norm())));  // one a cell
    std::vector<std::size_t> cells;
    int hits = 0;
    Cell before{-3, -3};  // the sample before, whose neighbours are known
    for (int k = 0; k <= samples; ++k) {
        const Eigen::Vector2d p = from + (to - from) * (static_cast<double>(k) / samples);
        const Cell at{roundToCell(p.x()), roundToCell(p.y())};
        bool hit = false;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const Cell c{at.x + dx, at.y + dy};
                if (!grid.isOccupied(c)) continue;
                hit = true;
                if (std::abs(c.x - before.x) > 1 || std::abs(c.y - before.y) > 1)
                    cells.push_back(grid.index(c));
            }
        hits += hit ? 1 : 0;
        before = at;
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    WallSupport support;
    support.covered = static_cast<double>(hits) / (samples + 1);
    support.points.reserve(cells.size());
    for (const std::size_t i : cells) support.points.push_back(grid.frame().toMap(grid.cell(i)));
    return support;
}

LineFit fitLine(const std::vector<Eigen::Vector2d>& points, double resolution_m)
{
    LineFit fit;
    fit.center = Eigen::Vector2d::Zero();
    for (const auto& p : points) fit.center += p;
    fit.center /= static_cast<double>(std::max<std::size_t>(points.size(), 1));
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const auto& p : points) scatter += (p - fit.center) * (p - fit.center).transpose();
    if (!(scatter.trace() > 0)) throw std::invalid_argument("a line needs at least two different points");
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
    eigen.computeDirect(scatter);
    fit.direction = eigen.eigenvectors().col(1).normalized();
    double first = 0, last = 0, sumOfSquares = 0;
    for (const auto& p : points) {
        const double s = fit.direction.dot(p - fit.center);
        first = std::min(first, s);
        last = std::max(last, s);
        sumOfSquares += s * s;
    }
    const double variance = resolution_m * resolution_m / 12.0;
    const Eigen::Matrix2d along = fit.direction * fit.direction.transpose();
    const Eigen::Matrix2d across = Eigen::Matrix2d::Identity() - along;
    fit.length_m = last - first + resolution_m;
    fit.centerCovariance =
        across * (variance / static_cast<double>(points.size())) + along * (variance / 2.0);
    fit.normalCovariance = along * (variance / sumOfSquares);
    fit.lengthVariance = 2.0 * variance;
    return fit;
}
}  // namespace gr2to
