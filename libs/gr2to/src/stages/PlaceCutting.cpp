#include "gr2to/stages/PlaceCutting.h"

#include "gr2to/topology/FaceMerging.h"
#include "gr2to/topology/RegionGraph.h"

namespace gr2to
{
namespace
{
constexpr double kThickestJamb_m = 0.3;  // obstacle between a wall's fitted end and the free space ahead
constexpr double kThickestFin_m = 0.35;  // wall that stands between two places
constexpr double kLongestFin_m = 1;      // seen whole, a wall is one
constexpr double kSolid_m = 0.4;         // more than walls are thick: furniture
constexpr double kWalks_m = 0.15;        // distance between the walks beside a border
constexpr double kLongestWalk_m = 20;    // beyond a border's ends: the space is wide enough then
constexpr double kSmallestFace_m2 =
    0.3;  // below that a face between cuts tells nothing: it joins a neighbour first
}  // namespace

std::vector<OptionField> TCutOptions::fields()
{
    return {
        {"along_walls", &along_walls, "",
         "Whether places are cut along the walls' lines, instead of found as circles."},
        {"extension", &extension, "m",
         "How far from a wall's end the next obstacle ahead may be, whatever the wall's length.", 0, 100},
        {"extension_ratio", &extension_ratio, "ratio",
         "So many times its length a wall reaches farther: long walls tell more than stubs.", 0, 100},
        {"max_extension", &max_extension, "m",
         "Longest way from the end of a wall to the next obstacle ahead.", 0, 100},
        {"max_offset", &max_offset, "m", "Walls on one line deviate sideways by at most this.", 0, 5},
        {"max_critical_line", &max_critical_line, "m", "Longest critical line that may be a border.", 0, 100},
        {"min_evidence", &min_evidence, "nat",
         "Least evidence for a border between places, as log odds; higher merges more.", -20, 20},
        {"mouth_openness", &mouth_openness, "ratio",
         "A border that is at most this open towards a wider place may be a corridor's mouth; openness is "
         "its "
         "length over the width of the space beside it.",
         0, 1},
        {"mouth_contrast", &mouth_contrast, "ratio",
         "Largest part of the larger one's radius that the place at a mouth has.", 0, 1},
        {"max_depth", &max_depth, "m", "How far from a border the width of the space beside it is measured.",
         0.1, 20},
        {"min_area", &min_area, "m2", "Smallest place.", 0, 1000},
        {"min_radius", &min_radius, "m", "Smallest circle that fits into a place.", 0, 10},
        {"min_lone_area", &min_lone_area, "m2",
         "Smallest place that no passage joins to another one, as rooms seen through a window; half a door's "
         "least width is the smallest circle that fits in.",
         0, 1000}};
}

PlaceCutter::PlaceCutter(TCutOptions options) : m_options(std::move(options))
{
    m_options.check();
}

std::vector<CandidateCut> PlaceCutter::candidates(const std::vector<WallSegment>& segments,
                                                  const std::vector<LineDirection>& directions,
                                                  const std::vector<CriticalPoint>& points,
                                                  const ClassifiedGrid& grid, Obstacles obstacles,
                                                  const HeightMap& heights, double maxLintel_m) const
{
    const double resolution = grid.resolution_m();
    const ExtensionRules extensions{m_options.extension / resolution, m_options.extension_ratio,
                                    m_options.max_extension / resolution, m_options.max_offset / resolution,
                                    kThickestJamb_m / resolution};
    std::vector<CandidateCut> cuts = extendWalls(grid, segments, directions, extensions);
    for (CandidateCut& cut : criticalCuts(grid, obstacles, points, m_options.max_critical_line / resolution))
        cuts.push_back(std::move(cut));
    const CutEndRules ends{kThickestFin_m / resolution, kLongestFin_m / resolution, kSolid_m / resolution};
    for (CandidateCut& cut : cuts) cut.ends = examineEnds(grid, cut.direction, cut.cells, ends);
    lookForLintels(grid, heights, maxLintel_m / resolution, cuts);
    return cuts;
}

PlaceGraph PlaceCutter::build(const std::vector<CandidateCut>& cuts,
                              const std::vector<LineDirection>& directions, const VoronoiGraph& voronoi,
                              const ClassifiedGrid& grid, Obstacles obstacles, const DistanceMap& distances,
                              double minDoor_m, double maxDoor_m) const
{
    const double resolution = grid.resolution_m(), cell_m2 = resolution * resolution;
    FaceMergingRules rules;
    rules.walks = {kWalks_m / resolution, m_options.max_depth / resolution, kLongestWalk_m / resolution};
    rules.mouth = {m_options.mouth_openness, m_options.mouth_contrast};
    rules.directions = directions;
    rules.minEvidence = m_options.min_evidence;
    rules.minFace_cells = kSmallestFace_m2 / cell_m2;
    rules.minPlace_cells = m_options.min_area / cell_m2;
    rules.minRadius_cells = m_options.min_radius / resolution;
    const Regions regions = mergeFaces(grid, distances, cuts, rules);
    RegionGraphRules graphRules;
    graphRules.minDoor_cells = minDoor_m / resolution;
    graphRules.maxDoor_cells = maxDoor_m / resolution;
    graphRules.minLoneArea_cells = m_options.min_lone_area / cell_m2;
    return graphOfRegions(regions, voronoi, grid, obstacles, distances, graphRules);
}
}  // namespace gr2to
