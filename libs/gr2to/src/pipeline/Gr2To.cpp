#include "gr2to/pipeline/Gr2To.h"

#include <chrono>

#include "gr2to/base/errors.h"

namespace gr2to
{
namespace
{
template <class T>
std::size_t bytesOf(const std::vector<T>& v)
{
    return v.capacity() * sizeof(T);
}

std::size_t bytesOf(const VoronoiGraph& voronoi)
{
    std::size_t bytes = bytesOf(voronoi.cells) + bytesOf(voronoi.nodes) + bytesOf(voronoi.edges);
    for (const VoronoiEdge& edge : voronoi.edges) bytes += bytesOf(edge.cells);
    return bytes;
}

/** Times the stages and keeps their reports. */
class Clock
{
 public:
    explicit Clock(std::vector<StageReport>& reports) : m_reports(reports) {}

    void report(const char* stage, std::vector<std::pair<std::string, std::size_t>> counts, std::size_t bytes)
    {
        const auto now = std::chrono::steady_clock::now();
        m_reports.push_back(
            {stage, std::move(counts), std::chrono::duration<double>(now - m_last).count(), bytes});
        m_last = now;
    }

 private:
    std::vector<StageReport>& m_reports;
    std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

/** Fourth stage: as circles along the Voronoi diagram, or cut along walls. */
void constructPlaces(const ClassifiedGrid& grid, Obstacles obstacles, const HeightMap& heights,
                     const Gr2ToOptions& options, Extraction& e)
{
    const PlaceBuilder builder(options.place);
    e.criticalPoints = builder.criticalPoints(e.voronoi, e.distances, grid.resolution_m());
    if (options.cut.along_walls) {
        const PlaceCutter cutter(options.cut);
        e.graph = cutter.build(cutter.candidates(e.walls.segments, e.walls.directions, e.criticalPoints, grid,
                                                 obstacles, heights, options.place.lintel_width),
                               e.walls.directions, e.voronoi, grid, obstacles, e.distances,
                               options.door.min_width, options.door.max_width);
    } else
        e.graph =
            builder.build(builder.validate(e.doorCandidates, e.criticalPoints, grid, obstacles, heights),
                          e.voronoi, grid, obstacles, e.distances, heights);
}

std::size_t countReal(const TopologicalMap& map)
{
    std::size_t real = 0;
    for (const auto& [id, place] : map.places())
        for (const Wall& wall : place.walls) real += wall.real ? 1 : 0;
    return real;
}
}  // namespace

Gr2To::Gr2To(Gr2ToOptions options) : m_options(std::move(options))
{
    m_options.check();
}

CompressedGrid Gr2To::compress(const octomap::OcTree& tree, StageReport* report) const
{
    std::vector<StageReport> reports;
    Clock clock(reports);
    CompressedGrid compressed = GridCompressor(m_options.compression).compress(tree);
    clock.report("compression",
                 {{"leaves", compressed.leaves},
                  {"layers", compressed.layers},
                  {"cells of furniture", compressed.furnitureCells}},
                 compressed.grid.size() + compressed.heights.size() * sizeof(std::int16_t));
    if (report != nullptr) *report = reports.front();
    return compressed;
}

Extraction Gr2To::extract(const octomap::OcTree& tree) const
{
    StageReport report;
    Extraction e = extract(compress(tree, &report));
    e.reports.insert(e.reports.begin(), report);
    return e;
}

Extraction Gr2To::extract(const CompressedGrid& input) const
{
    return extract(input.grid, input.heights);
}

Extraction Gr2To::extract(const ClassifiedGrid& input) const
{
    return extract(input, HeightMap());
}

Extraction Gr2To::extract(const ClassifiedGrid& input, const HeightMap& heights) const
{
    if (input.count(CellState::Free) == 0)
        throw InputError("the grid has no free cell: there is no place to find");
    if (input.count(CellState::Occupied) == 0)
        throw InputError("the grid has no occupied cell: nothing delimits a place");
    const Obstacles obstacles =
        m_options.distance.unknown_is_obstacle ? Obstacles::OccupiedOrUnknown : Obstacles::Occupied;
    Extraction e;
    Clock clock(e.reports);

    if (m_options.cut.along_walls) {  // the filter keeps what touches walls
        e.walls = WallExtractor(m_options.wall).extract(input);
        clock.report("walls",
                     {{"directions", e.walls.directions.size()}, {"segments", e.walls.segments.size()}},
                     bytesOf(e.walls.segments));
    }
    FilteredGrid filtered = GridFilter(m_options.filter).filter(input, e.walls.segments, e.walls.directions);
    e.grid = std::move(filtered.grid);
    e.walls.dropRemoved(e.grid);
    const ClassifiedGrid& grid = e.grid;
    clock.report("filter", {{"blobs", filtered.blobs}, {"cells", filtered.cells}}, grid.size());

    const VoronoiExtractor voronoi(m_options.voronoi);
    const std::vector<Cell> separating = voronoi.measure(grid, obstacles, e.distances);
    clock.report("distance map", {{"cells", grid.size()}}, bytesOf(e.distances.squared));

    e.doorCandidates = DoorDetector(m_options.door).detect(grid, e.distances);
    clock.report("door detection", {{"candidates", e.doorCandidates.size()}}, bytesOf(e.doorCandidates));

    e.voronoi = voronoi.trace(grid, e.distances, separating);
    clock.report("Voronoi diagram", {{"nodes", e.voronoi.nodes.size()}, {"edges", e.voronoi.edges.size()}},
                 bytesOf(e.voronoi));

    constructPlaces(grid, obstacles, heights, m_options, e);
    clock.report("place construction",
                 {{"critical points", e.criticalPoints.size()},
                  {"circles", e.graph.circles.size()},
                  {"doors", e.graph.doors.size()}},
                 bytesOf(e.graph.circleOfCell));

    DelimitedSpace space =
        SpaceDelimiter(m_options.delimitation).delimit(grid, e.distances, e.voronoi, e.graph, heights);
    e.places = std::move(space.places);
    e.map = std::move(space.map);
    clock.report("space delimitation",
                 {{"places", e.map.places().size()},
                  {"connections", e.map.graph().edgeCount()},
                  {"real walls", countReal(e.map)}},
                 bytesOf(e.places.ids));
    return e;
}
}  // namespace gr2to
