#pragma once

#include <mrpt/obs/CObservation2DRangeScan.h>

namespace gr2to
{
/** A 3D observation as the horizontal 2D scan that an occupancy grid and ICP can take.
 *
 * Of a range image (CObservation3DRangeScan) each column gives the nearest of its points within 5 degrees
 * above and below the horizontal, as MRPT's convertTo2DScan() does it. \return null for all other classes,
 * 2D scans among them, and for an image without points
 */
mrpt::obs::CObservation2DRangeScan::Ptr planarScanOf(const mrpt::obs::CObservation& observation);
}  // namespace gr2to
