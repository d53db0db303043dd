#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to::cli
{
using Json = nlohmann::ordered_json;

/** A document for standard output; bytes of file names that are not UTF-8 are replaced. */
std::string jsonText(const Json& json);

/** A number, a switch or a text, as the field is. */
Json valueJson(const OptionField& field);

/** A grid's format, size [cells], resolution [m] and origin ([m], [rad]). */
Json frameJson(const std::string& format, int width, int height, const GridFrame& frame);
}  // namespace gr2to::cli
