#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "support/inputFiles.h"

namespace gr2to::test
{
/** What a run of a program left behind. */
struct CliRun
{
    int code = -1;  //!< exit code; 128 + n when signal n ended it
    std::string out;
    std::string err;
};

/** Runs `gr2to` in a folder.
 * \param before  shell commands that prepare the process, for example `ulimit -f 8`
 */
CliRun runCli(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
              const std::string& before = "");

/** The same for any program. \param program  path, or name on the PATH */
CliRun runProgram(const std::string& program, const std::filesystem::path& folder,
                  const std::vector<std::string>& arguments, const std::string& before = "");

/** Text as one word of a shell. */
std::string quoted(const std::string& text);

/** Every file below a folder with its bytes; folders end in '/'. */
std::map<std::string, std::string> contentOf(const std::filesystem::path& folder);

/** Writes rooms.png and rooms.yaml: two rooms of 8 m x 5 m in all at 0.1 m a cell, joined by a door 0.9 m
 * wide. */
void writeRooms(const TempFolder& folder);
/** The same grid. */
ClassifiedGrid roomsGrid();

/** Expects exit code 2 and one line on standard error that has all the words, and nothing on standard output.
 */
void expectBadUsage(const CliRun& run, const std::vector<std::string>& words);

/** Names of the files that `gr2to extract` writes. */
std::vector<std::string> extractedFiles();
}  // namespace gr2to::test
