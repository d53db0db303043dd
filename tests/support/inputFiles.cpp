#include "support/inputFiles.h"

#include <stdlib.h>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"

namespace gr2to::test
{
namespace fs = std::filesystem;

TempFolder::TempFolder()
{
    std::string pattern = (fs::temp_directory_path() / "gr2to-test-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw OutputError("cannot make the folder " + pattern);
    m_path = pattern;
}

TempFolder::~TempFolder()
{
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

fs::path TempFolder::write(const std::string& name, std::string_view bytes) const
{
    const fs::path file = m_path / name;
    fs::create_directories(file.parent_path());
    writeFile(file, bytes);
    return file;
}

TGridReaderOptions imageOptions()
{
    TGridReaderOptions options;
    options.resolution = 0.05;
    return options;
}

std::string drawingOf(const ClassifiedGrid& grid)
{
    std::string out;
    for (int y = grid.height() - 1; y >= 0; --y) {
        for (int x = 0; x < grid.width(); ++x) out += "?.#"[static_cast<int>(grid.at({x, y}))];
        out += '\n';
    }
    return out;
}

std::string inputErrorOf(const std::function<void()>& action)
{
    std::string message;
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    try {
        action();
    } catch (const InputError& e) {
        message = e.what();
    } catch (const std::exception& e) {
        ADD_FAILURE() << "another exception: " << e.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_NE(message, "") << "no InputError";
    EXPECT_EQ(message.find_first_of("\r\n"), std::string::npos) << "more than one line: " << message;
    return message;
}

std::string readErrorOf(const fs::path& file, const TGridReaderOptions& options)
{
    auto message = inputErrorOf([&] { readGrid(file, options); });
    EXPECT_NE(message.find("'" + file.string() + "'"), std::string::npos)
        << "the file is not named: " << message;
    return message;
}
}  // namespace gr2to::test
