#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "gr2to/grid/PlaceImage.h"

namespace gr2to
{
/** What an annotated passage between two rooms is, by its width. */
enum class InterfaceKind : std::uint8_t
{
    Slit,    //!< too narrow to pass: neither a door nor, for certain, a connection
    Door,    //!< as wide as a door
    Opening  //!< wider than any door
};

/** A passage between two rooms as a person annotated it. */
struct ReferenceInterface
{
    InterfaceKind kind = InterfaceKind::Door;
    PlaceId a = 0;  //!< the smaller label of the two rooms
    PlaceId b = 0;  //!< the larger label
    Eigen::Vector2d mid_px =
        Eigen::Vector2d::Zero();  //!< its middle in image coordinates, see ReferenceAnnotation
    double width_m = 0;           //!< clear width [m]
};

/** What a building looks like to people: its rooms as a label image and, when annotated, the passages between
 * them.
 *
 * Image coordinates have the *centre* of the top-left pixel at (0, 0), x to the right, y down, in pixels. The
 * label image itself is stored from the bottom row up, as every PlaceImage.
 */
struct ReferenceAnnotation
{
    PlaceImage labels;  //!< a number for each room, 0 is no room
    /** Passages between rooms; absent when only the label image is known. */
    std::optional<std::vector<ReferenceInterface>> interfaces;
    double resolution_m = 0;    //!< side of a pixel [m]; set when the interfaces are
    bool doorsReliable = true;  //!< false when the annotation says that its doors were not checked by hand
};
}  // namespace gr2to
