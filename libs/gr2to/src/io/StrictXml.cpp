#include "StrictXml.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "gr2to/base/errors.h"
#include "gr2to/base/text.h"
#include "xmlPath.h"

namespace gr2to
{
namespace
{
constexpr std::string_view BLANKS = " \t\r\n";

template <class T>
bool parseWhole(std::string_view text, T& value)
{
    const auto pieces = splitAtBlanks(text);
    if (pieces.size() != 1) return false;
    const char* end = pieces[0].data() + pieces[0].size();
    const auto result = std::from_chars(pieces[0].data(), end, value);
    return result.ec == std::errc() && result.ptr == end;
}

std::string joined(std::initializer_list<std::string_view> names, std::string_view separator)
{
    std::string all;
    for (const auto name : names)
        all += (all.empty() ? std::string() : std::string(separator)) + std::string(name);
    return all;
}

bool contains(std::initializer_list<std::string_view> names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}
}  // namespace

void StrictElement::fail(const std::string& complaint) const
{
    throw InputError(*m_file + ": " + xmlPath(m_node) + ": " + complaint);
}

void StrictElement::expectAttributes(std::initializer_list<std::string_view> required,
                                     std::initializer_list<std::string_view> optional) const
{
    std::vector<std::string_view> seen;
    for (const auto attribute : m_node.attributes()) {
        const std::string_view name = attribute.name();
        if (!contains(required, name) && !contains(optional, name))
            fail("attribute " + excerpt(name) + " is unknown; it has " +
                 (required.size() > 0 ? joined(required, ", ") : "no attributes") +
                 (optional.size() > 0 ? " and optionally " + joined(optional, ", ") : ""));
        if (std::find(seen.begin(), seen.end(), name) != seen.end())
            fail("attribute " + std::string(name) + " is there twice");
        seen.push_back(name);
    }
    for (const auto name : required)
        if (std::find(seen.begin(), seen.end(), name) == seen.end())
            fail("attribute " + std::string(name) + " is missing");
}

std::string StrictElement::text(const char* attribute) const
{
    return m_node.attribute(attribute).value();
}

double StrictElement::number(const char* attribute) const
{
    const auto value = optionalNumber(attribute);
    if (!value) fail("attribute " + std::string(attribute) + " is missing");
    return *value;
}

std::optional<double> StrictElement::optionalNumber(const char* attribute) const
{
    if (!m_node.attribute(attribute)) return std::nullopt;
    const auto value = parseFiniteNumber(text(attribute));
    if (!value)
        fail("attribute " + std::string(attribute) + " = " + excerpt(text(attribute)) +
             " is not a finite number");
    return value;
}

std::vector<double> StrictElement::optionalNumbers(const char* attribute, std::size_t count) const
{
    if (!m_node.attribute(attribute)) return {};
    const std::string all = text(attribute);
    const auto pieces = splitAtBlanks(all);
    std::vector<double> numbers;
    for (const auto piece : pieces) {
        const auto value = parseFiniteNumber(piece);
        if (!value)
            fail("attribute " + std::string(attribute) + " has " + excerpt(piece) + ", not a finite number");
        numbers.push_back(*value);
    }
    if (numbers.size() != count)
        fail("attribute " + std::string(attribute) + " has " + std::to_string(numbers.size()) +
             " numbers; it must have " + std::to_string(count));
    return numbers;
}

std::uint32_t StrictElement::id(const char* attribute, std::uint32_t largest) const
{
    std::uint32_t value = 0;
    if (!parseWhole(text(attribute), value) || value == 0 || value > largest)
        fail("attribute " + std::string(attribute) + " = " + excerpt(text(attribute)) +
             " must be a whole number from 1 to " + std::to_string(largest));
    return value;
}

bool StrictElement::flag(const char* attribute) const
{
    return choice(attribute, {"0", "1"}) == 1;
}

std::size_t StrictElement::choice(const char* attribute,
                                  std::initializer_list<std::string_view> choices) const
{
    const auto* const found = std::find(choices.begin(), choices.end(), text(attribute));
    if (found == choices.end())
        fail("attribute " + std::string(attribute) + " = " + excerpt(text(attribute)) + " must be one of " +
             joined(choices, ", "));
    return static_cast<std::size_t>(found - choices.begin());
}

std::vector<StrictElement> StrictElement::childElements() const
{
    std::vector<StrictElement> children;
    for (const auto child : m_node.children())
        if (child.type() == pugi::node_element)
            children.emplace_back(*m_file, child);
        else if (std::string_view(child.value()).find_first_not_of(BLANKS) != std::string_view::npos)
            fail("has the text " + excerpt(child.value()) + "; there may be elements only");
    return children;
}

std::vector<StrictElement> StrictElement::sequence(std::initializer_list<std::string_view> names) const
{
    auto children = childElements();
    for (const auto& child : children)
        if (!contains(names, child.name()))
            child.fail("the element is unknown; " + name() + " has " +
                       (names.size() > 0 ? joined(names, ", ") : "no elements"));
    for (const auto name : names) {
        const auto count = std::count_if(children.begin(), children.end(),
                                         [&](const StrictElement& child) { return child.name() == name; });
        if (count == 0) fail("element " + std::string(name) + " is missing");
        if (count > 1) fail("element " + std::string(name) + " is there " + std::to_string(count) + " times");
    }
    if (!std::equal(children.begin(), children.end(), names.begin(), names.end(),
                    [](const StrictElement& child, std::string_view name) { return child.name() == name; }))
        fail("its elements must come in the order " + joined(names, ", "));
    return children;
}

std::vector<StrictElement> StrictElement::list(std::string_view name) const
{
    expectAttributes({});
    auto children = childElements();
    for (const auto& child : children)
        if (child.name() != name)
            child.fail("the element is unknown; there may be " + std::string(name) + " only");
    return children;
}

std::string StrictElement::content() const
{
    expectAttributes({});
    std::string all;
    for (const auto child : m_node.children()) {
        if (child.type() == pugi::node_element)
            StrictElement(*m_file, child).fail("the element is unknown; there may be text only");
        all += child.value();
    }
    return all;
}

std::optional<double> parseFiniteNumber(std::string_view text)
{
    double value = 0;
    if (!parseWhole(text, value) || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::vector<std::string_view> splitAtBlanks(std::string_view text)
{
    std::vector<std::string_view> pieces;
    for (std::size_t start = text.find_first_not_of(BLANKS); start != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(BLANKS, start), text.size());
        pieces.push_back(text.substr(start, end - start));
        start = text.find_first_not_of(BLANKS, end);
    }
    return pieces;
}
}  // namespace gr2to
