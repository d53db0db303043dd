#pragma once

#include <vector>

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/DistanceMap.h"
#include "gr2to/grid/VoronoiGraph.h"
#include "gr2to/topology/CandidateCuts.h"
#include "gr2to/topology/PlaceGraph.h"

namespace gr2to
{
struct TCutOptions : OptionTable
{
    bool along_walls = true;
    double extension = 3;
    double extension_ratio = 4;
    double max_extension = 20;
    double max_offset = 0.15;
    double max_critical_line = 3.5;
    double min_evidence = 0;
    double mouth_openness = 0.35;
    double mouth_contrast = 0.5;
    double max_depth = 1.8;
    double min_area = 2;
    double min_radius = 0.4;
    double min_lone_area = 0.75;

    std::string section() const override { return "cut"; }
    std::vector<OptionField> fields() override;
};

/** Fourth stage of the preset `default`: cuts the free space along the walls' lines and merges what no wall
 * parts.
 *
 * Candidate cuts are the extensions of walls beyond their ends and the critical lines of critical points. The
 * faces between them merge across borders that little speaks for, as borderEvidence() weighs it; a border's
 * *openness* on one side is its length over the longest walk parallel to it on that side.
 */
class PlaceCutter
{
 public:
    /** \throws std::invalid_argument  an option is out of range */
    explicit PlaceCutter(TCutOptions options);

    /** Where borders may run. \param heights  of a 3D map, empty of others
     * \param maxLintel_m  width of the widest passage under a lintel */
    std::vector<CandidateCut> candidates(const std::vector<WallSegment>& segments,
                                         const std::vector<LineDirection>& directions,
                                         const std::vector<CriticalPoint>& points, const ClassifiedGrid& grid,
                                         Obstacles obstacles, const HeightMap& heights,
                                         double maxLintel_m) const;

    /** Places, their doors and openings. \param directions  that the walls run in
     * \param minDoor_m, maxDoor_m  how narrow and how wide a door is */
    PlaceGraph build(const std::vector<CandidateCut>& cuts, const std::vector<LineDirection>& directions,
                     const VoronoiGraph& voronoi, const ClassifiedGrid& grid, Obstacles obstacles,
                     const DistanceMap& distances, double minDoor_m, double maxDoor_m) const;

 private:
    TCutOptions m_options;
};
}  // namespace gr2to
