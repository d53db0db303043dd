#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "gr2to/io/GridReader.h"

namespace gr2to::test
{
/** A fresh folder for one test, removed with all that is in it. */
class TempFolder
{
 public:
    TempFolder();
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;
    ~TempFolder();

    const std::filesystem::path& path() const { return m_path; }
    /** Writes a file and gives its path. */
    std::filesystem::path write(const std::string& name, std::string_view bytes) const;

 private:
    std::filesystem::path m_path;
};

/** Options for a bare image of 0.05 m cells. */
TGridReaderOptions imageOptions();

/** The grid as drawMap() draws it: '#' occupied, '.' free, '?' unknown; rows from the top, each ended by
 * '\n'. */
std::string drawingOf(const ClassifiedGrid& grid);

/** The message of the InputError that the action throws; also checks that it is one line and printed nowhere
 * else. Empty, with a failure, when nothing or something else is thrown. */
std::string inputErrorOf(const std::function<void()>& action);

/** The same for reading a file; also checks that the message names the file. */
std::string readErrorOf(const std::filesystem::path& file,
                        const TGridReaderOptions& options = imageOptions());
}  // namespace gr2to::test
