#include "parse.h"

#include <algorithm>
#include <stdexcept>

#include "gr2to/base/OptionTable.h"

namespace gr2to::cli
{
namespace
{
std::string pointer(const CLI::App& app)
{
    return "; see '" + app.get_name() + " --help'";
}

std::vector<std::string> optionNames(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const auto& name : option->get_lnames()) names.push_back("--" + name);
        for (const auto& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

/** An unknown option goes before a stray argument: the latter is often the former's value. */
void refuseUnknown(const CLI::App& app)
{
    const auto rest = app.remaining();
    if (rest.empty()) return;
    const auto option = std::find_if(
        rest.begin(), rest.end(), [](const std::string& text) { return text.size() > 1 && text[0] == '-'; });
    if (option == rest.end())
        throw std::invalid_argument("unexpected argument '" + rest.front() + "'" + pointer(app));
    const std::string name = option->substr(0, option->find('='));
    throw std::invalid_argument("unknown option '" + name + "'; did you mean '" +
                                nearestWord(name, optionNames(app)) + "'?");
}

void refuseRepeatedOrEmpty(const CLI::App& app)
{
    for (const CLI::Option* option : app.get_options()) {
        const bool isFlag = option->get_expected_max() == 0;
        if (isFlag || option->get_multi_option_policy() != CLI::MultiOptionPolicy::Throw) continue;
        const auto& values = option->results();
        if (values.size() > 1)
            throw std::invalid_argument(option->get_name() + " is given " + std::to_string(values.size()) +
                                        " times; give it once" + pointer(app));
        if (values.size() == 1 && values.front().empty())
            throw std::invalid_argument(option->get_name() + " is empty; it needs a value" + pointer(app));
    }
}

/** What is wrong in one line; CLI11 names the option first when its value lacks. */
std::string wordsOf(const CLI::ParseError& error)
{
    std::string text = error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
        return text.substr(0, text.find(':')) + " needs a value";
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}
}  // namespace

bool parseArguments(CLI::App& app, std::vector<std::string> arguments)
{
    app.allow_extras();
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
    try {
        app.parse(arguments);
    } catch (const CLI::CallForHelp&) {
        return true;
    } catch (const CLI::ParseError& error) {
        refuseUnknown(app);
        refuseRepeatedOrEmpty(app);
        throw std::invalid_argument(wordsOf(error) + pointer(app));
    }
    refuseUnknown(app);
    refuseRepeatedOrEmpty(app);
    return false;
}

CLI::Option* addOption(CLI::App& app, const std::string& names, std::string& target,
                       const std::string& metavar, const std::string& description)
{
    return app.add_option(names, target, description)->type_name(metavar);
}
}  // namespace gr2to::cli
