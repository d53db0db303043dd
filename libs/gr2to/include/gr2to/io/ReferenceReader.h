#pragma once

#include <filesystem>

#include "gr2to/topology/ReferenceAnnotation.h"

namespace gr2to
{
/** Reads an annotated map: `NAME.gt_labels.png` and, where it exists, `NAME.gt.json`; either may be named.
 *
 * Any other image is read as a label image without interfaces. Of the JSON file these are read:
 *     resolution_m   side of a pixel [m]
 *     size_px        optional [width, height], must be those of the image
 *     doors_reliable optional, false when the doors were not checked
 *     interfaces     list of {kind: door|opening|slit, a, b: labels, mid_px: [x, y], width_m}
 * \throws InputError  a file is missing or damaged (see readLabelImage), or the two contradict each other
 */
ReferenceAnnotation readReference(const std::filesystem::path& path);
}  // namespace gr2to
