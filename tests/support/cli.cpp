#include "support/cli.h"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "gr2to/base/files.h"
#include "gr2to/io/PngWriter.h"
#include "gr2to/io/RosMapWriter.h"

namespace gr2to::test
{
namespace fs = std::filesystem;

namespace
{
std::string textOf(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}
}  // namespace

CliRun runCli(const fs::path& folder, const std::vector<std::string>& arguments, const std::string& before)
{
    return runProgram(GR2TO_CLI, folder, arguments, before);
}

CliRun runProgram(const std::string& program, const fs::path& folder,
                  const std::vector<std::string>& arguments, const std::string& before)
{
    const TempFolder logs;
    std::string command = "cd " + quoted(folder.string()) + " && ";
    if (!before.empty()) command += before + " && ";
    command += quoted(program);
    for (const auto& argument : arguments) command += " " + quoted(argument);
    const auto out = logs.path() / "out", err = logs.path() / "err";
    command = "( " + command + " ) </dev/null >" + quoted(out.string()) + " 2>" + quoted(err.string());
    const int status = std::system(command.c_str());
    CliRun run;
    run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.out = textOf(out);
    run.err = textOf(err);
    return run;
}

std::string quoted(const std::string& text)
{
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

std::map<std::string, std::string> contentOf(const fs::path& folder)
{
    std::map<std::string, std::string> content;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = fs::relative(entry.path(), folder).string();
        if (entry.is_directory())
            content[name + "/"];
        else
            content[name] = textOf(entry.path());
    }
    return content;
}

ClassifiedGrid roomsGrid()
{
    constexpr int WIDTH = 80, HEIGHT = 50, WALL = 40, DOOR_LOW = 20, DOOR_HIGH = 28;
    ClassifiedGrid grid(WIDTH, HEIGHT, GridFrame{0.1, -1, 2, 0}, CellState::Free);
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x) {
            const bool border = x == 0 || y == 0 || x == WIDTH - 1 || y == HEIGHT - 1;
            if (border || (x == WALL && (y < DOOR_LOW || y > DOOR_HIGH)))
                grid.set({x, y}, CellState::Occupied);
        }
    return grid;
}

void writeRooms(const TempFolder& folder)
{
    const ClassifiedGrid grid = roomsGrid();
    folder.write("rooms.png", encodePng8(grid));
    folder.write("rooms.yaml", encodeRosYaml(grid.frame(), "rooms.png"));
}

void expectBadUsage(const CliRun& run, const std::vector<std::string>& words)
{
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err.rfind("gr2to: error: ", 0), 0u) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    for (const auto& word : words) EXPECT_THAT(run.err, testing::HasSubstr(word));
}

std::vector<std::string> extractedFiles()
{
    return {"overlay.png", "overlay.svg", "places.png", "topomap.gr2to", "topomap.simplemap", "topomap.xml"};
}
}  // namespace gr2to::test
