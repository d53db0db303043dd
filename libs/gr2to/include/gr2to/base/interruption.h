#pragma once

#include <filesystem>

namespace gr2to
{
/** Makes the signals that end a program (SIGHUP, SIGINT, SIGTERM) remove unfinished output first.
 *
 * For programs, in their first lines; a library leaves signals to its user. Signals that are ignored stay so.
 */
void removeUnfinishedOutputOnSignals();

/** A path that such a signal removes as long as this object lives: a file, or a folder when it is empty.
 *
 * Of more than some dozens at a time, and of paths longer than 4095 bytes, the signal leaves the rest.
 */
class UnfinishedOutput
{
 public:
    explicit UnfinishedOutput(const std::filesystem::path& path);
    UnfinishedOutput(UnfinishedOutput&& other) noexcept;
    UnfinishedOutput& operator=(UnfinishedOutput&& other) noexcept;
    ~UnfinishedOutput();

 private:
    int m_slot;  //!< -1 for none
};
}  // namespace gr2to
