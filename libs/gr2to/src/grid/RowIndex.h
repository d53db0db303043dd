#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace gr2to
{
/** Things that lie on digital lines, to be looked up by direction and row. */
template <class Item>
class RowIndex
{
 public:
    void add(std::size_t direction, int row, const Item& item) { m_items[{direction, row}].push_back(item); }

    /** Calls a function with everything in a row and at most `reach` rows beside it, in the order of rows. */
    template <class Function>
    void forEachNear(std::size_t direction, int row, int reach, const Function& function) const
    {
        const auto last = m_items.upper_bound({direction, row + reach});
        for (auto at = m_items.lower_bound({direction, row - reach}); at != last; ++at)
            for (const Item& item : at->second) function(item);
    }

 private:
    std::map<std::pair<std::size_t, int>, std::vector<Item>> m_items;
};
}  // namespace gr2to
