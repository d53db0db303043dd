#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace gr2to::cli
{
/** Parses the arguments of a subcommand whose options are declared in `app`, called by its full name.
 * \return whether help was asked for
 * \throws std::invalid_argument  an unknown option (the nearest is named), an argument too many or too few,
 * an option that is given twice; one line
 */
bool parseArguments(CLI::App& app, std::vector<std::string> arguments);

/** An option with one value that has to be given at most once. */
CLI::Option* addOption(CLI::App& app, const std::string& names, std::string& target,
                       const std::string& metavar, const std::string& description);
}  // namespace gr2to::cli
