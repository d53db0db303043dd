#include "gr2to/base/interruption.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "gr2to/base/files.h"
#include "support/cli.h"

using namespace gr2to;
using namespace gr2to::test;

namespace
{
/** Runs an action in a child process, which ends with code 9 when the action returns. */
template <class Action>
int statusOfChild(const Action& action)
{
    const pid_t child = ::fork();
    if (child == 0) {
        action();
        ::_exit(9);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
}
}  // namespace

TEST(Interruption, signalsRemoveUnfinishedFilesAndFoldersAndEndTheProgram)
{
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
        const TempFolder folder;
        const int status = statusOfChild([&] {
            removeUnfinishedOutputOnSignals();
            OutputTransaction output;
            output.write(folder.path() / "made/deeper/map.xml", "half");
            std::raise(signal);
        });
        EXPECT_TRUE(WIFSIGNALED(status)) << signal;
        EXPECT_EQ(WTERMSIG(status), signal);
        EXPECT_TRUE(contentOf(folder.path()).empty());
    }
}

TEST(Interruption, finishedFilesStay)
{
    const TempFolder folder;
    statusOfChild([&] {
        removeUnfinishedOutputOnSignals();
        OutputTransaction output;
        output.write(folder.path() / "made/map.xml", "whole");
        output.commit();
        std::raise(SIGINT);
    });
    EXPECT_EQ(readFile(folder.path() / "made/map.xml"), "whole");
}

TEST(Interruption, ignoredSignalsStayIgnored)
{
    const int status = statusOfChild([] {
        std::signal(SIGHUP, SIG_IGN);
        removeUnfinishedOutputOnSignals();
        std::raise(SIGHUP);
    });
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 9);
}
