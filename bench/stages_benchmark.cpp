#include <benchmark/benchmark.h>

#include <map>
#include <utility>
#include <vector>

#include "common/Yardstick.h"
#include "common/floors.h"
#include "common/measure.h"
#include "gr2to/pipeline/Gr2To.h"

namespace gr2to::bench
{
namespace
{
/** A floor and what each stage gets from the ones before it. */
struct Floor
{
    explicit Floor(int side) : grid(floorOfSide(side)), yardstick(grid)
    {
        const VoronoiExtractor extractor(options.voronoi);
        separating = extractor.measure(grid, obstacles, distances);
        candidates = DoorDetector(options.door).detect(grid, distances);
        voronoi = extractor.trace(grid, distances, separating);
        const PlaceBuilder builder(options.place);
        const auto points = builder.criticalPoints(voronoi, distances, grid.resolution_m());
        graph = builder.build(builder.validate(candidates, points, grid, obstacles), voronoi, grid, obstacles,
                              distances);
    }

    Gr2ToOptions options = Gr2ToOptions::preset("paper");
    Obstacles obstacles =
        options.distance.unknown_is_obstacle ? Obstacles::OccupiedOrUnknown : Obstacles::Occupied;
    ClassifiedGrid grid;
    Yardstick yardstick;
    DistanceMap distances;
    std::vector<Cell> separating;
    std::vector<DoorCandidate> candidates;
    VoronoiGraph voronoi;
    PlaceGraph graph;
};

Floor& floorFor(const benchmark::State& state)
{
    static std::map<int, Floor> floors;
    const auto side = static_cast<int>(state.range(0));
    return floors.try_emplace(side, side).first->second;
}

/** Times a stage. Besides cells per second it reports what a run costs in OpenCV's distance transforms of the
 * same floor, and what there is to find, so that a fast wrong answer shows. */
template <class Stage>
void timeStage(benchmark::State& state, Floor& floor, const Stage& stage)
{
    const double start = cpuSeconds();
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(stage());
    const double seconds = (cpuSeconds() - start) / static_cast<double>(state.iterations());
    const auto cells = static_cast<double>(floor.grid.size());
    state.SetComplexityN(static_cast<benchmark::IterationCount>(floor.grid.size()));
    state.counters["cells/s"] = benchmark::Counter(cells, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["opencv"] = seconds / floor.yardstick.seconds();
    state.counters["places"] = static_cast<double>(floor.graph.circles.size());
    state.counters["doors"] = static_cast<double>(floor.graph.doors.size());
}

void opencvDistanceTransform(benchmark::State& state)
{
    Floor& floor = floorFor(state);
    timeStage(state, floor, [&] {
        floor.yardstick.run();
        return 0;
    });
}

void distanceMap(benchmark::State& state)
{
    Floor& floor = floorFor(state);
    timeStage(state, floor, [&] { return measureDistances(floor.grid, floor.obstacles); });
}

/** As the pipeline does it: the distance map and, in the same pass, the cells that part obstacles. */
void distanceMapAndSeparatingCells(benchmark::State& state)
{
    Floor& floor = floorFor(state);
    const VoronoiExtractor extractor(floor.options.voronoi);
    timeStage(state, floor, [&] {
        DistanceMap distances;
        std::vector<Cell> separating = extractor.measure(floor.grid, floor.obstacles, distances);
        benchmark::DoNotOptimize(separating);
        return distances;
    });
}

void doorDetection(benchmark::State& state)
{
    Floor& floor = floorFor(state);
    const DoorDetector detector(floor.options.door);
    timeStage(state, floor, [&] { return detector.detect(floor.grid, floor.distances); });
}

void voronoiExtraction(benchmark::State& state)
{
    Floor& floor = floorFor(state);
    const VoronoiExtractor extractor(floor.options.voronoi);
    timeStage(state, floor, [&] { return extractor.trace(floor.grid, floor.distances, floor.separating); });
}

void placeConstruction(benchmark::State& state)
{
    Floor& floor = floorFor(state);
    const PlaceBuilder builder(floor.options.place);
    timeStage(state, floor, [&] {
        const auto points = builder.criticalPoints(floor.voronoi, floor.distances, floor.grid.resolution_m());
        auto doors = builder.validate(floor.candidates, points, floor.grid, floor.obstacles);
        return builder.build(std::move(doors), floor.voronoi, floor.grid, floor.obstacles, floor.distances);
    });
}

void spaceDelimitation(benchmark::State& state)
{
    Floor& floor = floorFor(state);
    const SpaceDelimiter delimiter(floor.options.delimitation);
    timeStage(state, floor,
              [&] { return delimiter.delimit(floor.grid, floor.distances, floor.voronoi, floor.graph); });
}

/** Sides of 512 to 4096 cells: 0.26 to 16.8 million cells. */
void sides(benchmark::internal::Benchmark* benchmark)
{
    benchmark->RangeMultiplier(2)->Range(512, 4096)->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);
}
}  // namespace

BENCHMARK(opencvDistanceTransform)->Apply(sides);
BENCHMARK(distanceMap)->Apply(sides);
BENCHMARK(distanceMapAndSeparatingCells)->Apply(sides);
BENCHMARK(doorDetection)->Apply(sides);
BENCHMARK(voronoiExtraction)->Apply(sides);
BENCHMARK(placeConstruction)->Apply(sides);
BENCHMARK(spaceDelimitation)->Apply(sides);
}  // namespace gr2to::bench
