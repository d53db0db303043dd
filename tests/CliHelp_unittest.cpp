#include <gmock/gmock.h>

#include <cstdlib>

#include "gr2to/base/files.h"
#include "gr2to/io/GridReader.h"
#include "gr2to/pipeline/Gr2To.h"
#include "gr2to/view/Overlay.h"
#include "support/cli.h"

using namespace gr2to;
using namespace gr2to::test;
using testing::HasSubstr;

namespace
{
/** What `gr2to` prints without trouble. */
std::string printed(const std::vector<std::string>& arguments)
{
    const TempFolder folder;
    const CliRun run = runCli(folder.path(), arguments);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    return run.out;
}

std::string flagOf(const OptionTable& table, const OptionField& field)
{
    std::string flag = "--" + table.section() + "-" + field.name;
    std::replace(flag.begin(), flag.end(), '_', '-');
    return flag;
}

/** The text without line ends and indents, so that a sentence is found wherever it is broken. */
std::string flowed(const std::string& text)
{
    std::string out;
    for (const char c : text)
        if (c != '\n' && c != ' ')
            out += c;
        else if (!out.empty() && out.back() != ' ')
            out += ' ';
    return out;
}

std::string without(const std::string& text, char unwanted)
{
    std::string out = text;
    out.erase(std::remove(out.begin(), out.end(), unwanted), out.end());
    return out;
}

struct AllTables
{
    TGridReaderOptions reader;
    Gr2ToOptions stages;
    TOverlayOptions overlay;
    std::vector<OptionTable*> list()
    {
        auto tables = stages.tables();
        tables.push_back(&reader);
        tables.push_back(&overlay);
        return tables;
    }
};
}  // namespace

TEST(CliHelp, overviewListsTheCommands)
{
    for (const auto& arguments : {std::vector<std::string>{"--help"}, {"-h"}, {"help"}}) {
        const std::string text = printed(arguments);
        for (const char* command : {"extract", "info", "validate", "compare"})
            EXPECT_THAT(text, HasSubstr(command));
    }
    EXPECT_THAT(printed({"--version"}), testing::MatchesRegex("gr2to [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(CliHelp, everyCommandHasHelp)
{
    for (const std::string command : {"extract", "info", "validate", "compare"}) {
        const std::string text = printed({command, "--help"});
        EXPECT_THAT(text, HasSubstr("Usage: gr2to " + command));
        EXPECT_THAT(text, HasSubstr("--json"));
        EXPECT_THAT(text, HasSubstr("Exit codes: 0 done"));
        EXPECT_EQ(printed({"help", command}), text);
    }
}

TEST(CliHelp, extractStatesMeaningUnitRangeAndDefaultOfEveryOption)
{
    const std::string text = flowed(printed({"extract", "--help"}));
    AllTables tables;
    for (OptionTable* table : tables.list())
        for (const OptionField& field : table->fields()) {
            const std::string flag = flagOf(*table, field);
            const auto at = text.find(flag + " ");
            ASSERT_NE(at, std::string::npos) << flag;
            const std::string entry = text.substr(at, text.find(" --", at + 1) - at);
            EXPECT_THAT(entry, HasSubstr(flowed(field.meaning))) << flag;
            EXPECT_THAT(entry, HasSubstr("default " + field.valueText())) << flag;
            const std::string unit = field.unit.empty() ? "" : "unit " + field.unit;
            const std::string range = field.rangeText().empty() ? "" : "range " + field.rangeText();
            EXPECT_THAT(entry, HasSubstr(unit)) << flag;
            EXPECT_THAT(entry, HasSubstr(range)) << flag;
        }
}

TEST(CliHelp, presetsAreToldWhereTheyDiffer)
{
    EXPECT_THAT(flowed(printed({"extract", "--help"})), HasSubstr("default yes, no with preset paper"));
}

TEST(CliHelp, linesFitATerminal)
{
    std::istringstream lines(printed({"extract", "--help"}));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
}

TEST(CliMan, everyOptionIsInTheManPage)
{
    const std::string page = without(printed({"man"}), '\\');
    EXPECT_EQ(page.rfind(".TH GR2TO 1", 0), 0u);
    AllTables tables;
    for (OptionTable* table : tables.list())
        for (const OptionField& field : table->fields()) EXPECT_THAT(page, HasSubstr(flagOf(*table, field)));
    for (const char* option : {"--places", "--grid", "--json", "--quiet", "--preset", "--config", "--set"})
        EXPECT_THAT(page, HasSubstr(option));
}

TEST(CliMan, hasNoFaultThatManReports)
{
    if (std::system("command -v man >/dev/null && command -v groff >/dev/null") != 0)
        GTEST_SKIP() << "man or groff is not installed: the man page is not checked";
    const TempFolder folder;
    const auto page = folder.write("gr2to.1", printed({"man"}));
    const auto log = folder.path() / "log";
    const std::string command = "LC_ALL=C.UTF-8 MANWIDTH=100 man --warnings -l " + quoted(page.string()) +
                                " >/dev/null 2>" + quoted(log.string());
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(contentOf(folder.path())["log"], "");
}

TEST(CliOptions, iniFileOfAllDefaultsIsReadBack)
{
    const TempFolder folder;
    writeRooms(folder);
    folder.write("all.ini", printed({"options"}));
    ASSERT_EQ(runCli(folder.path(), {"extract", "rooms.yaml", "-o", "one"}).code, 0);
    const CliRun run = runCli(folder.path(), {"extract", "rooms.yaml", "-o", "two", "-c", "all.ini"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(contentOf(folder.path() / "one"), contentOf(folder.path() / "two"));
}

TEST(CliOptions, parametersPageIsUpToDate)
{
    EXPECT_EQ(readFile(GR2TO_SOURCE_DIR "/doc/parameters.md"), printed({"options", "--markdown"}))
        << "make it again: build/dev/apps/gr2to/gr2to options --markdown > doc/parameters.md";
}
