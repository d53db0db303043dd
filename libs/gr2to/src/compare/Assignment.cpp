#include "gr2to/compare/Assignment.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace gr2to
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void check(const SparseCosts& costs)
{
    if (!std::isfinite(costs.otherwise)) throw std::invalid_argument("costs.otherwise must be finite");
    for (const auto& e : costs.entries) {
        if (e.row >= costs.rows || e.column >= costs.columns)
            throw std::invalid_argument("costs entry (" + std::to_string(e.row) + ", " +
                                        std::to_string(e.column) + ") lies outside the table of " +
                                        std::to_string(costs.rows) + " x " + std::to_string(costs.columns));
        if (!std::isfinite(e.cost)) throw std::invalid_argument("every cost must be finite");
    }
}

SparseCosts transposed(SparseCosts costs)
{
    std::swap(costs.rows, costs.columns);
    for (auto& e : costs.entries) std::swap(e.row, e.column);
    return costs;
}

/** Successive shortest augmenting paths over a table that is no taller than it is wide. */
class AugmentingPaths
{
 public:
    explicit AugmentingPaths(const SparseCosts& costs)
        : m_costs(costs),
          m_entries(costs.entries),
          m_firstEntry(costs.rows + 1, 0),
          m_rowPotential(costs.rows, 0.0),
          m_columnPotential(costs.columns, 0.0),
          m_columnOf(costs.rows, kUnassigned),
          m_rowOf(costs.columns, kUnassigned),
          m_rowCosts(costs.columns, costs.otherwise),
          m_distance(costs.columns),
          m_previousRow(costs.columns),
          m_open(costs.columns)
    {
        std::sort(m_entries.begin(), m_entries.end(),
                  [](const auto& a, const auto& b) { return a.row < b.row; });
        for (const auto& e : m_entries) ++m_firstEntry[e.row + 1];
        std::partial_sum(m_firstEntry.begin(), m_firstEntry.end(), m_firstEntry.begin());
    }

    std::vector<std::size_t> run()
    {
        for (std::size_t row = 0; row < m_costs.rows; ++row) {
            const std::size_t sink = findPath(row);
            updatePotentials(row);
            augment(row, sink);
        }
        return std::move(m_columnOf);
    }

 private:
    /** Dijkstra over reduced costs from a row without a column to the nearest column without a row. */
    std::size_t findPath(std::size_t row)
    {
        std::fill(m_distance.begin(), m_distance.end(), kInfinity);
        // Columns are tried from the last: which of several equal answers comes out depends on it.
        std::iota(m_open.rbegin(), m_open.rend(), std::size_t{0});
        m_openCount = m_costs.columns;
        m_rowsReached.clear();
        m_length = 0;
        while (true) {
            m_rowsReached.push_back(row);
            const std::size_t column = nearestColumn(row);
            if (m_rowOf[column] == kUnassigned) return column;
            row = m_rowOf[column];
        }
    }

    /** Relaxes all open columns from a row, then closes and returns the nearest; a free one goes before a
     * taken one. */
    std::size_t nearestColumn(std::size_t row)
    {
        for (std::size_t e = m_firstEntry[row]; e < m_firstEntry[row + 1]; ++e)
            m_rowCosts[m_entries[e].column] = m_entries[e].cost;
        std::size_t nearest = 0;
        double least = kInfinity;
        for (std::size_t k = 0; k < m_openCount; ++k) {
            const std::size_t column = m_open[k];
            const double distance =
                m_length + m_rowCosts[column] - m_rowPotential[row] - m_columnPotential[column];
            if (distance < m_distance[column]) {
                m_distance[column] = distance;
                m_previousRow[column] = row;
            }
            if (m_distance[column] < least || (m_distance[column] == least && m_rowOf[column] == kUnassigned))
            {
                least = m_distance[column];
                nearest = k;
            }
        }
        for (std::size_t e = m_firstEntry[row]; e < m_firstEntry[row + 1]; ++e)
            m_rowCosts[m_entries[e].column] = m_costs.otherwise;
        m_length = least;
        // Closed columns stay behind the open ones, where updatePotentials finds them.
        std::swap(m_open[nearest], m_open[--m_openCount]);
        return m_open[m_openCount];
    }

    void updatePotentials(std::size_t start)
    {
        m_rowPotential[start] += m_length;
        for (const std::size_t row : m_rowsReached)
            if (row != start) m_rowPotential[row] += m_length - m_distance[m_columnOf[row]];
        for (std::size_t k = m_openCount; k < m_open.size(); ++k)
            m_columnPotential[m_open[k]] -= m_length - m_distance[m_open[k]];
    }

    void augment(std::size_t start, std::size_t column)
    {
        for (std::size_t row = kUnassigned; row != start;) {
            row = m_previousRow[column];
            m_rowOf[column] = row;
            std::swap(m_columnOf[row], column);
        }
    }

    const SparseCosts& m_costs;
    std::vector<SparseCosts::Entry> m_entries;  //!< by row
    std::vector<std::size_t> m_firstEntry;
    std::vector<double> m_rowPotential, m_columnPotential;
    std::vector<std::size_t> m_columnOf, m_rowOf;
    std::vector<double> m_rowCosts;  //!< scratch: the costs of one row, `otherwise` between uses
    std::vector<double> m_distance;
    std::vector<std::size_t> m_previousRow;
    std::vector<std::size_t> m_open;
    std::size_t m_openCount = 0;
    std::vector<std::size_t> m_rowsReached;
    double m_length = 0;
};
}  // namespace

std::vector<std::size_t> assignRows(const SparseCosts& costs)
{
    check(costs);
    if (costs.rows <= costs.columns) return AugmentingPaths(costs).run();
    const SparseCosts wide = transposed(costs);
    const std::vector<std::size_t> rowOf = AugmentingPaths(wide).run();
    std::vector<std::size_t> columnOf(costs.rows, kUnassigned);
    for (std::size_t column = 0; column < rowOf.size(); ++column) columnOf[rowOf[column]] = column;
    return columnOf;
}
}  // namespace gr2to
