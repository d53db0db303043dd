#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "gr2to/base/files.h"
#include "gr2to/io/XmlMap.h"
#include "support/brokenXml.h"
#include "support/randomTopologicalMap.h"

namespace gr2to::test
{
namespace
{
/** Runs xmllint with share/topomap.xsd on files in a folder of its own. */
class XmlSchema : public testing::Test
{
 protected:
    void SetUp() override
    {
        if (run("command -v xmllint") != 0)
            GTEST_SKIP() << "xmllint is not installed (package libxml2-utils): the schema is not tested";
        std::filesystem::create_directories(m_folder);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    bool accepts(const std::string& text) const
    {
        const auto file = m_folder / "map.xml";
        writeFile(file, text);
        constexpr int INVALID =
            3;  // of xmllint: validation error; other codes mean that it could not do its work
        const int code =
            run("xmllint --noout --schema '" GR2TO_SOURCE_DIR "/share/topomap.xsd' '" + file.string() + "'");
        EXPECT_TRUE(code == 0 || code == INVALID) << "xmllint ended with " << code;
        return code == 0;
    }

 private:
    static int run(const std::string& command)
    {
        const int status = std::system((command + " > /dev/null 2>&1").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    std::filesystem::path m_folder =
        std::filesystem::temp_directory_path() / ("gr2to-schema-" + std::to_string(::getpid()));
};
}  // namespace

TEST_F(XmlSchema, acceptsWhatIsWritten)
{
    EXPECT_TRUE(accepts(completeXml()));
    for (unsigned seed = 0; seed < 50; ++seed)
        EXPECT_TRUE(accepts(toXml(randomTopologicalMap(seed)))) << "seed " << seed;
}

TEST_F(XmlSchema, refusesWhatTheReaderRefuses)
{
    for (const BrokenXml& broken : foreignXml()) EXPECT_FALSE(accepts(broken.text())) << broken.complaint;
}

TEST_F(XmlSchema, refusesValuesThatNoMapMayHave)
{
    const BrokenXml edits[] = {{"resolution=\"0.05\"", "resolution=\"0\"", ""},
                               {"frame=\"map\"", "frame=\"\"", ""},
                               {"area=\"22.23\"", "area=\"-1\"", ""},
                               {"<word>Sam's office</word>", "<word></word>", ""},
                               {"Sam's office", "Sam's\noffice", ""},
                               {"0,0 4,0 4,3.5", "0,0 4,0", ""},
                               {"<size length=\"4\"", "<size length=\"0\"", ""},
                               {"height=\"2.05\"", "height=\"0\"", ""},
                               {"image=\"views/3_0.png\"", "image=\"\"", ""},
                               {"<aperture x=\"1.5\"", "<aperture x=\"6.3\"", ""}};
    for (const BrokenXml& edit : edits) {
        EXPECT_FALSE(accepts(edit.text())) << edit.replacement;
        EXPECT_EQ(fromXml(edit.text(), "a.xml").validate().size(), 1u)
            << "the schema and validate() must agree: " << edit.replacement;
    }
}

TEST_F(XmlSchema, acceptsEveryWayOfWritingANumber)
{
    for (const char* const number : {"1.", ".5", "-0", "1e5", "1E+5", "5e-324", "0012", " 3 "}) {
        const BrokenXml edit{"<center x=\"1\"", std::string("<center x=\"") + number + "\"", ""};
        EXPECT_TRUE(accepts(edit.text())) << number;
        EXPECT_NO_THROW(fromXml(edit.text(), "a.xml")) << number;
    }
}
}  // namespace gr2to::test
