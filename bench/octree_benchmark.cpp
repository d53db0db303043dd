#include <octomap/OcTree.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "common/floors.h"
#include "common/measure.h"
#include "gr2to/base/files.h"
#include "gr2to/io/OctreeReader.h"
#include "gr2to/pipeline/Gr2To.h"
#include "support/building/Octrees.h"

namespace gr2to::bench
{
namespace
{
namespace fs = std::filesystem;

struct Settings
{
    std::vector<std::string> maps;
    std::vector<int> tiles = {1};
    std::string preset = "default";
    int rounds = 7;
    int side = 512;
};

/** A file that is removed again. */
class ScratchFile
{
 public:
    explicit ScratchFile(const std::string& bytes)
        : m_path(fs::temp_directory_path() / ("gr2to-octree-benchmark-" + std::to_string(::getpid()) + ".bt"))
    {
        writeFile(m_path, bytes);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    ~ScratchFile()
    {
        std::error_code ignored;
        fs::remove(m_path, ignored);
    }
    const fs::path& path() const { return m_path; }

 private:
    fs::path m_path;
};

/** What a bare visit gives: something that the compiler cannot leave out. */
std::size_t visitLeaves(const octomap::OcTree& tree)
{
    std::size_t occupied = 0;
    for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf)
        occupied += tree.isNodeOccupied(*leaf) ? 1 : 0;
    return occupied;
}

struct Measurement
{
    std::size_t leaves = 0, places = 0, doors = 0;
    double cells = 0;
    double read_s = 0, visit_s = 0, compress_s = 0, extract_s = 0;  //!< medians
    double ratio = 0, leastRatio = 0, mostRatio = 0;  //!< of compression over visit, round by round
    double peakBytes = 0;                             //!< of reading and extraction
};

Measurement measure(const fs::path& path, const Settings& settings)
{
    const Gr2To gr2to(Gr2ToOptions::preset(settings.preset));
    Measurement m;
    m.peakBytes = static_cast<double>(peakBytesOf([] {}, [&] { gr2to.extract(*readOctree(path).tree); }));
    std::vector<double> reads, visits, compressions, extractions, ratios;
    for (int round = 0; round < settings.rounds; ++round) {
        OctreeFile file;
        reads.push_back(cpuSecondsOf([&] { file = readOctree(path); }));
        std::size_t occupied =
            visitLeaves(*file.tree);  // brings the tree into the caches that hold it, for both
        CompressedGrid compressed;
        visits.push_back(cpuSecondsOf([&] { occupied += visitLeaves(*file.tree); }));
        compressions.push_back(cpuSecondsOf([&] { compressed = gr2to.compress(*file.tree); }));
        ratios.push_back(compressions.back() / visits.back());
        Extraction extraction;
        extractions.push_back(cpuSecondsOf([&] { extraction = gr2to.extract(compressed); }));
        if (occupied == 0) throw std::runtime_error("no leaf is occupied");
        m.leaves = compressed.leaves;
        m.cells = static_cast<double>(compressed.grid.size());
        m.places = extraction.map.places().size();
        m.doors = 0;
        for (const Connection& connection : extraction.map.connections())
            m.doors += connection.doorway.real ? 1 : 0;
    }
    m.read_s = median(reads);
    m.visit_s = median(visits);
    m.compress_s = median(compressions);
    m.extract_s = median(extractions);
    m.ratio = median(ratios);
    m.leastRatio = *std::min_element(ratios.begin(), ratios.end());
    m.mostRatio = *std::max_element(ratios.begin(), ratios.end());
    return m;
}

void print(const std::string& name, const Measurement& m)
{
    char row[320];
    std::snprintf(
        row, sizeof row,
        " | %zu | %.2f | places=%zu | %zu | %.1f | %.1f | %.1f | %.2f [%.2f..%.2f] | %.1f | %.1f | %.0f |",
        m.leaves, m.cells / 1e6, m.places, m.doors, m.read_s * 1e3, m.visit_s * 1e3, m.compress_s * 1e3,
        m.ratio, m.leastRatio, m.mostRatio, m.extract_s * 1e3, (m.read_s + m.compress_s + m.extract_s) * 1e3,
        m.peakBytes / 1e6);
    std::cout << "| " << name << row << std::endl;
}

void measureTiles(const std::string& name, const VoxelBoxes& voxels, const Settings& settings)
{
    for (const int tiles : settings.tiles) {
        const ScratchFile file(test::binaryOctree(test::tiled(voxels, tiles)));
        print(name + (tiles > 1 ? ", " + std::to_string(tiles) + " x " + std::to_string(tiles) : ""),
              measure(file.path(), settings));
    }
}

void run(const Settings& settings)
{
    std::cout << "| octree | leaves | Mcell | places | doors | read ms | bare visit ms | eq. (7) ms | ratio "
                 "[least..most] "
                 "| stages 2-5 ms | all ms | peak MB |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    constexpr double HEIGHT_M = 2.6;
    if (settings.maps.empty())
        measureTiles("extruded floor", test::extruded(floorOfSide(settings.side), HEIGHT_M), settings);
    const TCompressionOptions options;
    for (const std::string& map : settings.maps)
        measureTiles(fs::path(map).filename().string(),
                     voxelsOf(*readOctree(map).tree, options.p_max, options.p_min), settings);
}
}  // namespace
}  // namespace gr2to::bench

int main(int argc, char** argv)
{
    gr2to::bench::Settings settings;
    CLI::App app(
        "CPU time and memory of octrees' way through Gr2To, the first stage beside a bare visit of all "
        "leaves by liboctomap");
    app.add_option("maps", settings.maps, "octrees (.bt, .ot); a generated floor when none is given");
    app.add_option("--tiles", settings.tiles, "copies side by side along either axis, one row each")
        ->delimiter(',')
        ->check(CLI::Range(1, 16));
    app.add_option("--preset", settings.preset, "options of Gr2To")->capture_default_str();
    app.add_option("--rounds", settings.rounds, "runs of all, in turn; medians are printed")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--side", settings.side, "cells along a side of the generated floor")
        ->check(CLI::Range(256, 4096))
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        gr2to::bench::run(settings);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "octree_benchmark: " << error.what() << "\n";
        return 1;
    }
}
