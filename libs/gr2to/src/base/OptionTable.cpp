#include "gr2to/base/OptionTable.h"

#include <mrpt/config/CConfigFileBase.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <ostream>
#include <stdexcept>

#include "gr2to/base/text.h"

namespace gr2to
{
namespace
{
template <class T>
bool parseNumber(const std::string& text, T& value)
{
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc() && result.ptr == end;
}

bool parseSwitch(const std::string& text, bool& value)
{
    if (text == "yes" || text == "true" || text == "1" || text == "on") return value = true, true;
    if (text == "no" || text == "false" || text == "0" || text == "off") return value = false, true;
    return false;
}

bool parseNumberOrAuto(const std::string& text, std::optional<double>& value)
{
    if (text == "auto") return value.reset(), true;
    return parseNumber(text, value.emplace());
}

bool parse(const std::string& text, const OptionField::Value& target)
{
    if (auto* const* number = std::get_if<double*>(&target)) return parseNumber(text, **number);
    if (auto* const* integer = std::get_if<int*>(&target)) return parseNumber(text, **integer);
    if (auto* const* toggle = std::get_if<bool*>(&target)) return parseSwitch(text, **toggle);
    if (auto* const* maybe = std::get_if<std::optional<double>*>(&target))
        return parseNumberOrAuto(text, **maybe);
    *std::get<std::string*>(target) = text;
    return true;
}

std::string withUnit(const std::string& text, const std::string& unit)
{
    return unit.empty() ? text : text + " " + unit;
}

void checkField(const std::string& section, const OptionField& field)
{
    const auto complain = [&](const std::string& rule) {
        throw std::invalid_argument(section + "." + field.name + " = " +
                                    withUnit(field.valueText(), field.unit) + " " + rule);
    };
    if (const auto* const* name = std::get_if<std::string*>(&field.value)) {
        if (field.choices.empty()) return;
        if (std::find(field.choices.begin(), field.choices.end(), **name) == field.choices.end())
            complain("must be one of " + field.typeText());
        return;
    }
    double value = 0;
    if (const auto* const* number = std::get_if<double*>(&field.value)) value = **number;
    if (const auto* const* integer = std::get_if<int*>(&field.value)) value = **integer;
    if (const auto* const* maybe = std::get_if<std::optional<double>*>(&field.value)) {
        if (!**maybe) return;
        value = ***maybe;
    }
    if (!std::isfinite(value) || value < field.minimum || value > field.maximum)
        complain("must be within " + field.rangeText());
}
}  // namespace

std::string OptionField::valueText() const
{
    if (const auto* const* number = std::get_if<double*>(&value)) return numberText(**number);
    if (const auto* const* integer = std::get_if<int*>(&value)) return std::to_string(**integer);
    if (const auto* const* toggle = std::get_if<bool*>(&value)) return **toggle ? "yes" : "no";
    if (const auto* const* maybe = std::get_if<std::optional<double>*>(&value))
        return **maybe ? numberText(***maybe) : "auto";
    return *std::get<std::string*>(value);
}

std::string OptionField::typeText() const
{
    if (std::holds_alternative<double*>(value)) return "number";
    if (std::holds_alternative<std::optional<double>*>(value)) return "number|auto";
    if (std::holds_alternative<int*>(value)) return "integer";
    if (std::holds_alternative<bool*>(value)) return "yes|no";
    if (choices.empty()) return "text";
    return std::accumulate(std::next(choices.begin()), choices.end(), choices.front(),
                           [](const std::string& all, const std::string& one) { return all + "|" + one; });
}

std::string OptionField::rangeText() const
{
    if (std::holds_alternative<bool*>(value) || std::holds_alternative<std::string*>(value)) return "";
    if (std::isinf(minimum) && std::isinf(maximum)) return "";
    return (std::isinf(minimum) ? "(-inf" : "[" + numberText(minimum)) + ", " +
           (std::isinf(maximum) ? "inf)" : numberText(maximum) + "]");
}

void OptionTable::set(const std::string& name, const std::string& text)
{
    const std::string key = section() + "." + name;
    const std::vector<OptionField> all = fields();
    const auto field =
        std::find_if(all.begin(), all.end(), [&](const OptionField& f) { return f.name == name; });
    if (field == all.end()) {
        std::vector<std::string> known;
        known.reserve(all.size());
        for (const OptionField& f : all) known.push_back(section() + "." + f.name);
        throw std::invalid_argument("unknown option '" + key + "'; did you mean '" + nearestWord(key, known) +
                                    "'?");
    }
    if (!parse(text, field->value))
        throw std::invalid_argument(key + " = '" + text + "' is not a value of type " + field->typeText());
    checkField(section(), *field);
}

void OptionTable::check() const
{
    for (const auto& field : const_cast<OptionTable*>(this)->fields()) checkField(section(), field);
    checkRules();
}

void OptionTable::loadFromConfigFile(const mrpt::config::CConfigFileBase& source, const std::string& section)
{
    std::vector<std::string> keys;
    source.getAllKeys(section, keys);
    for (const auto& key : keys) set(key, source.read_string(section, key, ""));
    check();
}

void OptionTable::saveToConfigFile(mrpt::config::CConfigFileBase& target, const std::string& section) const
{
    for (const auto& field : const_cast<OptionTable*>(this)->fields())
        target.write(section, field.name, field.valueText());
}

void OptionTable::dumpToTextStream(std::ostream& out) const
{
    for (const auto& field : const_cast<OptionTable*>(this)->fields())
        out << section() << '.' << field.name << " = " << withUnit(field.valueText(), field.unit) << '\n';
}

std::string nearestWord(const std::string& word, const std::vector<std::string>& candidates)
{
    const auto editDistance = [&](const std::string& other) {
        std::vector<std::size_t> row(other.size() + 1);
        std::iota(row.begin(), row.end(), std::size_t{0});
        for (std::size_t i = 1; i <= word.size(); ++i) {
            std::size_t diagonal = row[0];
            row[0] = i;
            for (std::size_t j = 1; j <= other.size(); ++j) {
                const std::size_t substituted = diagonal + (word[i - 1] == other[j - 1] ? 0U : 1U);
                diagonal = row[j];
                row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
            }
        }
        return row.back();
    };
    std::string best;
    std::size_t bestDistance = std::numeric_limits<std::size_t>::max();
    for (const auto& candidate : candidates)
        if (const auto distance = editDistance(candidate); distance < bestDistance) {
            bestDistance = distance;
            best = candidate;
        }
    return best;
}
}  // namespace gr2to
