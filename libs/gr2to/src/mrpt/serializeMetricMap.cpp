#include <mrpt/serialization/CArchive.h>

#include "gr2to/mrpt/CTopologicalMap.h"
#include "serializeMap.h"

namespace gr2to
{
using mrpt::maps::CMetricMap;
IMPLEMENTS_SERIALIZABLE(CTopologicalMap, CMetricMap, gr2to)

std::uint8_t CTopologicalMap::serializeGetVersion() const
{
    return m_ofObservations ? GRID_ARCHIVE_VERSION : MAP_ARCHIVE_VERSION;
}

void CTopologicalMap::serializeTo(mrpt::serialization::CArchive& out) const
{
    if (!m_ofObservations) return writeMap(out, m_map);
    out << genericMapParams;
    out << m_grid << m_thresholds.occupied << m_thresholds.free;
    Gr2ToOptions options = m_options;  // its tables point into it
    std::vector<std::string> values;
    for (OptionTable* table : options.tables())
        for (const OptionField& field : table->fields())
            values.insert(values.end(), {table->section() + "." + field.name, field.valueText()});
    out << values << m_inserted << m_stale;
    if (!m_stale) writeMap(out, m_map);
}

void CTopologicalMap::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version)
{
    *this = CTopologicalMap();
    m_ofObservations = version == GRID_ARCHIVE_VERSION;
    if (!m_ofObservations) {
        m_map = readMap(in, version, in.getArchiveDescription());
        return;
    }
    in >> genericMapParams;
    in >> m_grid >> m_thresholds.occupied >> m_thresholds.free;
    std::vector<std::string> values;
    in >> values >> m_inserted >> m_stale;
    for (std::size_t i = 0; i + 1 < values.size(); i += 2) m_options.set(values[i], values[i + 1]);
    if (!m_stale) m_map = readMap(in, MAP_ARCHIVE_VERSION, in.getArchiveDescription());
}
}  // namespace gr2to
