#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "io/ImageRule.h"

namespace gr2to::io
{
/** The keys of a ROS map_server YAML file; those that the file lacks are empty. */
struct RosYaml
{
    std::filesystem::path image;  //!< as a path to open
    double origin_x_m = 0.0;
    double origin_y_m = 0.0;
    double yaw_rad = 0.0;
    std::optional<double> resolution_m;
    std::optional<double> occupied_threshold;
    std::optional<double> free_threshold;
    std::optional<bool> negate;
    std::optional<ImageMode> mode;
};

/** Parses and checks the text of a map_server YAML file; the image is not opened.
 * \param path  of the YAML file: relative image paths start from its folder
 * \throws InputError  malformed text, a lacking `image` or `origin`, a value of the wrong type or range, an
 * image path that leads out of the folder
 */
RosYaml parseRosYaml(std::string_view text, const std::filesystem::path& path);

/** The mode of that name. \throws std::invalid_argument  unknown name */
ImageMode imageModeOf(std::string_view name);
}  // namespace gr2to::io
