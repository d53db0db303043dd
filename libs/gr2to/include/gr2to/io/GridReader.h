#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/io/CapturedViews.h"
#include "gr2to/io/ScanOptions.h"

namespace gr2to
{
/** How a 2D map file becomes free, occupied and unknown cells; section `input`.
 *
 * The rule for every field but `unknown_grey`: what is given here wins over the file; what is left at `auto`
 * is taken from the file; what the file format does not state has the default given with the field. A field
 * that cannot apply to the file (`negate` of an MRPT grid, another resolution than the one that an MRPT grid
 * is stored with) is an error, not ignored.
 *
 * With p the occupancy probability of a cell, as in ROS's map_server: occupied when p > occupied_threshold,
 * free when p < free_threshold, else unknown; both comparisons are strict.
 */
struct TGridReaderOptions : OptionTable
{
    /** Side of a cell [m]. A bare image does not state it, so that it must be given there; of a simplemap's
     * grid it is a choice, 0.05 when it is not given. */
    std::optional<double> resolution;
    /** Default 0.65. */
    std::optional<double> occupied_threshold;
    /** Default 0.196 for images, ROS's value, just below the 50/255 = 0.19608 of the grey 205 that map savers
     * write for unknown cells; 0.35 for MRPT grids, which mirrors 0.65; 0.4 for simplemaps, where one ray
     * through a cell leaves 0.37. */
    std::optional<double> free_threshold;
    /** `auto`, `yes` (white is occupied: p = grey) or `no` (black is occupied: p = 1 - grey), the default. */
    std::string negate = "auto";
    /** `auto`, `trinary` (default), `scale` or `raw` (8-bit greys 0-100 are per cent occupied, above is
     * unknown). `trinary` and `scale` differ in `unknown_grey` alone, because only three states leave the
     * reader. */
    std::string mode = "auto";
    /** Grey [0-255] that means unknown in a trinary, not negated image, whatever the thresholds; -1 for none.
     * Map savers write 205; without this rule a file that says `free_thresh: 0.25` (ROS 2's saver) loads as
     * free. */
    int unknown_grey = 205;
    /** A table of its own: how a simplemap's observations are inserted. */
    TScanOptions scans;

    std::string section() const override { return "input"; }
    std::vector<OptionField> fields() override;

 protected:
    void checkRules() const override;
};

/** What a simplemap held. */
struct ScanCounts
{
    std::size_t keyframes = 0;
    std::size_t observations = 0;
    std::size_t inserted = 0;       //!< observations that the grid could take
    std::size_t missingImages = 0;  //!< files of images that could not be read
};

/** How a grid was read, for people. */
struct GridSource
{
    std::string format;           //!< for example `PNG image` or `ROS map_server YAML`
    std::filesystem::path image;  //!< the image that a YAML names; empty for other formats
    double occupied_threshold = 0.0;
    double free_threshold = 0.0;
    std::optional<ScanCounts> scans;  //!< of a simplemap
    std::vector<CapturedView> views;  //!< of a simplemap, when TScanOptions::views
};

/** Reads a 2D map; the format is told by the content, not by the name.
 *
 * - PNG: grey of 1-16 bits, palette, RGB (mean of the channels); a pixel that is not fully opaque is unknown,
 * in every mode. PGM: P2 and P5, maximum up to 65535. Row 0 of the image is the top. A bare image has its
 * bottom-left corner at the map frame's origin, x right, y up.
 * - ROS map_server YAML with the keys image, resolution, origin [x, y, yaw], occupied_thresh, free_thresh,
 * negate and, optionally, mode; the yaw turns the grid (GridFrame::yaw_rad). The image is relative to the
 * YAML's folder and may not lead out of it, or absolute. Other keys are ignored, as in ROS. A key may lack
 * when the option is given.
 * - MRPT archive of a COccupancyGridMap2D, compressed by gzip (`.gridmap.gz`, `.gridmap`) or not; log-odds 0
 * is unknown.
 * - MRPT archive of a CSimpleMap (`.simplemap`, `.simplemap.gz`): the grid that MRPT's own insertion makes of
 * the observations at the means of their poses; see TScanOptions.
 *
 * \param source  when given, receives how the file was read
 * \throws InputError  the file cannot be read, is truncated or malformed, is of an unknown or unsupported
 * kind (3D maps, rawlogs), claims a size that it cannot hold, or lacks a resolution; one line
 * that names the file \throws std::invalid_argument  an option is out of range Cost: linear; peak memory of a
 * plain image is the file and one byte a cell, of an MRPT grid three bytes a cell.
 */
ClassifiedGrid readGrid(const std::filesystem::path& path, const TGridReaderOptions& options,
                        GridSource* source = nullptr);

/** Whether the file begins as an MRPT rawlog does, which `gr2to-rawlog` makes a simplemap of.
 * \throws InputError  the file cannot be read
 */
bool isRawlog(const std::filesystem::path& path);

/** The folder that MRPT expects the images in that a rawlog or simplemap stores outside of itself. */
std::filesystem::path imagesFolderOf(const std::filesystem::path& file);

/** Refuses a grid from which no topology can be made: one cell wide, or without a free or an occupied cell.
 * \param name  names the grid in the message, usually the file
 * \throws InputError  one line
 */
void requireUsable(const ClassifiedGrid& grid, const std::string& name);
}  // namespace gr2to
