#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gr2to/io/GridReader.h"
#include "gr2to/pipeline/Gr2To.h"
#include "gr2to/view/Overlay.h"

namespace gr2to::cli
{
/** How many of what a topological map has. */
struct MapCounts
{
    std::size_t places = 0;
    std::size_t rooms = 0;
    std::size_t corridors = 0;
    std::size_t doors = 0;     //!< real doorways
    std::size_t openings = 0;  //!< virtual ones

    explicit MapCounts(const TopologicalMap& map);
    MapCounts() = default;
};

/** What `gr2to extract` did, for people and for programs. */
class ExtractReport
{
 public:
    std::string input;
    std::string format;
    std::string preset;
    std::filesystem::path folder;
    std::optional<CompressedRange> range;  //!< of a 3D map
    std::vector<OptionTable*> options;     //!< as they were used
    std::vector<StageReport> stages;
    std::vector<std::filesystem::path> files;

    /** Notes the most memory that the process has held so far, as what it took before it read anything. */
    void noteProgramMemory();
    /** The same, as what it took up to the last stage of the pipeline. */
    void noteStagesMemory();
    void describe(const ClassifiedGrid& grid, const TopologicalMap& map);
    /** A table of the stages and what to open. */
    std::string text() const;
    std::string json() const;

 private:
    double bytesPerCell() const;

    int m_width = 0;
    int m_height = 0;
    GridFrame m_frame;
    MapCounts m_counts;
    std::size_t m_programBytes = 0;
    std::size_t m_stagesBytes = 0;
};
}  // namespace gr2to::cli
