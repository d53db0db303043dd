#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "Command.h"

namespace gr2to::cli
{
/** What `gr2to --help` prints. */
std::string overviewText(const Commands& commands);

/** What `gr2to COMMAND --help` prints; the command is declared in `app`. */
std::string helpText(const Command& command, const CLI::App& app);

/** How an option is written, for example `-o, --output DIR`; a positional argument by its name. */
std::string optionSyntax(const CLI::Option& option);

/** The options of a command by group, positional arguments first and the others in the order of declaration.
 */
std::vector<std::pair<std::string, std::vector<const CLI::Option*>>> optionGroups(const CLI::App& app);

/** Lines of at most 80 characters, each after `indent` blanks; paragraphs are parted by empty lines. */
std::string wrapped(const std::string& text, std::size_t indent);

/** What every command has in common: coordinates, exit codes. */
extern const char* const kExitCodes;
}  // namespace gr2to::cli
