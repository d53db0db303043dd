#include <benchmark/benchmark.h>

#include <map>

#include "common/Yardstick.h"
#include "common/floors.h"
#include "common/measure.h"
#include "gr2to/pipeline/Gr2To.h"

namespace gr2to::bench
{
namespace
{
struct Floor
{
    explicit Floor(int side) : grid(floorOfSide(side)), yardstick(grid) {}
    ClassifiedGrid grid;
    Yardstick yardstick;
};

std::size_t doorsOf(const TopologicalMap& map)
{
    std::size_t doors = 0;
    for (const Connection& connection : map.connections()) doors += connection.doorway.real ? 1 : 0;
    return doors;
}

/** The pipeline and OpenCV's distance transform of the same floor in turn, so that what else the machine does
 * burdens both. `opencv` is the ratio of the CPU times of the two. */
void pipeline(benchmark::State& state, const char* preset)
{
    static std::map<int, Floor> floors;
    const auto side = static_cast<int>(state.range(0));
    Floor& floor = floors.try_emplace(side, side).first->second;
    const Gr2To gr2to(Gr2ToOptions::preset(preset));
    Extraction extraction;
    double pipelineSeconds = 0;
    double yardstickSeconds = 0;
    for ([[maybe_unused]] auto _ : state) {
        const double seconds = cpuSecondsOf([&] { extraction = gr2to.extract(floor.grid); });
        state.SetIterationTime(seconds);
        pipelineSeconds += seconds;
        yardstickSeconds += cpuSecondsOf([&] { floor.yardstick.run(); });
    }
    const auto cells = static_cast<double>(floor.grid.size());
    state.SetComplexityN(static_cast<benchmark::IterationCount>(floor.grid.size()));
    state.counters["cells/s"] = benchmark::Counter(cells, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["opencv"] = pipelineSeconds / yardstickSeconds;
    state.counters["places"] = static_cast<double>(extraction.map.places().size());
    state.counters["doors"] = static_cast<double>(doorsOf(extraction.map));
}

/** Sides of 512 to 4096 cells: 0.26 to 16.8 million cells. */
void sides(benchmark::internal::Benchmark* benchmark)
{
    benchmark->RangeMultiplier(2)
        ->Range(512, 4096)
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Complexity(benchmark::oN);
}
}  // namespace

BENCHMARK_CAPTURE(pipeline, paper, "paper")->Apply(sides);
BENCHMARK_CAPTURE(pipeline, default, "default")->Apply(sides);
}  // namespace gr2to::bench
