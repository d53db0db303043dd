#include "ExtractFiles.h"

#include "gr2to/base/errors.h"

namespace gr2to::cli
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* kNames[] = {"topomap.xml", "topomap.gr2to", "places.png",
                                  "overlay.png", "overlay.svg",   "topomap.simplemap"};
}  // namespace

ExtractFiles::ExtractFiles(fs::path folder) : m_folder(std::move(folder))
{
    for (const char* name : kNames) m_staged.push_back(m_files.stage(m_folder / name));
}

void ExtractFiles::spare(const fs::path& input) const
{
    std::error_code ignored;
    for (const char* name : kNames)
        if (!input.empty() && fs::equivalent(input, m_folder / name, ignored))
            throw InputError("the output '" + (m_folder / name).string() +
                             "' would replace the input; choose another folder with -o DIR");
}

void ExtractFiles::write(std::size_t index, std::string_view bytes)
{
    writeFile(m_staged.at(index), bytes);
    m_bytes += bytes.size();
}

void ExtractFiles::add(const fs::path& name, std::string_view bytes)
{
    m_files.write(m_folder / name, bytes);
    m_bytes += bytes.size();
}

std::vector<fs::path> ExtractFiles::paths() const
{
    std::vector<fs::path> paths;
    for (const char* name : kNames) paths.push_back(m_folder / name);
    return paths;
}
}  // namespace gr2to::cli
