#include "gr2to/mrpt/CTopologicalMap.h"

#include <mrpt/opengl/COpenGLScene.h>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/io/PlanarScan.h"
#include "gr2to/io/XmlMap.h"
#include "gr2to/mrpt/archive.h"
#include "gr2to/view/Scene3D.h"

namespace gr2to
{
CTopologicalMap::CTopologicalMap() : m_grid(-1.0f, 1.0f, -1.0f, 1.0f, 0.05f) {}

CTopologicalMap::CTopologicalMap(TopologicalMap map) : CTopologicalMap()
{
    m_map = std::move(map);
}

const TopologicalMap& CTopologicalMap::map() const
{
    if (!m_stale) return m_map;
    m_map = TopologicalMap();
    m_map.resolution_m = m_grid.getResolution();
    const ClassifiedGrid cells = fromOccupancyGrid(m_grid, m_thresholds);
    if (cells.count(CellState::Free) > 0 && cells.count(CellState::Occupied) > 0)
        m_map = Gr2To(m_options).extract(cells).map;
    m_map.source = "observations";
    m_stale = false;
    return m_map;
}

void CTopologicalMap::setOptions(const Gr2ToOptions& options)
{
    Gr2ToOptions checked = options;
    checked.check();
    m_options = checked;
    m_stale = m_ofObservations;
}

bool CTopologicalMap::isEmpty() const
{
    return m_ofObservations ? !m_inserted : m_map.places().empty();
}

std::string CTopologicalMap::asString() const
{
    const TopologicalMap& found = map();
    return "Topological map of " + std::to_string(found.places().size()) + " places and " +
           std::to_string(found.graph().edgeCount()) + " connections" +
           (m_ofObservations ? " over: " + m_grid.asString() : "");
}

void CTopologicalMap::saveMetricMapRepresentationToFile(const std::string& prefix) const
{
    OutputTransaction files;
    files.write(prefix + "_topomap.xml", toXml(map()));
    files.write(prefix + "_topomap.gr2to", toArchive(map()));
    const std::string scene = files.stage(prefix + "_topomap.3Dscene").string();
    mrpt::opengl::COpenGLScene drawing;
    drawing.insert(drawMap(map()));
    if (!drawing.saveToFile(scene)) throw OutputError("cannot write '" + scene + "'");
    files.commit();
}

void CTopologicalMap::getVisualizationInto(mrpt::opengl::CSetOfObjects& objects) const
{
    if (genericMapParams.enableSaveAs3DObject) objects.insert(drawMap(map()));
}

void CTopologicalMap::determineMatching2D(const mrpt::maps::CMetricMap* other,
                                          const mrpt::poses::CPose2D& otherPose,
                                          mrpt::tfest::TMatchingPairList& pairs,
                                          const mrpt::maps::TMatchingParams& params,
                                          mrpt::maps::TMatchingExtraResults& results) const
{
    m_grid.determineMatching2D(other, otherPose, pairs, params, results);
}

float CTopologicalMap::compute3DMatchingRatio(const mrpt::maps::CMetricMap*, const mrpt::poses::CPose3D&,
                                              const mrpt::maps::TMatchingRatioParams&) const
{
    return 0;
}

void CTopologicalMap::internal_clear()
{
    m_grid.clear();
    m_map = TopologicalMap();
    m_inserted = m_stale = false;
}

bool CTopologicalMap::internal_insertObservation(const mrpt::obs::CObservation& observation,
                                                 const std::optional<const mrpt::poses::CPose3D>& robotPose)
{
    const auto scan = planarScanOf(observation);
    if (!m_grid.insertObservation(scan ? *scan : observation, robotPose)) return false;
    m_ofObservations = m_inserted = m_stale = true;
    return true;
}

double CTopologicalMap::internal_computeObservationLikelihood(const mrpt::obs::CObservation& observation,
                                                              const mrpt::poses::CPose3D& takenFrom) const
{
    return m_grid.computeObservationLikelihood(observation, takenFrom);
}

bool CTopologicalMap::internal_canComputeObservationLikelihood(
    const mrpt::obs::CObservation& observation) const
{
    return m_inserted && m_grid.canComputeObservationLikelihood(observation);
}
}  // namespace gr2to
