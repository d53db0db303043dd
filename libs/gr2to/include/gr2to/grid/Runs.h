#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gr2to
{
/** A set of cells as maximal runs in rows, joined to connected regions.
 *
 * Cells are named by their index, y * width + x. Cost: one look at each cell, then linear in the number of
 * runs.
 */
class Runs
{
 public:
    enum class Connectivity : std::uint8_t
    {
        Sides,           //!< 4-connected
        SidesAndCorners  //!< 8-connected
    };

    struct Run
    {
        std::uint32_t begin;   //!< index of the first cell
        std::uint32_t end;     //!< index after the last cell
        std::uint32_t parent;  //!< a run of the same region; see root()
    };

    /** \param isMember  called with the index of every cell */
    template <class IsMember>
    Runs(int width, int height, Connectivity connectivity, const IsMember& isMember)
        : m_width(static_cast<std::uint32_t>(width)), m_reach(connectivity == Connectivity::Sides ? 0 : 1)
    {
        m_firstRun.reserve(static_cast<std::size_t>(height) + 1);
        for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(height); ++y) {
            m_firstRun.push_back(m_runs.size());
            const std::uint32_t end = (y + 1) * m_width;
            for (std::uint32_t i = y * m_width; i < end;) {
                while (i < end && !isMember(i)) ++i;
                if (i == end) break;
                const std::uint32_t begin = i;
                while (i < end && isMember(i)) ++i;
                m_runs.push_back({begin, i, static_cast<std::uint32_t>(m_runs.size())});
            }
            if (y > 0) linkRows(m_firstRun[y - 1], m_firstRun[y]);
        }
        m_firstRun.push_back(m_runs.size());
    }

    const std::vector<Run>& runs() const { return m_runs; }

    /** Index of the first run of a run's region, the region's name. */
    std::size_t root(std::size_t run)
    {
        while (m_runs[run].parent != run) {
            const std::uint32_t grandparent = m_runs[m_runs[run].parent].parent;
            m_runs[run].parent = grandparent;
            run = grandparent;
        }
        return run;
    }

    /** Index of the run that holds a cell; runs().size() when none does. */
    std::size_t find(std::size_t cell) const
    {
        const std::size_t y = cell / m_width;
        const auto first = m_runs.begin() + static_cast<std::ptrdiff_t>(m_firstRun[y]);
        const auto last = m_runs.begin() + static_cast<std::ptrdiff_t>(m_firstRun[y + 1]);
        const auto after =
            std::upper_bound(first, last, cell, [](std::size_t c, const Run& run) { return c < run.begin; });
        if (after == first || cell >= std::prev(after)->end) return m_runs.size();
        return static_cast<std::size_t>(std::prev(after) - m_runs.begin());
    }

 private:
    /** Joins the runs of the last row to those of the row below it that they touch. */
    void linkRows(std::size_t below, std::size_t current)
    {
        std::size_t a = below;
        for (std::size_t b = current; b < m_runs.size(); ++b) {
            while (a < current && m_runs[a].end + m_width + m_reach <= m_runs[b].begin) ++a;
            for (std::size_t k = a; k < current && m_runs[k].begin + m_width < m_runs[b].end + m_reach; ++k) {
                const std::size_t p = root(k), q = root(b);
                m_runs[std::max(p, q)].parent = static_cast<std::uint32_t>(std::min(p, q));
            }
        }
    }

    std::uint32_t m_width;
    std::uint32_t m_reach;  //!< cells by which runs of neighbouring rows may miss each other and still touch
    std::vector<Run> m_runs;
    std::vector<std::size_t> m_firstRun;  //!< of each row, and the end
};
}  // namespace gr2to
