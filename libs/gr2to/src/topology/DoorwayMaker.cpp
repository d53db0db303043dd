#include "gr2to/topology/DoorwayMaker.h"

#include "gr2to/topology/MeasuredHeight.h"
#include "gr2to/topology/WallFit.h"
#include "inSpace.h"

namespace gr2to
{
Doorway doorwayOf(const ValidatedDoor& door, const ClassifiedGrid& grid, const HeightMap& heights)
{
    const LineFit fit =
        fitLine({grid.frame().toMap(door.jambA), grid.frame().toMap(door.jambB)}, grid.resolution_m());
    Doorway result;
    result.position.mean = {fit.center.x(), fit.center.y(), 0};
    result.position.covariance = inSpace(fit.centerCovariance);
    result.size.length_m = fit.length_m - 2 * grid.resolution_m();  // from jamb face to jamb face
    result.size.covariance(0, 0) = fit.lengthVariance;
    result.real = true;
    result.state = DoorState::Open;
    setHeight(heights, lintelHeight({grid, door.line, {door.jambA, door.jambB}}, heights), result.position,
              result.size);
    return result;
}

Doorway openingOf(const PlaceLink& link, const ClassifiedGrid& grid, const HeightMap& heights)
{
    const Eigen::Vector2d at = grid.frame().toMap(link.at);
    const double variance = grid.resolution_m() * grid.resolution_m() / 12.0;
    Doorway result;
    result.position.mean = {at.x(), at.y(), 0};
    result.position.covariance = inSpace(Eigen::Matrix2d::Identity() * variance);
    result.size.length_m = (2 * link.clearance_cells - 1) * grid.resolution_m();
    result.size.covariance(0, 0) = 2 * variance;
    setHeight(heights, std::nullopt, result.position, result.size);
    return result;
}
}  // namespace gr2to
