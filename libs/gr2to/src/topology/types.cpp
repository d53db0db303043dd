#include "gr2to/topology/types.h"

namespace gr2to
{
namespace
{
template <class Matrix>
bool sameEntries(const Matrix& a, const Matrix& b)
{
    for (int row = 0; row < a.rows(); ++row)
        for (int column = 0; column < a.cols(); ++column)
            if (a(row, column) != b(row, column)) return false;
    return true;
}

/** For UncertainPoint and UncertainNormal. */
template <class Uncertain>
bool same(const Uncertain& a, const Uncertain& b)
{
    return a.mean == b.mean && sameEntries(a.covariance, b.covariance);
}

bool same(const PlaneSize& a, const PlaneSize& b)
{
    return a.length_m == b.length_m && a.height_m == b.height_m && sameEntries(a.covariance, b.covariance);
}
}  // namespace

bool operator==(const Wall& a, const Wall& b)
{
    return a.id == b.id && same(a.position, b.position) && same(a.normal, b.normal) && same(a.size, b.size) &&
           a.curvatureLength == b.curvatureLength && a.curvatureHeight == b.curvatureHeight &&
           a.real == b.real;
}

bool operator==(const View& a, const View& b)
{
    return a.image == b.image && same(a.position, b.position) && a.apertureX_rad == b.apertureX_rad &&
           a.apertureY_rad == b.apertureY_rad && a.time_s == b.time_s;
}

bool operator==(const Place& a, const Place& b)
{
    return a.id == b.id && a.kind == b.kind && a.words == b.words && a.walls == b.walls &&
           a.views == b.views && a.area_m2 == b.area_m2 && a.center == b.center && a.boundary == b.boundary;
}

bool operator==(const Doorway& a, const Doorway& b)
{
    return same(a.position, b.position) && same(a.size, b.size) && a.real == b.real && a.state == b.state &&
           a.view == b.view;
}

bool operator==(const Connection& a, const Connection& b)
{
    return a.id == b.id && a.from == b.from && a.to == b.to && a.words == b.words && a.doorway == b.doorway;
}
}  // namespace gr2to
