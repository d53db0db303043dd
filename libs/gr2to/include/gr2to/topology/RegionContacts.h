#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "gr2to/topology/FaceMap.h"

namespace gr2to
{
/** Where two regions touch: pairs of neighbouring cells, one in each. */
struct Contact
{
    int sideBySide = 0;        //!< pairs in a row
    int oneAboveTheOther = 0;  //!< pairs in a column

    /** Length of a straight border with so many pairs [cells]; of a bent one, about that of its chord. */
    double length_cells() const { return std::hypot(sideBySide, oneAboveTheOther); }
};

/** Which regions touch, and how long. A region is named by one of its faces. */
class RegionContacts
{
 public:
    /** Each face is a region. Cost: linear in the number of cells. */
    RegionContacts(const FaceMap& faces, int width);

    /** The regions that a region touches. */
    const std::map<int, Contact>& of(int region) const { return m_of[static_cast<std::size_t>(region)]; }
    Contact between(int a, int b) const;
    /** The second region becomes part of the first. */
    void join(int region, int other);

 private:
    std::vector<std::map<int, Contact>> m_of;
};
}  // namespace gr2to
