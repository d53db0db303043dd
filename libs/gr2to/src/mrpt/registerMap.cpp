#include <mrpt/config/CConfigFileBase.h>

#include <ostream>

#include "gr2to/base/text.h"
#include "gr2to/mrpt/CTopologicalMap.h"

MAP_DEFINITION_REGISTER("gr2to::CTopologicalMap,topologicalMap", gr2to::CTopologicalMap)

namespace gr2to
{
CTopologicalMap::TMapDefinition::TMapDefinition() = default;

void CTopologicalMap::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& source, const std::string& sectionNamePrefix)
{
    const std::string creation = sectionNamePrefix + "_creationOpts";
    resolution = source.read_double(creation, "resolution", resolution);
    thresholds.occupied = source.read_double(creation, "occupied_threshold", thresholds.occupied);
    thresholds.free = source.read_double(creation, "free_threshold", thresholds.free);
    if (!(resolution > 0) || !(thresholds.free <= thresholds.occupied))
        throw std::invalid_argument(
            "[" + creation + "]: resolution = " + numberText(resolution) +
            " m must be positive, and free_threshold = " + numberText(thresholds.free) +
            " must not exceed occupied_threshold = " + numberText(thresholds.occupied));
    insertionOpts.loadFromConfigFile(source, sectionNamePrefix + "_insertOpts");
    likelihoodOpts.loadFromConfigFile(source, sectionNamePrefix + "_likelihoodOpts");
    extractionOpts = Gr2ToOptions::preset(source.read_string(creation, "preset", "default"));
    const std::string extraction = sectionNamePrefix + "_extractOpts";
    std::vector<std::string> keys;
    if (source.sectionExists(extraction)) source.getAllKeys(extraction, keys);
    for (const std::string& key : keys) extractionOpts.set(key, source.read_string(extraction, key, ""));
    extractionOpts.check();
}

void CTopologicalMap::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const
{
    out << "resolution = " << resolution << " m, occupied above " << thresholds.occupied << ", free below "
        << thresholds.free << '\n';
    insertionOpts.dumpToTextStream(out);
    likelihoodOpts.dumpToTextStream(out);
    Gr2ToOptions options = extractionOpts;  // its tables point into it
    for (const OptionTable* table : options.tables()) table->dumpToTextStream(out);
}

mrpt::maps::CMetricMap* CTopologicalMap::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
{
    const auto& given = dynamic_cast<const TMapDefinition&>(definition);
    auto* map = new CTopologicalMap();
    map->m_grid.setSize(-1, 1, -1, 1, static_cast<float>(given.resolution), 0.5f);
    map->m_grid.insertionOptions = given.insertionOpts;
    map->m_grid.likelihoodOptions = given.likelihoodOpts;
    map->m_thresholds = given.thresholds;
    map->m_options = given.extractionOpts;
    map->m_ofObservations = true;
    return map;
}
}  // namespace gr2to
