#include "common/measure.h"

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace gr2to::bench
{
namespace
{
std::size_t residentBytes()
{
    std::ifstream statm("/proc/self/statm");
    std::size_t total = 0;
    std::size_t resident = 0;
    statm >> total >> resident;
    return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::size_t peakResidentBytes()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/** What the child does; the work's peak goes into the pipe. */
bool reportPeak(const std::function<void()>& prepare, const std::function<void()>& work, int pipe)
{
    try {
        prepare();
        ::malloc_trim(0);  // reusing what was freed would not show
        const std::size_t before = residentBytes();
        work();
        const std::size_t peak = peakResidentBytes();
        const std::size_t grown = peak > before ? peak - before : 0;
        return ::write(pipe, &grown, sizeof grown) == static_cast<ssize_t>(sizeof grown);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return false;
    }
}
}  // namespace

double cpuSeconds()
{
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values)
{
    if (values.empty()) throw std::invalid_argument("no values to take the median of");
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double fittedExponent(const std::vector<double>& x, const std::vector<double>& y)
{
    if (x.size() != y.size() || x.size() < 2)
        throw std::invalid_argument("an exponent is fitted to at least two points");
    const auto n = static_cast<double>(x.size());
    double sx = 0;
    double sy = 0;
    double sxx = 0;
    double sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double lx = std::log(x[i]);
        const double ly = std::log(y[i]);
        sx += lx;
        sy += ly;
        sxx += lx * lx;
        sxy += lx * ly;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::size_t peakBytesOf(const std::function<void()>& prepare, const std::function<void()>& work)
{
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe to the process that memory is measured in");
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no process to measure memory in");
    if (child == 0) {
        ::close(ends[0]);
        ::_exit(reportPeak(prepare, work, ends[1]) ? 0 : 1);
    }
    ::close(ends[1]);
    std::size_t grown = 0;
    const bool complete = ::read(ends[0], &grown, sizeof grown) == static_cast<ssize_t>(sizeof grown);
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!complete) throw std::runtime_error("the work failed in the process that memory is measured in");
    return grown;
}
}  // namespace gr2to::bench
