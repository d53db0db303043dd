#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gr2to::io
{
/** Text in quotes, fit for a one-line message: control characters become '?', long text is cut. */
std::string inQuotes(std::string_view text);
inline std::string pathInQuotes(const std::filesystem::path& path)
{
    return inQuotes(path.native());
}

/** Shortest decimal that reads back to the same number. */
std::string numberText(double value);

/** The gist of a message of many lines, such as MRPT's exceptions with their call stacks. */
std::string firstSentence(std::string_view message);
}  // namespace gr2to::io
