#include "gr2to/topology/RegionContacts.h"

namespace gr2to
{
RegionContacts::RegionContacts(const FaceMap& faces, int width)
    : m_of(static_cast<std::size_t>(faces.count()) + 1)
{
    const std::vector<int>& face = faces.ofCell();
    const auto w = static_cast<std::size_t>(width);
    const auto count = [&](std::size_t i, std::size_t neighbour, int Contact::*pairs) {
        const int a = face[i], b = face[neighbour];
        if (a == b || a == 0 || b == 0) return;
        ++(m_of[static_cast<std::size_t>(a)][b].*pairs);
        ++(m_of[static_cast<std::size_t>(b)][a].*pairs);
    };
    for (std::size_t row = 0; row < face.size(); row += w) {
        for (std::size_t i = row; i + 1 < row + w; ++i) count(i, i + 1, &Contact::sideBySide);
        if (row > 0)
            for (std::size_t i = row; i < row + w; ++i) count(i - w, i, &Contact::oneAboveTheOther);
    }
}

Contact RegionContacts::between(int a, int b) const
{
    const auto& contacts = of(a);
    const auto found = contacts.find(b);
    return found == contacts.end() ? Contact() : found->second;
}

void RegionContacts::join(int region, int other)
{
    auto& kept = m_of[static_cast<std::size_t>(region)];
    auto& moved = m_of[static_cast<std::size_t>(other)];
    for (const auto& [neighbour, contact] : moved) {
        auto& back = m_of[static_cast<std::size_t>(neighbour)];
        back.erase(other);
        if (neighbour == region) continue;
        for (Contact* sum : {&kept[neighbour], &back[region]}) {
            sum->sideBySide += contact.sideBySide;
            sum->oneAboveTheOther += contact.oneAboveTheOther;
        }
    }
    moved.clear();
}
}  // namespace gr2to
