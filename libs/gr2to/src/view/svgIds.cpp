#include "svgIds.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace gr2to::view
{
namespace
{
/** Gives each id its new name on first sight and the same one ever after. */
class Renamer
{
 public:
    const std::string& operator()(std::string_view id)
    {
        const std::string prefix(id.substr(0, id.find_last_not_of("0123456789") + 1));
        const auto [entry, isNew] = m_names.try_emplace(std::string(id));
        if (isNew) entry->second = prefix + std::to_string(m_counts[prefix]++);
        return entry->second;
    }

 private:
    std::map<std::string, std::string> m_names;
    std::map<std::string, int> m_counts;
};

/** Finds what comes before an id, from left to right; each text is searched for only once over the whole
 * document. */
class LeadFinder
{
 public:
    explicit LeadFinder(const std::string& svg) : m_svg(svg)
    {
        for (auto& lead : m_leads) lead.at = svg.find(lead.text);
    }

    /** Where the next id at or after `from` starts; npos when there is none. */
    std::size_t next(std::size_t from)
    {
        std::size_t best = std::string::npos;
        for (auto& lead : m_leads) {
            if (lead.at < from) lead.at = m_svg.find(lead.text, from);
            if (lead.at != std::string::npos) best = std::min(best, lead.at + lead.text.size());
        }
        return best;
    }

 private:
    struct Lead
    {
        std::string_view text;
        std::size_t at = 0;
    };
    const std::string& m_svg;
    std::array<Lead, 3> m_leads = {Lead{" id=\""}, Lead{"href=\"#"}, Lead{"url(#"}};
};
}  // namespace

std::string withNumberedIds(const std::string& svg)
{
    Renamer rename;
    LeadFinder finder(svg);
    std::string result;
    result.reserve(svg.size());
    std::size_t done = 0;
    for (auto begin = finder.next(0); begin != std::string::npos; begin = finder.next(done)) {
        const std::size_t end = std::min(svg.find_first_of("\")", begin), svg.size());
        result.append(svg, done, begin - done).append(rename({svg.data() + begin, end - begin}));
        done = end;
    }
    return result.append(svg, done, std::string::npos);
}
}  // namespace gr2to::view
