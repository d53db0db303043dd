#include "gr2to/io/PlanarScan.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

namespace gr2to
{
mrpt::obs::CObservation2DRangeScan::Ptr planarScanOf(const mrpt::obs::CObservation& observation)
{
    const auto* image = dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(&observation);
    if (image == nullptr || !image->hasRangeImage) return nullptr;
    auto copy = *image;  // the conversion is no const method
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    mrpt::obs::T3DPointsTo2DScanParams how;
    how.sensorLabel = image->sensorLabel;
    copy.load();
    copy.convertTo2DScan(*scan, how);
    scan->timestamp = image->timestamp;
    return scan;
}
}  // namespace gr2to
