#pragma once

#include <mrpt/math/CMatrixFixed.h>

#include <Eigen/Core>

namespace gr2to
{
/** A covariance of the plane as one of space: nothing is known to vary in height. */
inline mrpt::math::CMatrixDouble33 inSpace(const Eigen::Matrix2d& plane)
{
    mrpt::math::CMatrixDouble33 m;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) m(i, j) = plane(i, j);
    return m;
}
}  // namespace gr2to
