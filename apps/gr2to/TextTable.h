#pragma once

#include <string>
#include <vector>

namespace gr2to::cli
{
/** A number with a fixed count of decimals and a point, whatever the locale. */
std::string fixedText(double value, int decimals);

/** Columns as wide as their widest text, numbers to the right. */
class TextTable
{
 public:
    struct Column
    {
        std::string title;
        bool number = false;
    };

    explicit TextTable(std::vector<Column> columns);
    /** \param texts  one for each column */
    void row(std::vector<std::string> texts) { m_rows.push_back(std::move(texts)); }
    std::string text() const;

 private:
    std::vector<Column> m_columns;
    std::vector<std::vector<std::string>> m_rows;
};
}  // namespace gr2to::cli
