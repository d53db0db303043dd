#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace gr2to::cli
{
/** Tells on standard error what the program is at, on a terminal and only once the work takes over a second.
 *
 * The line is wiped when the work ends, so that nothing of it stays on the screen or in a log.
 */
class Progress
{
 public:
    /** \param wanted  false for silence */
    explicit Progress(bool wanted);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    /** \param what  empty while another program tells its own progress */
    void step(const std::string& what);

 private:
    void watch();

    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::string m_step;
    bool m_done = false;
    std::thread m_watcher;
};
}  // namespace gr2to::cli
