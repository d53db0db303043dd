#include "json.h"

namespace gr2to::cli
{
std::string jsonText(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json valueJson(const OptionField& field)
{
    if (const auto* const* number = std::get_if<double*>(&field.value)) return **number;
    if (const auto* const* integer = std::get_if<int*>(&field.value)) return **integer;
    if (const auto* const* toggle = std::get_if<bool*>(&field.value)) return **toggle;
    if (const auto* const* maybe = std::get_if<std::optional<double>*>(&field.value))
        return **maybe ? Json(***maybe) : Json("auto");
    return *std::get<std::string*>(field.value);
}

Json frameJson(const std::string& format, int width, int height, const GridFrame& frame)
{
    return {{"format", format},
            {"width", width},
            {"height", height},
            {"resolution_m", frame.resolution_m},
            {"origin", {{"x_m", frame.origin_x_m}, {"y_m", frame.origin_y_m}, {"yaw_rad", frame.yaw_rad}}}};
}
}  // namespace gr2to::cli
