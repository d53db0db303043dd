#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>

#include "gr2to/base/files.h"
#include "support/cli.h"

using namespace gr2to;
using namespace gr2to::test;
using testing::HasSubstr;

namespace
{
class CliOutput : public testing::Test
{
 protected:
    CliOutput() { writeRooms(m_folder); }
    CliRun extract(const std::string& folder, const std::string& before = "") const
    {
        return runCli(m_folder.path(), {"extract", "rooms.yaml", "-o", folder}, before);
    }
    TempFolder m_folder;
};

void expectFailure(const CliRun& run)
{
    EXPECT_EQ(run.code, 1) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr("gr2to: error: cannot write"));
}

constexpr const char* ONE_BLOCK = "ulimit -f 1";  // a file of at most 512 or 1024 bytes, as the shell counts
}  // namespace

TEST_F(CliOutput, replacesOlderFilesAndLeavesOthers)
{
    m_folder.write("out/topomap.xml", "old");
    m_folder.write("out/notes.txt", "mine");
    ASSERT_EQ(extract("out").code, 0);
    EXPECT_THAT(readFile(m_folder.path() / "out/topomap.xml"), HasSubstr("<topological_map"));
    EXPECT_EQ(readFile(m_folder.path() / "out/notes.txt"), "mine");
    EXPECT_EQ(contentOf(m_folder.path() / "out").size(), extractedFiles().size() + 1);
}

TEST_F(CliOutput, folderThatCannotBeMadeIsBadUsage)
{
    m_folder.write("file", "no folder");
    const auto before = contentOf(m_folder.path());
    expectBadUsage(extract("file"), {"'file'", "not a folder"});
    expectBadUsage(extract("file/below"), {"'file/below'"});
    expectBadUsage(extract("/proc/gr2to-test"), {"/proc/gr2to-test"});
    EXPECT_EQ(contentOf(m_folder.path()), before);
}

TEST_F(CliOutput, folderThatTakesNoFilesIsBadUsage)
{
    expectBadUsage(extract("/proc"), {"'/proc'"});
}

TEST_F(CliOutput, badFolderIsToldBeforeTheInputIsRead)
{
    m_folder.write("file", "no folder");
    expectBadUsage(runCli(m_folder.path(), {"extract", "absent.yaml", "-o", "file/below"}), {"'file/below'"});
}

TEST_F(CliOutput, fileTakenForTheDefaultFolderIsBadUsage)
{
    m_folder.write("rooms", "no folder");
    expectBadUsage(runCli(m_folder.path(), {"extract", "rooms.yaml"}), {"'rooms'", "-o DIR"});
    EXPECT_EQ(readFile(m_folder.path() / "rooms"), "no folder");
}

TEST_F(CliOutput, inputIsNotReplaced)
{
    std::filesystem::rename(m_folder.path() / "rooms.png", m_folder.path() / "places.png");
    m_folder.write("rooms.yaml",
                   "image: places.png\nresolution: 0.1\norigin: [0, 0, 0]\noccupied_thresh: 0.65\n"
                   "free_thresh: 0.196\nnegate: 0\n");
    const auto before = contentOf(m_folder.path());
    expectBadUsage(runCli(m_folder.path(), {"extract", "places.png", "--resolution", "0.1", "-o", "."}),
                   {"places.png", "would replace the input", "-o DIR"});
    expectBadUsage(extract("."), {"places.png", "would replace the input"});
    EXPECT_EQ(contentOf(m_folder.path()), before);
}

TEST_F(CliOutput, fileThatCannotBeStoredLeavesNothing)
{
    const auto before = contentOf(m_folder.path());
    expectFailure(extract("deep/out", ONE_BLOCK));
    EXPECT_EQ(contentOf(m_folder.path()), before);
}

TEST_F(CliOutput, fileThatCannotBeStoredKeepsOlderOnes)
{
    ASSERT_EQ(extract("out").code, 0);
    m_folder.write("out/topomap.xml", "old");
    const auto before = contentOf(m_folder.path());
    expectFailure(extract("out", ONE_BLOCK));
    EXPECT_EQ(contentOf(m_folder.path()), before);
}

TEST_F(CliOutput, fullDiskLeavesNothing)
{
    // A mount namespace of its own, so that the disk goes with the process.
    const std::string disk = (m_folder.path() / "disk").string();
    std::filesystem::create_directory(disk);
    const std::string mount = "mount -t tmpfs -o size=32k gr2to-test " + quoted(disk);
    if (std::system(("unshare -m sh -c " + quoted(mount) + " 2>/dev/null").c_str()) != 0)
        GTEST_SKIP() << "no small disk can be mounted here (unshare -m, mount -t tmpfs): the file size limit "
                        "stands in for it in the other tests";
    const std::string work = "cd " + quoted(m_folder.path().string()) + " && " + mount + " && { " +
                             quoted(GR2TO_CLI) +
                             " extract rooms.yaml -o disk/out >out 2>err; echo $? >code; ls -A disk >left; }";
    ASSERT_EQ(std::system(("unshare -m sh -c " + quoted(work)).c_str()), 0);
    auto content = contentOf(m_folder.path());
    EXPECT_EQ(content["code"], "1\n");
    EXPECT_EQ(content["out"], "");
    EXPECT_THAT(content["err"], HasSubstr("No space left on device"));
    EXPECT_EQ(std::count(content["err"].begin(), content["err"].end(), '\n'), 1) << content["err"];
    EXPECT_EQ(content["left"], "");
}

TEST_F(CliOutput, standardOutputThatTakesNothingIsAFailure)
{
    const std::string command = quoted(GR2TO_CLI) + " info " +
                                quoted((m_folder.path() / "rooms.yaml").string()) + " >/dev/full 2>/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
}
