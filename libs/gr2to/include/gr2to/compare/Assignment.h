#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace gr2to
{
/** Costs of pairing rows with columns: listed pairs have a cost of their own, all others cost `otherwise`. */
struct SparseCosts
{
    struct Entry
    {
        std::size_t row = 0;
        std::size_t column = 0;
        double cost = 0;
    };
    std::size_t rows = 0;
    std::size_t columns = 0;
    double otherwise = 0;
    std::vector<Entry> entries;  //!< at most one for each pair, in any order
};

/** A row that has no column of its own. */
constexpr std::size_t kUnassigned = std::numeric_limits<std::size_t>::max();

/** Pairs rows with columns one to one at the least total cost (the linear assignment problem).
 *
 * Every row has a column when there are at least as many columns; else every column has a row. Of several
 * answers of equal cost always the same one is given. To maximise, negate the costs. \return for each row its
 * column, or kUnassigned \throws std::invalid_argument  an entry lies outside the table, or a cost is not
 * finite Cost: O(r^2 c) time in the worst case with r the shorter side, usually O(r c); memory O(entries +
 * rows + columns). Source: Crouse, On implementing 2D rectangular assignment algorithms, IEEE Trans. AES
 * 52(4), 2016 (shortest augmenting paths).
 */
std::vector<std::size_t> assignRows(const SparseCosts& costs);
}  // namespace gr2to
