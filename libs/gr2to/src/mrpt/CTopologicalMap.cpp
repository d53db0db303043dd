#include "gr2to/mrpt/CTopologicalMap.h"

#include <mrpt/serialization/CArchive.h>

#include "serializeMap.h"

namespace gr2to
{
IMPLEMENTS_SERIALIZABLE(CTopologicalMap, CSerializable, gr2to)

std::uint8_t CTopologicalMap::serializeGetVersion() const
{
    return MAP_ARCHIVE_VERSION;
}

void CTopologicalMap::serializeTo(mrpt::serialization::CArchive& out) const
{
    writeMap(out, map);
}

void CTopologicalMap::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version)
{
    map = readMap(in, version, in.getArchiveDescription());
}
}  // namespace gr2to
