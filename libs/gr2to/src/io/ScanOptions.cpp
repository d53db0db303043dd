#include "gr2to/io/ScanOptions.h"

#include <mrpt/core/bits_math.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/system/os.h>

#include "gr2to/base/errors.h"
#include "io/errorText.h"

namespace gr2to
{
std::vector<OptionField> TScanOptions::fields()
{
    return {
        {"max_range", &max_range, "m", "Cells farther than this from the sensor are left as they are.", 0.1,
         1000},
        {"certainty", &certainty, "ratio", "Probability of being occupied that one hit gives a cell.", 0.51,
         0.99},
        {"max_tilt", &max_tilt, "deg",
         "Scans whose sensor is pitched or rolled by more than this are not inserted.", 0, 45},
        {"no_echo_is_free", &no_echo_is_free, "",
         "Whether rays without an echo free the cells along half the range of the last echo before "
         "them."},
        {"wide_beams", &wide_beams, "", "Whether a ray is a sector as wide as the angle to the next ray."},
        {"plugins", &plugins, "",
         "Libraries, parted by commas, to load for classes of observations that MRPT does not have."},
        {"views", &views, "", "Whether images become views of the places that they were taken in."}};
}

void TScanOptions::applyTo(mrpt::maps::COccupancyGridMap2D& grid) const
{
    auto& insertion = grid.insertionOptions;
    insertion.maxDistanceInsertion = static_cast<float>(max_range);
    insertion.maxOccupancyUpdateCertainty = static_cast<float>(certainty);
    insertion.horizontalTolerance = static_cast<float>(mrpt::DEG2RAD(max_tilt));
    insertion.considerInvalidRangesAsFreeSpace = no_echo_is_free;
    insertion.wideningBeamsWithDistance = wide_beams;
}

void TScanOptions::loadPlugins() const
{
    if (plugins.empty()) return;
    std::string trouble;
    if (!mrpt::system::loadPluginModules(plugins, trouble))
        throw InputError("scans.plugins = " + io::inQuotes(plugins) + " cannot be loaded (" +
                         io::firstSentence(trouble) + "); name existing libraries, parted by commas");
}
}  // namespace gr2to
