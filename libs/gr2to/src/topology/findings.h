#pragma once

#include <mrpt/math/CMatrixFixed.h>
#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gr2to
{
/** What a check of a map found wrong, one line each: `where: quantity = value rule`. */
class Findings
{
 public:
    std::vector<std::string> take() { return std::move(m_lines); }

    void add(const std::string& where, const std::string& complaint)
    {
        m_lines.push_back(where + ": " + complaint);
    }
    void add(const std::string& where, const std::string& quantity, double value, const std::string& unit,
             const std::string& rule);

    /** These add a line when the rule in their name is broken. */
    bool requireFinite(const std::string& where, const std::string& quantity, double value);
    bool requireFinite(const std::string& where, const std::string& quantity,
                       const mrpt::math::TPoint3D& point);
    void requirePositive(const std::string& where, const std::string& quantity, double value,
                         const std::string& unit);
    void requireAperture(const std::string& where, const std::string& quantity, double value_rad);
    /** Non-empty UTF-8 without control characters. */
    void requireName(const std::string& where, const std::string& quantity, const std::string& text);
    /** From 1 and not yet in `taken`, which it joins. */
    void requireFreshId(const std::string& where, std::uint32_t id, std::set<std::uint32_t>& taken);
    /** Finite, exactly symmetric, positive semi-definite but for rounding. */
    void requireCovariance(const std::string& where, const std::string& of,
                           const mrpt::math::CMatrixDouble33& matrix);
    void requireCovariance(const std::string& where, const std::string& of,
                           const mrpt::math::CMatrixDouble22& matrix);

 private:
    std::vector<std::string> m_lines;
};
}  // namespace gr2to
