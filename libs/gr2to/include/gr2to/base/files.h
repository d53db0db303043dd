#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gr2to/base/interruption.h"

namespace gr2to
{
/** Writes a whole file. \throws OutputError  it cannot be created or not all bytes could be stored (disk
 * full) */
void writeFile(const std::filesystem::path& path, std::string_view bytes);

/** The bytes of a regular file.
 * \throws InputError  it does not exist, is a directory, is empty, or cannot be read
 */
std::string readFile(const std::filesystem::path& path);

/** Several output files that appear together or not at all.
 *
 * Each file is written under a temporary name beside its final one; commit() renames them all. Without a
 * commit the temporary files, and the folders that the transaction made, are removed again.
 */
class OutputTransaction
{
 public:
    OutputTransaction() = default;
    OutputTransaction(const OutputTransaction&) = delete;
    OutputTransaction& operator=(const OutputTransaction&) = delete;
    ~OutputTransaction();

    /** Temporary path to write in place of `target`; makes missing parent folders.
     * \throws InputError  the folder cannot be made or written into, or `target` is a folder
     */
    std::filesystem::path stage(const std::filesystem::path& target);
    /** Stages and writes in one go. \throws InputError, OutputError */
    void write(const std::filesystem::path& target, std::string_view bytes)
    {
        writeFile(stage(target), bytes);
    }
    /** Renames every staged file to its final name. \throws OutputError  a rename failed */
    void commit();

 private:
    struct Staged
    {
        std::filesystem::path temporary;
        std::filesystem::path target;
        UnfinishedOutput unfinished;
    };
    struct Folder
    {
        std::filesystem::path path;
        UnfinishedOutput unfinished;
    };
    std::vector<Staged> m_files;
    std::vector<Folder> m_foldersMade;
};
}  // namespace gr2to
