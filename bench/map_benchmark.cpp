#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "common/Yardstick.h"
#include "common/floors.h"
#include "common/measure.h"
#include "gr2to/io/GridReader.h"
#include "gr2to/pipeline/Gr2To.h"

namespace gr2to::bench
{
namespace
{
struct Settings
{
    std::vector<std::string> maps;
    std::string preset = "default";
    double resolution_m = 0.05;
    int rounds = 7;
    int scale = 1;
    std::string growth;
    int mostMcells = 64;
};

/** A grid that is made when it is needed, as not all fit the memory together. */
struct Subject
{
    std::string name;
    std::function<ClassifiedGrid()> make;
};

struct Measurement
{
    double cells = 0;
    std::size_t places = 0;
    std::size_t doors = 0;
    double yardstick_s = 0;  //!< median
    double pipeline_s = 0;   //!< median
    double leastRatio = 0;   //!< of one round
    double mostRatio = 0;
    double bytesPerCell = 0;  //!< the grid itself included
};

std::size_t peakBytes(const Subject& subject, const Gr2To& gr2to)
{
    constexpr int SMALL_SIDE = 256;
    ClassifiedGrid grid;
    const auto prepare = [&] {
        gr2to.extract(floorOfSide(SMALL_SIDE));
        grid = subject.make();
    };
    return peakBytesOf(prepare, [&] { gr2to.extract(grid); });
}

/** Runs both in turn, so that what else the machine does burdens both. */
Measurement timeBoth(const ClassifiedGrid& grid, const Gr2To& gr2to, int rounds)
{
    Yardstick yardstick(grid);
    std::vector<double> yardsticks;
    std::vector<double> pipelines;
    std::vector<double> ratios;
    Extraction extraction;
    yardstick.run();
    for (int round = 0; round < rounds; ++round) {
        extraction = Extraction();
        yardsticks.push_back(cpuSecondsOf([&] { yardstick.run(); }));
        pipelines.push_back(cpuSecondsOf([&] { extraction = gr2to.extract(grid); }));
        ratios.push_back(pipelines.back() / yardsticks.back());
    }
    Measurement m;
    m.cells = static_cast<double>(grid.size());
    m.places = extraction.map.places().size();
    for (const Connection& connection : extraction.map.connections())
        m.doors += connection.doorway.real ? 1 : 0;
    m.yardstick_s = median(yardsticks);
    m.pipeline_s = median(pipelines);
    m.leastRatio = *std::min_element(ratios.begin(), ratios.end());
    m.mostRatio = *std::max_element(ratios.begin(), ratios.end());
    return m;
}

void printHead()
{
    std::cout
        << "| map | Mcell | places | doors | OpenCV ms | Gr2To ms | ratio [least..most] | bytes/cell |\n"
        << "|---|---|---|---|---|---|---|---|\n";
}

void print(const std::string& name, const Measurement& m)
{
    char row[256];
    std::snprintf(row, sizeof row, " | %.2f | %zu | %zu | %.1f | %.1f | %.2f [%.2f..%.2f] | %.1f |",
                  m.cells / 1e6, m.places, m.doors, m.yardstick_s * 1e3, m.pipeline_s * 1e3,
                  m.pipeline_s / m.yardstick_s, m.leastRatio, m.mostRatio, m.bytesPerCell);
    std::cout << "| " << name << row << std::endl;
}

/** Measures and prints a row each. All memory comes first, while this process has left no traces in its own.
 */
std::vector<Measurement> measure(const std::vector<Subject>& subjects, const Settings& settings)
{
    const Gr2To gr2to(Gr2ToOptions::preset(settings.preset));
    std::vector<std::size_t> peaks;
    peaks.reserve(subjects.size());
    for (const Subject& subject : subjects) peaks.push_back(peakBytes(subject, gr2to));
    std::vector<Measurement> measurements;
    printHead();
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const ClassifiedGrid grid = subjects[i].make();
        Measurement m = timeBoth(grid, gr2to, settings.rounds);
        m.bytesPerCell = static_cast<double>(peaks[i]) / m.cells + sizeof(CellState);
        print(subjects[i].name, m);
        measurements.push_back(m);
    }
    return measurements;
}

ClassifiedGrid readMap(const std::filesystem::path& path, const Settings& settings)
{
    TGridReaderOptions options;
    if (path.extension() == ".png" || path.extension() == ".pgm") options.resolution = settings.resolution_m;
    ClassifiedGrid grid = readGrid(path, options);
    requireUsable(grid, path.string());
    return settings.scale > 1 ? upscaled(grid, settings.scale) : grid;
}

void measureMaps(const Settings& settings)
{
    std::vector<Subject> subjects;
    for (const std::filesystem::path path : settings.maps)
        subjects.push_back({path.filename().string(), [path, settings] { return readMap(path, settings); }});
    measure(subjects, settings);
}

void measureGrowth(const Settings& settings)
{
    constexpr int MCELL_SIDE = 1024;
    const Growth growth = settings.growth == "tiles" ? Growth::Tiles : Growth::Resolution;
    std::vector<Subject> subjects;
    for (int factor = 1; factor * factor <= settings.mostMcells; factor *= 2) {
        const int side = MCELL_SIDE * factor;
        subjects.push_back(
            {settings.growth + " " + std::to_string(side), [=] { return floorOfSide(side, growth); }});
    }
    std::vector<double> cells;
    std::vector<double> seconds;
    for (const Measurement& m : measure(subjects, settings)) {
        cells.push_back(m.cells);
        seconds.push_back(m.pipeline_s);
    }
    if (cells.size() > 1)
        std::cout << "\nfitted exponent of time over cells: " << fittedExponent(cells, seconds) << "\n";
}
}  // namespace
}  // namespace gr2to::bench

int main(int argc, char** argv)
{
    gr2to::bench::Settings settings;
    CLI::App app(
        "CPU time and memory of Gr2To on maps, against OpenCV's exact distance transform in one thread");
    app.add_option("maps", settings.maps, "map files that gr2to extract takes");
    app.add_option("--preset", settings.preset, "options of Gr2To")->capture_default_str();
    app.add_option("--resolution", settings.resolution_m, "side of a cell of bare images [m]")
        ->capture_default_str();
    app.add_option("--rounds", settings.rounds, "runs of both, in turn; medians are printed")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--scale", settings.scale, "cells that each cell becomes, along either axis")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    app.add_option("--growth", settings.growth,
                   "measure generated floors that grow by rooms or by finer cells")
        ->check(CLI::IsMember({"tiles", "resolution"}));
    app.add_option("--max-mcells", settings.mostMcells, "largest of the growing floors")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        if (settings.maps.empty() == settings.growth.empty())
            throw std::invalid_argument("give either map files or --growth");
        settings.growth.empty() ? measureMaps(settings) : measureGrowth(settings);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "map_benchmark: " << error.what() << "\n";
        return 1;
    }
}
