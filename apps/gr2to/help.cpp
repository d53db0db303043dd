#include "help.h"

#include <algorithm>
#include <sstream>

namespace gr2to::cli
{
const char* const kExitCodes =
    "0 done; 1 processing failed, for example because the disk is full; 2 bad usage or bad input.";

namespace
{
std::string padded(const std::string& text, std::size_t width)
{
    return text + std::string(text.size() < width ? width - text.size() : 1, ' ');
}

std::string joined(const std::vector<std::string>& words, const std::string& between)
{
    std::string all;
    for (const auto& word : words) all += (all.empty() ? "" : between) + word;
    return all;
}
}  // namespace

std::string wrapped(const std::string& text, std::size_t indent)
{
    constexpr std::size_t WIDTH = 80;
    std::string out;
    std::istringstream paragraphs(text);
    for (std::string paragraph; std::getline(paragraphs, paragraph);) {
        std::string line;
        const auto flush = [&] {
            out += line.empty() ? "\n" : std::string(indent, ' ') + line + "\n";
            line.clear();
        };
        std::istringstream words(paragraph);
        for (std::string word; words >> word;) {
            if (!line.empty() && indent + line.size() + 1 + word.size() > WIDTH) flush();
            line += (line.empty() ? "" : " ") + word;
        }
        flush();
    }
    return out;
}

std::string optionSyntax(const CLI::Option& option)
{
    if (option.get_positional()) return option.get_name(true, false);
    std::vector<std::string> names;
    for (const auto& name : option.get_snames()) names.push_back("-" + name);
    for (const auto& name : option.get_lnames()) names.push_back("--" + name);
    const bool isFlag = option.get_expected_max() == 0;
    return joined(names, ", ") + (isFlag ? "" : " " + option.get_type_name());
}

std::vector<std::pair<std::string, std::vector<const CLI::Option*>>> optionGroups(const CLI::App& app)
{
    std::vector<std::pair<std::string, std::vector<const CLI::Option*>>> groups = {{"Arguments", {}}};
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = option->get_positional() ? "Arguments" : option->get_group();
        if (name.empty()) continue;
        auto group =
            std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == name; });
        if (group == groups.end()) group = groups.insert(groups.end(), {name, {}});
        group->second.push_back(option);
    }
    if (groups.front().second.empty()) groups.erase(groups.begin());
    return groups;
}

std::string overviewText(const Commands& commands)
{
    std::string text = "gr2to " GR2TO_VERSION
                       ": topological maps of places, doors and walls from the occupancy grids of robots\n\n"
                       "Usage: gr2to COMMAND ...\n\nCommands:\n";
    for (const auto& command : commands)
        if (!command->hidden()) text += "  " + padded(command->name(), 12) + command->summary() + "\n";
    return text +
           "\nOptions:\n"
           "  -h, --help    what a command does and its options: gr2to COMMAND --help\n"
           "  --version     the version\n\n"
           "To begin: gr2to extract office.yaml -o out, then open out/overlay.svg in a browser.\n" +
           wrapped(std::string("Exit codes: ") + kExitCodes, 0);
}

std::string helpText(const Command& command, const CLI::App& app)
{
    std::string text = "Usage: gr2to " + command.name() + " " + command.arguments() + "\n\n" +
                       wrapped(command.description(), 0);
    for (const auto& [group, options] : optionGroups(app)) {
        text += "\n" + group + ":\n";
        for (const CLI::Option* option : options)
            text += "  " + optionSyntax(*option) + "\n" + wrapped(option->get_description(), 8);
    }
    return text + "\n" + wrapped(std::string("Exit codes: ") + kExitCodes, 0);
}
}  // namespace gr2to::cli
