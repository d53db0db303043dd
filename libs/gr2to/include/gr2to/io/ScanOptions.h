#pragma once

#include <filesystem>
#include <string>

#include "gr2to/base/OptionTable.h"

namespace mrpt::maps
{
class COccupancyGridMap2D;
}

namespace gr2to
{
/** How the observations of a simplemap become an occupancy grid; section `scans`.
 *
 * All but `plugins` and those of views are MRPT's own insertion options of an occupancy grid, with MRPT's
 * defaults.
 */
struct TScanOptions : OptionTable
{
    /** Cells farther than this from the sensor are left as they are [m]. */
    double max_range = 15.0;
    /** Probability of being occupied that one hit gives a cell, [0.51, 0.99]. */
    double certainty = 0.65;
    /** Scans whose sensor is pitched or rolled by more than this are not inserted [deg]. */
    double max_tilt = 0.05;
    /** Whether rays without an echo free the cells along half the range of the last echo before them. */
    bool no_echo_is_free = true;
    /** Whether a ray is a sector as wide as the angle to the next ray. */
    bool wide_beams = false;
    /** Libraries to load first, parted by commas, for classes that neither MRPT nor this library has. */
    std::string plugins;
    /** Whether images become views. */
    bool views = true;
    /** Where images that are stored outside of the file lie; empty for where MRPT looks for them, beside the
     * file in `NAME_Images` or `Images`. No field of the table. */
    std::filesystem::path imagesFolder;

    std::string section() const override { return "scans"; }
    std::vector<OptionField> fields() override;

    /** Sets the grid's insertion options. */
    void applyTo(mrpt::maps::COccupancyGridMap2D& grid) const;
    /** Loads the libraries, each once. \throws InputError  one cannot be loaded */
    void loadPlugins() const;
};
}  // namespace gr2to
