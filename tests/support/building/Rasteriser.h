#pragma once

#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/PlaceImage.h"
#include "support/building/FloorPlan.h"

namespace gr2to::test
{
/** From the building's own frame to the map: turned, then shifted so that the margin begins at the map's
 * origin. */
class BuildingPose
{
 public:
    BuildingPose(const FloorPlan& plan, const TBuildingOptions& options);
    Eigen::Vector2d toMap(const Eigen::Vector2d& p) const { return turned(p) + m_shift; }
    Eigen::Vector2d turned(const Eigen::Vector2d& v) const
    {
        return {m_cos * v.x() - m_sin * v.y(), m_sin * v.x() + m_cos * v.y()};
    }
    double cos() const { return m_cos; }
    double sin() const { return m_sin; }
    const Eigen::Vector2d& shift() const { return m_shift; }
    /** Extent of the map with its margins [m]. */
    const Eigen::Vector2d& extent() const { return m_extent; }

 private:
    double m_cos = 1, m_sin = 0;
    Eigen::Vector2d m_shift = Eigen::Vector2d::Zero(), m_extent = Eigen::Vector2d::Zero();
};

struct RasterisedPlan
{
    ClassifiedGrid grid;
    PlaceImage labels;
};

/** The plan sampled at the centres of cells. */
RasterisedPlan rasterise(const FloorPlan& plan, const BuildingPose& pose, const TBuildingOptions& options);
/** What a sensor makes of it: pieces displaced by a cell, ragged edges, false returns. Free cells keep a
 * label. */
void degrade(RasterisedPlan& raster, const TBuildingOptions& options);
}  // namespace gr2to::test
