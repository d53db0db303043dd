#pragma once

#include <mrpt/maps/CMetricMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/TMetricMapInitializer.h>
#include <mrpt/maps/TMetricMapTypesRegistry.h>

#include <string>

#include "gr2to/io/OccupancyGrid.h"
#include "gr2to/pipeline/Gr2To.h"
#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
/** The augmented topological map as a metric map of MRPT: in its registries, its archives, its viewers.
 *
 * It has one of two contents. A map that was made elsewhere, given at construction or read from an archive of
 * version 0, as `gr2to extract` writes it. Or an occupancy grid, filled by insertObservation() and turned
 * into a topological map when map() is called for the first time after a change; the first observation
 * replaces a map of the first kind.
 *
 * Registered as `gr2to::CTopologicalMap`, and as the map `topologicalMap` of a CMultiMetricMap's ini section:
 * `topologicalMap_count = 1`, with the sections (NAME is the section's own name)
 * - `[NAME_topologicalMap_00_creationOpts]`: `resolution` [m], `preset`, `occupied_threshold`,
 * `free_threshold`;
 * - `[NAME_topologicalMap_00_insertOpts]` and `..._likelihoodOpts]`: those of an occupancy grid;
 * - `[NAME_topologicalMap_00_extractOpts]`: options of the stages by their full names, `door.max_width
 * = 1.2`.
 *
 * What MRPT's metric maps can do and this one does by its grid: insertion (2D scans, sonars, range images),
 * likelihoods, determineMatching2D(). compute3DMatchingRatio() is 0, as for every grid.
 * determineMatching3D() and squareDistanceToClosestCorrespondence() throw, as MRPT's base class does.
 *
 * Not safe to use from several threads: map() changes what it keeps.
 */
class CTopologicalMap : public mrpt::maps::CMetricMap
{
    DEFINE_SERIALIZABLE(CTopologicalMap, gr2to)

 public:
    /** An empty map, its grid with cells of 0.05 m. */
    CTopologicalMap();
    explicit CTopologicalMap(TopologicalMap map);

    /** The topological map; made from the grid when that changed. Without places when the grid has no free or
     * no occupied cell. */
    const TopologicalMap& map() const;
    /** The grid of the observations; empty when the map was made elsewhere. */
    const mrpt::maps::COccupancyGridMap2D& grid() const { return m_grid; }
    const Gr2ToOptions& options() const { return m_options; }
    /** Changes how places are found. \throws std::invalid_argument  an option is out of range */
    void setOptions(const Gr2ToOptions& options);

    bool isEmpty() const override;
    std::string asString() const override;
    /** Writes PREFIX_topomap.xml, PREFIX_topomap.gr2to and PREFIX_topomap.3Dscene.
     * \throws OutputError, InputError  a file cannot be written
     */
    void saveMetricMapRepresentationToFile(const std::string& prefix) const override;
    /** Draws places, walls, doors and, above them, the graph. */
    void getVisualizationInto(mrpt::opengl::CSetOfObjects& objects) const override;
    void determineMatching2D(const CMetricMap* other, const mrpt::poses::CPose2D& otherPose,
                             mrpt::tfest::TMatchingPairList& pairs, const mrpt::maps::TMatchingParams& params,
                             mrpt::maps::TMatchingExtraResults& results) const override;
    float compute3DMatchingRatio(const CMetricMap* other, const mrpt::poses::CPose3D& otherPose,
                                 const mrpt::maps::TMatchingRatioParams& params) const override;

    MAP_DEFINITION_START(CTopologicalMap)
    double resolution = 0.05;  //!< side of a cell [m]
    OccupancyThresholds thresholds{0.65, 0.4};
    mrpt::maps::COccupancyGridMap2D::TInsertionOptions insertionOpts;
    mrpt::maps::COccupancyGridMap2D::TLikelihoodOptions likelihoodOpts;
    Gr2ToOptions extractionOpts;
    MAP_DEFINITION_END(CTopologicalMap)

 private:
    void internal_clear() override;
    bool internal_insertObservation(
        const mrpt::obs::CObservation& observation,
        const std::optional<const mrpt::poses::CPose3D>& robotPose = std::nullopt) override;
    double internal_computeObservationLikelihood(const mrpt::obs::CObservation& observation,
                                                 const mrpt::poses::CPose3D& takenFrom) const override;
    bool internal_canComputeObservationLikelihood(const mrpt::obs::CObservation& observation) const override;

    bool m_ofObservations = false;  //!< the grid is the content, the map follows from it
    bool m_inserted = false;        //!< the grid has observations; MRPT's archive of a grid does not tell
    mrpt::maps::COccupancyGridMap2D m_grid;
    OccupancyThresholds m_thresholds{0.65, 0.4};
    Gr2ToOptions m_options;
    mutable bool m_stale = false;
    mutable TopologicalMap m_map;
};
}  // namespace gr2to
