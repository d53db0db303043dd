#include "gr2to/io/ReferenceReader.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/io/LabelImageReader.h"

namespace gr2to
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kLabelsEnding = ".gt_labels.png";
const std::string kJsonEnding = ".gt.json";

bool endsWith(const std::string& text, const std::string& ending)
{
    return text.size() >= ending.size() &&
           text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/** The file that shares its name but for the ending. */
fs::path sibling(const fs::path& path, const std::string& ending, const std::string& otherEnding)
{
    const std::string text = path.string();
    return text.substr(0, text.size() - ending.size()) + otherEnding;
}

/** A value within the JSON file that can say where it stands. */
class Node
{
 public:
    Node(const Json& json, const std::string& file, std::string place)
        : m_json(json), m_file(file), m_place(std::move(place))
    {
    }

    [[noreturn]] void fail(const std::string& rule) const
    {
        throw InputError("'" + m_file + "': " + (m_place.empty() ? "the file" : m_place) + " " + rule);
    }
    bool has(const std::string& key) const { return m_json.is_object() && m_json.contains(key); }
    Node operator[](const std::string& key) const
    {
        if (!m_json.is_object()) fail("must be an object");
        if (!m_json.contains(key)) fail("has no '" + key + "'");
        return {m_json.at(key), m_file, m_place.empty() ? key : m_place + "." + key};
    }
    Node operator[](std::size_t i) const
    {
        return {m_json.at(i), m_file, m_place + "[" + std::to_string(i) + "]"};
    }
    std::size_t listSize() const
    {
        if (!m_json.is_array()) fail("must be a list");
        return m_json.size();
    }
    double number() const
    {
        if (!m_json.is_number()) fail("must be a number");
        return m_json.get<double>();
    }
    Eigen::Vector2d pair() const
    {
        if (listSize() != 2) fail("must be a list of two numbers");
        return {(*this)[0].number(), (*this)[1].number()};
    }
    std::string text() const
    {
        if (!m_json.is_string()) fail("must be a text");
        return m_json.get<std::string>();
    }
    bool toggle() const
    {
        if (!m_json.is_boolean()) fail("must be true or false");
        return m_json.get<bool>();
    }

 private:
    const Json& m_json;
    const std::string& m_file;
    std::string m_place;
};

/** Finds the id that a label of the file has in memory. */
class Labels
{
 public:
    explicit Labels(const LabelImage& image) : m_values(image.values), m_occurs(65536, false)
    {
        for (const PlaceId id : image.labels.ids) m_occurs[id] = true;
    }
    PlaceId idOf(const Node& node) const
    {
        const double label = node.number();
        std::size_t id = 0;
        if (m_values.empty())
            id = label >= 1 && label <= 65535 ? static_cast<std::size_t>(label) : 0;
        else if (const auto at = std::find(m_values.begin(), m_values.end(), label); at != m_values.end())
            id = static_cast<std::size_t>(at - m_values.begin());
        if (id == 0 || std::floor(label) != label || !m_occurs[id])
            node.fail("must be a label that occurs in the label image");
        return static_cast<PlaceId>(id);
    }

 private:
    const std::vector<std::uint32_t>& m_values;
    std::vector<bool> m_occurs;
};

InterfaceKind readKind(const Node& node)
{
    const std::string kind = node.text();
    if (kind == "door") return InterfaceKind::Door;
    if (kind == "opening") return InterfaceKind::Opening;
    if (kind != "slit") node.fail("must be one of door, opening and slit");
    return InterfaceKind::Slit;
}

ReferenceInterface readInterface(const Node& node, const Labels& labels)
{
    ReferenceInterface interface;
    interface.kind = readKind(node["kind"]);
    const PlaceId a = labels.idOf(node["a"]), b = labels.idOf(node["b"]);
    if (a == b) node.fail("must join two different rooms");
    interface.a = std::min(a, b);
    interface.b = std::max(a, b);
    interface.mid_px = node["mid_px"].pair();
    interface.width_m = node["width_m"].number();
    if (interface.width_m < 0) node["width_m"].fail("must not be negative");
    return interface;
}

void readInterfaces(const fs::path& path, const LabelImage& image, ReferenceAnnotation& reference)
{
    const std::string file = path.string();
    const Json json = Json::parse(readFile(path), nullptr, false);
    if (json.is_discarded()) throw InputError("'" + file + "' is not valid JSON; an annotation must be");
    const Node root(json, file, "");
    reference.resolution_m = root["resolution_m"].number();
    if (!(reference.resolution_m > 0)) root["resolution_m"].fail("must be positive");
    if (root.has("doors_reliable")) reference.doorsReliable = root["doors_reliable"].toggle();
    if (root.has("size_px") &&
        root["size_px"].pair() != Eigen::Vector2d(reference.labels.width, reference.labels.height))
        root["size_px"].fail("must be the label image's " + std::to_string(reference.labels.width) + " x " +
                             std::to_string(reference.labels.height));
    const Labels labels(image);
    const Node list = root["interfaces"];
    reference.interfaces.emplace();
    for (std::size_t i = 0; i < list.listSize(); ++i)
        reference.interfaces->push_back(readInterface(list[i], labels));
}
}  // namespace

ReferenceAnnotation readReference(const fs::path& path)
{
    const bool isJson = endsWith(path.string(), kJsonEnding);
    if (!isJson && path.extension() == ".json")
        throw InputError("'" + path.string() +
                         "' must be called NAME.gt.json and have NAME.gt_labels.png beside it");
    const fs::path labelsPath = isJson ? sibling(path, kJsonEnding, kLabelsEnding) : path;
    if (isJson && !fs::exists(labelsPath))
        throw InputError("'" + path.string() + "' needs its label image '" + labelsPath.filename().string() +
                         "' beside it");
    LabelImage image = readLabelImage(labelsPath);
    ReferenceAnnotation reference;
    reference.labels = image.labels;
    const fs::path jsonPath = endsWith(labelsPath.string(), kLabelsEnding)
                                  ? sibling(labelsPath, kLabelsEnding, kJsonEnding)
                                  : fs::path();
    if (isJson || (!jsonPath.empty() && fs::exists(jsonPath))) readInterfaces(jsonPath, image, reference);
    return reference;
}
}  // namespace gr2to
