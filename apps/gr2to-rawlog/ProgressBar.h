#pragma once

#include <chrono>

namespace gr2to::rawlog
{
/** A bar on standard error, drawn once the work takes over a second and wiped when it ends. */
class ProgressBar
{
 public:
    explicit ProgressBar(bool wanted) : m_wanted(wanted) {}
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ~ProgressBar();

    /** \param done  within [0, 1] */
    void show(double done);

 private:
    bool m_wanted;
    int m_shown = -1;  //!< per cent
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};
}  // namespace gr2to::rawlog
