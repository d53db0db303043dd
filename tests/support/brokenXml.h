#pragma once

#include <string>
#include <vector>

namespace gr2to::test
{
/** XML of a small valid map that has every element and attribute of the format. */
std::string completeXml();

/** One replacement in completeXml() that breaks it. */
struct BrokenXml
{
    std::string original;  //!< must occur in completeXml(); its first occurrence is replaced
    std::string replacement;
    std::string complaint;  //!< of the reader, after the file name and `: `

    std::string text() const;
};

/** Well-formed, but not of the format: both the reader and the schema must refuse. */
std::vector<BrokenXml> foreignXml();
/** Not well-formed, or XML that is refused as a whole. */
std::vector<BrokenXml> malformedXml();
}  // namespace gr2to::test
