#include "ProgressBar.h"

#include <cmath>
#include <iostream>
#include <string>

namespace gr2to::rawlog
{
ProgressBar::~ProgressBar()
{
    constexpr const char* WIPE = "\r\033[K";
    if (m_shown >= 0) std::cerr << WIPE << std::flush;
}

void ProgressBar::show(double done)
{
    constexpr int WIDTH = 40, WHOLE = 100;
    const auto percent = static_cast<int>(std::lround(WHOLE * done));
    if (!m_wanted || percent == m_shown ||
        std::chrono::steady_clock::now() - m_start < std::chrono::seconds(1))
        return;
    m_shown = percent;
    const auto full = static_cast<std::size_t>(percent * WIDTH / WHOLE);
    std::cerr << "\rmapping [" << std::string(full, '#') << std::string(WIDTH - full, ' ') << "] " << percent
              << " %" << std::flush;
}
}  // namespace gr2to::rawlog
