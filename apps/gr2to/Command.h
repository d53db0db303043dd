#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace gr2to::cli
{
/** What the process returns to the shell. */
enum ExitCode
{
    kDone = 0,
    kFailed = 1,   //!< processing failed
    kBadUsage = 2  //!< bad usage or bad input
};

/** A subcommand of `gr2to`. */
class Command
{
 public:
    Command() = default;
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;
    virtual ~Command() = default;

    virtual std::string name() const = 0;
    virtual std::string arguments() const = 0;    //!< for example `INPUT [options]`
    virtual std::string summary() const = 0;      //!< half a line for the list of commands
    virtual std::string description() const = 0;  //!< paragraphs, parted by empty lines
    virtual bool hidden() const { return false; }

    /** Tells the parser the arguments, which it stores in this object. */
    virtual void declare(CLI::App& app) = 0;
    /** Does the work with what was parsed. \return an exit code */
    virtual int run() = 0;
};

using Commands = std::vector<std::unique_ptr<Command>>;

std::unique_ptr<Command> makeExtract();
std::unique_ptr<Command> makeInfo();
std::unique_ptr<Command> makeValidate();
std::unique_ptr<Command> makeCompare();
std::unique_ptr<Command> makeRender();
std::unique_ptr<Command> makeMan();
std::unique_ptr<Command> makeOptions();

/** All commands, in the order in which help lists them. */
Commands allCommands();
}  // namespace gr2to::cli
