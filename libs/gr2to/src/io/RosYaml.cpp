#include "io/RosYaml.h"

#include <yaml-cpp/yaml.h>

#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>

#include "gr2to/base/errors.h"
#include "io/errorText.h"

namespace gr2to::io
{
namespace fs = std::filesystem;

namespace
{
// A map's YAML has a dozen lines; the bound keeps the parser away from data that merely look like text.
constexpr std::size_t kLongestYaml = std::size_t{1} << 20U;

bool parseFinite(const std::string& text, double& value)
{
    const char* begin = text.data() + (!text.empty() && text.front() == '+' ? 1 : 0);
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(begin, end, value);
    return result.ec == std::errc() && result.ptr == end && std::isfinite(value);
}

/** The keys of the file's mapping, with the complaints that name them. */
class Keys
{
 public:
    Keys(std::string_view text, std::string name) : m_name(std::move(name))
    {
        YAML::Node root;
        if (text.size() > kLongestYaml) throw InputError(m_name + " is too long for a map's YAML file");
        try {
            root = YAML::Load(std::string(text));
        } catch (const YAML::Exception& e) {
            throw InputError(m_name + " line " + std::to_string(e.mark.line + 1) +
                             " is not valid YAML: " + firstSentence(e.msg));
        }
        if (!root.IsMap())
            throw InputError(
                m_name + " is neither an image nor an MRPT grid nor a ROS map YAML; a YAML file has lines " +
                "such as 'image: map.pgm'");
        for (const auto& entry : root) {
            if (!entry.first.IsScalar()) continue;
            if (!m_nodes.emplace(entry.first.Scalar(), entry.second).second)
                throw InputError(m_name + " has the key " + inQuotes(entry.first.Scalar()) +
                                 " twice; keep one");
        }
    }

    const YAML::Node* find(const std::string& key) const
    {
        const auto at = m_nodes.find(key);
        return at == m_nodes.end() ? nullptr : &at->second;
    }

    const YAML::Node& require(const std::string& key, const std::string& example) const
    {
        if (const auto* node = find(key)) return *node;
        throw InputError(m_name + " lacks the key '" + key + "'; add a line such as '" + key + ": " +
                         example + "'");
    }

    [[noreturn]] void complain(const std::string& key, const YAML::Node& node, const std::string& rule) const
    {
        const std::string value =
            node.IsScalar() ? " = " + inQuotes(node.Scalar()) : std::string(" is no single value;");
        throw InputError(m_name + ": " + key + value + (node.IsScalar() ? " " : " it ") + rule);
    }

    double number(const std::string& key, const YAML::Node& node, const std::string& rule) const
    {
        double value = 0;
        if (!node.IsScalar() || !parseFinite(node.Scalar(), value)) complain(key, node, rule);
        return value;
    }

    std::optional<double> threshold(const std::string& key) const
    {
        const auto* node = find(key);
        if (node == nullptr) return {};
        const std::string rule = "must be a number within [0, 1]";
        const double value = number(key, *node, rule);
        if (value < 0 || value > 1) complain(key, *node, rule);
        return value;
    }

    std::optional<double> resolution() const
    {
        const auto* node = find("resolution");
        if (node == nullptr) return {};
        const std::string rule = "must be a positive number of metres per cell, such as 0.05";
        const double value = number("resolution", *node, rule);
        if (value <= 0) complain("resolution", *node, rule);
        return value;
    }

    std::optional<bool> negate() const
    {
        const auto* node = find("negate");
        if (node == nullptr) return {};
        const std::string text = node->IsScalar() ? node->Scalar() : "";
        if (text == "1" || text == "true") return true;
        if (text == "0" || text == "false") return false;
        complain("negate", *node, "must be 0 (black is occupied) or 1 (white is occupied)");
    }

    std::optional<ImageMode> mode() const
    {
        const auto* node = find("mode");
        if (node == nullptr) return {};
        try {
            return imageModeOf(node->IsScalar() ? node->Scalar() : "");
        } catch (const std::invalid_argument&) {
            complain("mode", *node, "must be trinary, scale or raw");
        }
    }

    fs::path image(const fs::path& folder) const
    {
        const YAML::Node& node = require("image", "map.pgm");
        if (!node.IsScalar() || node.Scalar().empty() || node.IsNull())
            complain("image", node, "must be the path of a PGM or PNG image");
        fs::path stated(node.Scalar());
        if (stated.is_absolute()) return stated;
        const fs::path normal = stated.lexically_normal();
        if (!normal.empty() && *normal.begin() == "..")
            complain("image", node,
                     "leads out of the YAML's folder; move the image beside it or give an absolute path");
        return folder / stated;
    }

    void origin(RosYaml& yaml) const
    {
        const YAML::Node& node = require("origin", "[-10.0, -10.0, 0.0]");
        const std::string rule = "must be [x, y, yaw]: three finite numbers in metres, metres and radians";
        if (!node.IsSequence() || node.size() != 3) complain("origin", node, rule);
        yaml.origin_x_m = number("origin", node[0], rule);
        yaml.origin_y_m = number("origin", node[1], rule);
        yaml.yaw_rad = number("origin", node[2], rule);
    }

 private:
    std::string m_name;
    std::map<std::string, YAML::Node> m_nodes;
};
}  // namespace

RosYaml parseRosYaml(std::string_view text, const fs::path& path)
{
    const Keys keys(text, pathInQuotes(path));
    RosYaml yaml;
    yaml.image = keys.image(path.parent_path());
    keys.origin(yaml);
    yaml.resolution_m = keys.resolution();
    yaml.occupied_threshold = keys.threshold("occupied_thresh");
    yaml.free_threshold = keys.threshold("free_thresh");
    yaml.negate = keys.negate();
    yaml.mode = keys.mode();
    return yaml;
}

ImageMode imageModeOf(std::string_view name)
{
    if (name == "trinary") return ImageMode::Trinary;
    if (name == "scale") return ImageMode::Scale;
    if (name == "raw") return ImageMode::Raw;
    throw std::invalid_argument("the image mode is " + inQuotes(name) + "; it must be trinary, scale or raw");
}
}  // namespace gr2to::io
