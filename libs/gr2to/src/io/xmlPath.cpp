#include "xmlPath.h"

#include <algorithm>
#include <string_view>

namespace gr2to
{
namespace
{
bool isNumber(std::string_view text)
{
    return !text.empty() && text.size() < 12 &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool isList(std::string_view name)
{
    return name == "places" || name == "connections" || name == "walls" || name == "views" || name == "words";
}

std::string step(pugi::xml_node node)
{
    constexpr std::size_t LONGEST = 40;
    std::string name = std::string(node.name()).substr(0, LONGEST);
    if (!isList(node.parent().name())) return name;
    const std::string_view id = node.attribute("id").value();
    const bool hasId = name == "place" || name == "connection";
    if (hasId && isNumber(id)) return name + "[id=" + std::string(id) + "]";
    int index = 1;
    while ((node = node.previous_sibling(name.c_str()))) ++index;
    return name + "[" + std::to_string(index) + "]";
}
}  // namespace

std::string xmlPath(pugi::xml_node node)
{
    std::string path = step(node);
    for (node = node.parent(); node.parent() && node.parent().type() != pugi::node_document;
         node = node.parent())
        path.insert(0, step(node) + "/");
    return path;
}
}  // namespace gr2to
