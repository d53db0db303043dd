#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <stdexcept>

#include "Command.h"
#include "gr2to/base/OptionTable.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/interruption.h"
#include "help.h"
#include "parse.h"

namespace
{
using namespace gr2to;
using namespace gr2to::cli;

Command& find(const Commands& commands, const std::string& name)
{
    std::vector<std::string> known;
    for (const auto& command : commands) {
        if (command->name() == name) return *command;
        if (!command->hidden()) known.push_back(command->name());
    }
    if (std::error_code ignored; std::filesystem::is_regular_file(name, ignored))
        throw std::invalid_argument("'" + name + "' is a file, not a command; did you mean 'gr2to extract " +
                                    name + "'?");
    if (name[0] == '-')
        throw std::invalid_argument("unknown option '" + name + "' before a command; see 'gr2to --help'");
    throw std::invalid_argument("unknown command '" + name + "'; did you mean '" + nearestWord(name, known) +
                                "'?");
}

int runCommand(const Commands& commands, std::vector<std::string> arguments)
{
    Command& command = find(commands, arguments.front());
    arguments.erase(arguments.begin());
    CLI::App app("", "gr2to " + command.name());
    command.declare(app);
    if (!parseArguments(app, arguments)) return command.run();
    std::cout << helpText(command, app);
    return kDone;
}

int run(std::vector<std::string> arguments)
{
    const Commands commands = allCommands();
    if (arguments.empty())
        throw std::invalid_argument(
            "no command is given; to begin: gr2to extract MAP.yaml; 'gr2to --help' lists the commands");
    if (arguments.size() > 1 && arguments[0] == "help") arguments = {arguments[1], "--help"};
    const std::string& first = arguments.front();
    int code = kDone;
    if (first == "-h" || first == "--help" || first == "help")
        std::cout << overviewText(commands);
    else if (first == "--version")
        std::cout << "gr2to " << GR2TO_VERSION << '\n';
    else
        code = runCommand(commands, arguments);
    if (!std::cout.flush()) throw OutputError("cannot write to standard output");
    return code;
}

/** A foreign message or a file's name may hold line ends; an error is one line. */
int complain(int code, std::string message)
{
    for (char& c : message)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    std::cerr << "gr2to: error: " << message << '\n';
    return code;
}
}  // namespace

int main(int argc, char** argv)
{
    removeUnfinishedOutputOnSignals();
    std::signal(SIGXFSZ, SIG_IGN);  // a file over the user's limit is an error to report, not a reason to die
    try {
        return run({argv + 1, argv + argc});
    } catch (const InputError& error) {
        return complain(kBadUsage, error.what());
    } catch (const std::invalid_argument& error) {
        return complain(kBadUsage, error.what());
    } catch (const std::bad_alloc&) {
        return complain(kFailed, "out of memory; free some, or give a map of fewer cells");
    } catch (const std::exception& error) {
        return complain(kFailed, error.what());
    }
}
