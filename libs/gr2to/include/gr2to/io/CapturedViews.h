#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gr2to/topology/types.h"

namespace mrpt::maps
{
class CSimpleMap;
}

namespace gr2to
{
/** An image that a robot took, and from where. */
struct CapturedView
{
    View view;           //!< all but the name of its image
    std::string bytes;   //!< of the image file
    std::string ending;  //!< of its name, for example `.png`
};

/** The images of a simplemap's keyframes (CObservationImage, and those of CObservation3DRangeScan).
 *
 * The position is the camera's, its covariance that of the keyframe's pose carried over to the camera; the
 * apertures are those of the camera's parameters, 0 when these state no focal length. An image that is stored
 * in a file of its own is taken as it is, others become PNG.
 * \param folder   where images that are stored outside lie
 * \param missing  receives how many of these could not be read; they are left out
 */
std::vector<CapturedView> viewsOf(const mrpt::maps::CSimpleMap& map, const std::filesystem::path& folder,
                                  std::size_t& missing);
}  // namespace gr2to
