#include "findings.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <optional>

#include "gr2to/base/text.h"

namespace gr2to
{
namespace
{
/** What is wrong with a covariance; nothing when it is one. */
template <class Matrix>
std::optional<std::string> covarianceComplaint(const Matrix& matrix)
{
    constexpr double ROUNDING =
        1e-9;  // of the largest entry; products J S J^T of rank-deficient S stay far below
    const Eigen::MatrixXd entries = matrix.asEigen();
    for (int row = 0; row < entries.rows(); ++row)
        for (int column = 0; column < entries.cols(); ++column) {
            const std::string at = "(" + std::to_string(row + 1) + ", " + std::to_string(column + 1) + ")";
            if (!std::isfinite(entries(row, column)))
                return "has entry " + at + " = " + numberText(entries(row, column)) +
                       ", which must be finite";
            if (entries(row, column) != entries(column, row))
                return "has entry " + at + " = " + numberText(entries(row, column)) +
                       ", which must equal its mirror image " + numberText(entries(column, row));
        }
    const double largest = entries.cwiseAbs().maxCoeff();
    if (largest == 0) return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(entries / largest, Eigen::EigenvaluesOnly);
    const double least = solver.eigenvalues().minCoeff();
    if (least >= -ROUNDING) return std::nullopt;
    return "has eigenvalue " + numberText(least * largest) + ", which must not be negative";
}
}  // namespace

void Findings::add(const std::string& where, const std::string& quantity, double value,
                   const std::string& unit, const std::string& rule)
{
    add(where, quantity + " = " + numberText(value) + unit + " " + rule);
}

bool Findings::requireFinite(const std::string& where, const std::string& quantity, double value)
{
    if (std::isfinite(value)) return true;
    add(where, quantity, value, "", "must be finite");
    return false;
}

bool Findings::requireFinite(const std::string& where, const std::string& quantity,
                             const mrpt::math::TPoint3D& point)
{
    const bool x = requireFinite(where, quantity + " x", point.x);
    const bool y = requireFinite(where, quantity + " y", point.y);
    const bool z = requireFinite(where, quantity + " z", point.z);
    return x && y && z;
}

void Findings::requirePositive(const std::string& where, const std::string& quantity, double value,
                               const std::string& unit)
{
    if (!std::isfinite(value) || value <= 0)
        add(where, quantity, value, unit, "must be finite and greater than 0");
}

void Findings::requireAperture(const std::string& where, const std::string& quantity, double value_rad)
{
    constexpr double FULL_TURN = 2 * M_PI;
    if (!(value_rad >= 0 && value_rad <= FULL_TURN))
        add(where, quantity, value_rad, " rad", "must be within [0, 2 pi]");
}

void Findings::requireName(const std::string& where, const std::string& quantity, const std::string& text)
{
    if (text.empty())
        add(where, quantity + " is empty; it must have at least one character");
    else if (!isText(text))
        add(where, quantity + " = " + quoted(text) + " must be UTF-8 text without control characters");
    else if (hasControlCharacter(text))
        add(where,
            quantity + " = " + quoted(text) + " must have no tabs, line ends or other control characters");
}

void Findings::requireFreshId(const std::string& where, std::uint32_t id, std::set<std::uint32_t>& taken)
{
    if (id == 0) add(where, "id = 0 must be at least 1");
    if (!taken.insert(id).second) add(where, "id = " + std::to_string(id) + " is taken; ids must be unique");
}

void Findings::requireCovariance(const std::string& where, const std::string& of,
                                 const mrpt::math::CMatrixDouble33& matrix)
{
    if (const auto complaint = covarianceComplaint(matrix))
        add(where, "the covariance of " + of + " " + *complaint);
}

void Findings::requireCovariance(const std::string& where, const std::string& of,
                                 const mrpt::math::CMatrixDouble22& matrix)
{
    if (const auto complaint = covarianceComplaint(matrix))
        add(where, "the covariance of " + of + " " + *complaint);
}
}  // namespace gr2to
