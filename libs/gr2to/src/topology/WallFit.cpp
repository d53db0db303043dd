#include "gr2to/topology/WallFit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gr2to
{
LineFit fitLine(const std::vector<Eigen::Vector2d>& points, double resolution_m)
{
    LineFit fit;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const auto& p : points) mean += p;
    mean /= static_cast<double>(std::max<std::size_t>(points.size(), 1));
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const auto& p : points) scatter += (p - mean) * (p - mean).transpose();
    if (!(scatter.trace() > 0)) throw std::invalid_argument("a line needs at least two different points");
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
    eigen.computeDirect(scatter);
    fit.direction = eigen.eigenvectors().col(1).normalized();
    double first = 0, last = 0, sumOfSquares = 0;
    for (const auto& p : points) {
        const double s = fit.direction.dot(p - mean);
        first = std::min(first, s);
        last = std::max(last, s);
        sumOfSquares += s * s;
    }
    const double variance = resolution_m * resolution_m / 12.0;
    const Eigen::Matrix2d along = fit.direction * fit.direction.transpose();
    const Eigen::Matrix2d across = Eigen::Matrix2d::Identity() - along;
    const double middle = (first + last) / 2.0, angleVariance = variance / sumOfSquares;
    fit.center = mean + middle * fit.direction;
    fit.length_m = last - first + resolution_m;
    fit.centerCovariance =
        across * (variance / static_cast<double>(points.size()) + middle * middle * angleVariance) +
        along * (variance / 2.0);
    fit.normalCovariance = along * angleVariance;
    fit.lengthVariance = 2.0 * variance;
    return fit;
}
}  // namespace gr2to
