#include "gr2to/stages/PlaceCutting.h"

#include "gr2to/topology/FaceMerging.h"
#include "gr2to/topology/RegionGraph.h"

namespace gr2to
{
namespace
{
constexpr double kThickestJamb_m = 0.1;  // obstacle between a wall's fitted end and the free space ahead
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
        {"max_extension", &max_extension, "m",
         "Longest way from the end of a wall to the next obstacle ahead.", 0, 100},
        {"max_offset", &max_offset, "m", "Walls on one line deviate sideways by at most this.", 0, 5},
        {"max_critical_line", &max_critical_line, "m", "Longest critical line that may be a border.", 0, 100},
        {"max_openness_walls", &max_openness_walls, "ratio",
         "Most open border between two walls on one line; openness is the border's length over the width of "
         "the space beside "
         "it, summed over both sides.",
         0, 2},
        {"max_openness_wall", &max_openness_wall, "ratio", "Most open border from the end of one wall.", 0,
         2},
        {"max_openness_critical", &max_openness_critical, "ratio", "Most open border on a critical line.", 0,
         2},
        {"max_openness_side", &max_openness_side, "ratio", "Most open border towards either side.", 0, 1},
        {"mouth_openness", &mouth_openness, "ratio",
         "A place may be fully open to a larger one whose side is at most this open: a corridor's mouth.", 0,
         1},
        {"mouth_contrast", &mouth_contrast, "ratio",
         "Largest part of the larger one's radius that the place at a mouth has.", 0, 1},
        {"max_depth", &max_depth, "m", "How far from a border the width of the space beside it is measured.",
         0.1, 20},
        {"min_area", &min_area, "m2", "Smallest place.", 0, 1000},
        {"min_radius", &min_radius, "m", "Smallest circle that fits into a place.", 0, 10}};
}

PlaceCutter::PlaceCutter(TCutOptions options) : m_options(std::move(options))
{
    m_options.check();
}

std::vector<CandidateCut> PlaceCutter::candidates(const std::vector<WallSegment>& segments,
                                                  const std::vector<LineDirection>& directions,
                                                  const std::vector<CriticalPoint>& points,
                                                  const ClassifiedGrid& grid, Obstacles obstacles) const
{
    const double resolution = grid.resolution_m();
    std::vector<CandidateCut> cuts =
        extendWalls(grid, segments, directions, m_options.max_extension / resolution,
                    m_options.max_offset / resolution, kThickestJamb_m / resolution);
    for (CandidateCut& cut : criticalCuts(grid, obstacles, points, m_options.max_critical_line / resolution))
        cuts.push_back(std::move(cut));
    return cuts;
}

PlaceGraph PlaceCutter::build(const std::vector<CandidateCut>& cuts, const VoronoiGraph& voronoi,
                              const ClassifiedGrid& grid, const DistanceMap& distances, double minDoor_m,
                              double maxDoor_m) const
{
    const double resolution = grid.resolution_m(), cell_m2 = resolution * resolution;
    FaceMergingRules rules;
    rules.walks = {kWalks_m / resolution, m_options.max_depth / resolution, kLongestWalk_m / resolution};
    rules.maxSide = m_options.max_openness_side;
    rules.maxSumRay = m_options.max_openness_wall;
    rules.maxSumWall = m_options.max_openness_walls;
    rules.maxSumCritical = m_options.max_openness_critical;
    rules.mouthOpenness = m_options.mouth_openness;
    rules.mouthContrast = m_options.mouth_contrast;
    rules.minFace_cells = kSmallestFace_m2 / cell_m2;
    rules.minPlace_cells = m_options.min_area / cell_m2;
    rules.minRadius_cells = m_options.min_radius / resolution;
    const Regions regions = mergeFaces(grid, distances, cuts, rules);
    RegionGraphRules graphRules;
    graphRules.minDoor_cells = minDoor_m / resolution;
    graphRules.maxDoor_cells = maxDoor_m / resolution;
    graphRules.minArea_cells = rules.minPlace_cells;
    graphRules.minRadius_cells = rules.minRadius_cells;
    return graphOfRegions(regions, voronoi, distances, graphRules);
}
}  // namespace gr2to
