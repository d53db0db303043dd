#include "iniFile.h"

#include <mrpt/config/CConfigFileMemory.h>

#include <map>
#include <sstream>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/base/text.h"

namespace gr2to::cli
{
namespace
{
std::string trimmed(const std::string& text)
{
    const char* blanks = " \t\r\f\v";
    const auto start = text.find_first_not_of(blanks);
    if (start == std::string::npos) return "";
    return text.substr(start, text.find_last_not_of(blanks) - start + 1);
}

bool isComment(const std::string& line)
{
    return line.empty() || line[0] == '#' || line[0] == ';' || line.rfind("//", 0) == 0;
}

/** Where each key stands, with sections and names as written. */
class LineReader
{
 public:
    explicit LineReader(std::string file) : m_file(std::move(file)) {}

    void read(const std::string& line)
    {
        ++m_number;
        if (isComment(line)) return;
        if (line.front() == '[') return openSection(line);
        const auto equals = line.find('=');
        const std::string name = trimmed(line.substr(0, equals));
        if (equals == std::string::npos || name.empty())
            fail(excerpt(line) + " is neither a [section], a comment nor name = value");
        if (m_section.empty()) fail(excerpt(line) + " comes before the first [section]");
        const std::string key = m_section + "." + name;
        if (const auto [first, isNew] = m_lines.emplace(key, m_number); !isNew)
            fail("'" + key + "' is given already in line " + std::to_string(first->second) +
                 "; give it once");
        entries.push_back({key, name, m_number});
        sections.push_back(m_section);
    }

    std::vector<IniEntry> entries;  //!< the value is still the name
    std::vector<std::string> sections;

 private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw InputError("'" + m_file + "', line " + std::to_string(m_number) + ": " + what);
    }
    void openSection(const std::string& line)
    {
        const auto end = line.find(']');
        if (end == std::string::npos) fail(excerpt(line) + " lacks its ']'");
        if (!isComment(trimmed(line.substr(end + 1)))) fail(excerpt(line) + " has text after its ']'");
        m_section = trimmed(line.substr(1, end - 1));
    }

    std::string m_file;
    std::string m_section;
    std::size_t m_number = 0;
    std::map<std::string, std::size_t> m_lines;
};
}  // namespace

std::vector<IniEntry> readIniFile(const std::filesystem::path& path)
{
    const std::string text = readFile(path);
    if (!isText(text))
        throw InputError("'" + path.string() +
                         "' is not a text file; a configuration is an ini file in UTF-8");
    LineReader reader(path.string());
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) reader.read(trimmed(line));
    const mrpt::config::CConfigFileMemory config(text);
    for (std::size_t i = 0; i < reader.entries.size(); ++i) {
        IniEntry& entry = reader.entries[i];
        entry.value = trimmed(config.read_string(reader.sections[i], entry.value, ""));
    }
    return std::move(reader.entries);
}
}  // namespace gr2to::cli
