#include "TextTable.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

namespace gr2to::cli
{
namespace
{
/** Characters of UTF-8 text, counting each code point as one. */
std::size_t lengthOf(const std::string& text)
{
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}
}  // namespace

std::string fixedText(double value, int decimals)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::fixed << std::setprecision(decimals) << value;
    return out.str();
}

TextTable::TextTable(std::vector<Column> columns) : m_columns(std::move(columns))
{
    m_rows.emplace_back();
    for (const Column& column : m_columns) m_rows.front().push_back(column.title);
}

std::string TextTable::text() const
{
    std::vector<std::size_t> widths(m_columns.size(), 0);
    for (const auto& row : m_rows)
        for (std::size_t c = 0; c < widths.size(); ++c) widths[c] = std::max(widths[c], lengthOf(row[c]));
    std::string out;
    for (const auto& row : m_rows) {
        std::string line;
        for (std::size_t c = 0; c < widths.size(); ++c) {
            const std::string blanks(widths[c] - lengthOf(row[c]), ' ');
            line += (c == 0 ? "" : "  ") + (m_columns[c].number ? blanks + row[c] : row[c] + blanks);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        out += line + "\n";
    }
    return out;
}
}  // namespace gr2to::cli
