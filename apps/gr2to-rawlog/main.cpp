#include <mrpt/config/CConfigFileMemory.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "IcpMapper.h"
#include "ProgressBar.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/base/interruption.h"
#include "gr2to/io/RawlogReader.h"
#include "gr2to/io/ScanOptions.h"
#include "gr2to/mrpt/registerAllClasses.h"
#include "gr2to/mrpt/simplemap.h"

namespace
{
using namespace gr2to;
namespace fs = std::filesystem;

enum ExitCode
{
    kDone = 0,
    kFailed = 1,
    kBadUsage = 2
};

struct Arguments
{
    std::string input;
    std::string output;
    std::string config;
    std::string plugins;
    bool quiet = false;
    bool progress = false;
};

void declare(CLI::App& app, Arguments& arguments)
{
    app.add_option("INPUT", arguments.input, "The rawlog, compressed or not.")->required();
    app.add_option("-o,--output", arguments.output,
                   "The simplemap to write. (default: INPUT's name with .simplemap, in the current folder)")
        ->type_name("FILE");
    app.add_option("-c,--config", arguments.config,
                   "Options in MRPT's ini style, sections [ICP] and [MappingApplication] as MRPT's icp-slam "
                   "reads them; share/gr2to/rawlog.ini has the defaults.")
        ->type_name("FILE");
    app.add_option("--plugins", arguments.plugins,
                   "Libraries, parted by commas, to load for classes that MRPT does not have.")
        ->type_name("LIBS");
    app.add_flag("-q,--quiet", arguments.quiet, "Print neither summary nor progress.");
    app.add_flag("--progress", arguments.progress, "Show progress even when not on a terminal.");
    app.set_version_flag("--version", "gr2to-rawlog " GR2TO_VERSION);
}

std::string listOf(const std::map<std::string, std::size_t>& classes)
{
    std::string text;
    for (const auto& [name, count] : classes)
        text.append(text.empty() ? "" : ", ").append(std::to_string(count)).append(" ").append(name);
    return text.empty() ? "none" : text;
}

int run(Arguments& arguments)
{
    registerAllClasses();
    TScanOptions scans;
    scans.plugins = arguments.plugins;
    scans.loadPlugins();
    const fs::path input = arguments.input;
    if (arguments.output.empty())
        arguments.output = input.filename().replace_extension(".simplemap").string();
    if (std::error_code ignored; fs::equivalent(input, arguments.output, ignored))
        throw InputError("the output '" + arguments.output + "' would replace the input; choose another");
    const std::string ini = arguments.config.empty() ? "" : readFile(arguments.config);
    OutputTransaction files;
    const fs::path staged = files.stage(arguments.output);

    rawlog::IcpMapper mapper((mrpt::config::CConfigFileMemory(ini)));
    RawlogReader reader(input);
    {
        rawlog::ProgressBar bar(!arguments.quiet && (arguments.progress || isatty(STDERR_FILENO) != 0));
        while (const auto entry = reader.next()) {
            mapper.process(entry);
            bar.show(reader.progress());
        }
    }
    const auto map = mapper.map();
    const std::string& warning = reader.warning();
    if (mapper.scans() == 0 || map.empty())
        throw InputError((warning.empty() ? "'" + input.string() + "'" : warning + ", but it") +
                         " has no observation that can be mapped among its " +
                         std::to_string(reader.entries()) + " entries; it holds these observations: " +
                         listOf(mapper.ignored()) + "; laser scans or range images are needed");
    if (!warning.empty()) std::cerr << "gr2to-rawlog: warning: " << warning << '\n';
    writeFile(staged, encodeSimplemap(map));
    files.commit();
    if (!arguments.quiet)
        std::cout << arguments.output << ": " << map.size() << " keyframes of " << mapper.scans()
                  << " scans in " << reader.entries() << " entries; not used: " << listOf(mapper.ignored())
                  << '\n';
    return kDone;
}

int complain(int code, std::string message)
{
    for (char& c : message)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    std::cerr << "gr2to-rawlog: error: " << message << '\n';
    return code;
}
}  // namespace

int main(int argc, char** argv)
{
    CLI::App app(
        "Makes a simplemap of an MRPT rawlog: the robot's path and map by ICP on laser scans and "
        "odometry. 'gr2to extract' reads it, and calls this program for a rawlog by itself.",
        "gr2to-rawlog");
    Arguments arguments;
    declare(app, arguments);
    try {
        app.parse(argc, argv);
        return run(arguments);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return complain(kBadUsage, std::string(error.what()) + "; see gr2to-rawlog --help");
    } catch (const InputError& error) {
        return complain(kBadUsage, error.what());
    } catch (const std::exception& error) {
        return complain(kFailed, error.what());
    }
}
