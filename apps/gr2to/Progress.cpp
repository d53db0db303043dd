#include "Progress.h"

#include <unistd.h>

#include <cstdio>

namespace gr2to::cli
{
namespace
{
using namespace std::chrono_literals;

constexpr auto PATIENCE = 1s;
constexpr auto PERIOD = 200ms;
}  // namespace

Progress::Progress(bool wanted)
{
    if (wanted && ::isatty(STDERR_FILENO) != 0) m_watcher = std::thread([this] { watch(); });
}

Progress::~Progress()
{
    if (!m_watcher.joinable()) return;
    {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_done = true;
    }
    m_changed.notify_one();
    m_watcher.join();
}

void Progress::step(const std::string& what)
{
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_step = what;
}

void Progress::watch()
{
    std::unique_lock<std::mutex> lock(m_mutex);
    if (m_changed.wait_for(lock, PATIENCE, [this] { return m_done; })) return;
    while (!m_done) {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - m_start;
        if (!m_step.empty())
            std::fprintf(stderr, "\r\033[Kgr2to: %s ... %.0f s", m_step.c_str(), passed.count());
        std::fflush(stderr);
        m_changed.wait_for(lock, PERIOD, [this] { return m_done; });
    }
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
}
}  // namespace gr2to::cli
