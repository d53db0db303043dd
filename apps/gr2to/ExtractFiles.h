#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "gr2to/base/files.h"

namespace gr2to::cli
{
/** Files of one run of `gr2to extract`; they appear together, when all are written. */
class ExtractFiles
{
 public:
    /** \throws InputError  the folder cannot be written into */
    explicit ExtractFiles(std::filesystem::path folder);

    /** \throws InputError  the input is one of the files that would be replaced */
    void spare(const std::filesystem::path& input) const;
    /** \param index  among paths() */
    void write(std::size_t index, std::string_view bytes);
    /** A file besides those that every run writes. */
    void add(const std::filesystem::path& name, std::string_view bytes);
    void commit() { m_files.commit(); }
    std::size_t bytes() const { return m_bytes; }
    /** The files that every run writes: map as XML and as archive, places, overlay as PNG and as SVG,
     * simplemap. */
    std::vector<std::filesystem::path> paths() const;

 private:
    std::filesystem::path m_folder;
    OutputTransaction m_files;
    std::vector<std::filesystem::path> m_staged;
    std::size_t m_bytes = 0;
};
}  // namespace gr2to::cli
