#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gr2to/stages/DoorDetection.h"
#include "gr2to/stages/GridCompression.h"
#include "gr2to/stages/GridFiltering.h"
#include "gr2to/stages/PlaceConstruction.h"
#include "gr2to/stages/PlaceCutting.h"
#include "gr2to/stages/SpaceDelimitation.h"
#include "gr2to/stages/VoronoiExtraction.h"
#include "gr2to/stages/WallExtraction.h"

namespace gr2to
{
struct TDistanceOptions : OptionTable
{
    bool unknown_is_obstacle = true;

    std::string section() const override { return "distance"; }
    std::vector<OptionField> fields() override;
};

/** The options of all stages. */
struct Gr2ToOptions
{
    TCompressionOptions compression;
    TWallOptions wall;
    TFilterOptions filter;
    TDistanceOptions distance;
    TDoorOptions door;
    TVoronoiOptions voronoi;
    TPlaceOptions place;
    TCutOptions cut;
    TDelimitationOptions delimitation;

    /** Names of the presets, the default one first. */
    static std::vector<std::string> presets();
    /** \param preset `default`, or `paper`: the paper's method to the letter, as doc/algorithm.md reads it
     * \throws std::invalid_argument  unknown preset; the message names the nearest
     */
    static Gr2ToOptions preset(const std::string& name);

    /** The tables, in the order of the stages; they point into this object. */
    std::vector<OptionTable*> tables();
    /** Sets `section.name`. \throws std::invalid_argument  unknown key (the nearest is named) or bad value */
    void set(const std::string& key, const std::string& value);
    /** Reads an ini file in MRPT's format. \throws std::invalid_argument  unknown section or key, bad value
     */
    void loadFrom(const mrpt::config::CConfigFileBase& source);
    /** \throws std::invalid_argument  an option breaks its rule */
    void check();
    /** Whether an option `section.name` has no effect on grids as long as `cut.along_walls` is as it is. */
    bool isIdle(const std::string& key) const;
};

/** What a stage did: for the table at the end of `gr2to extract`. */
struct StageReport
{
    std::string stage;
    std::vector<std::pair<std::string, std::size_t>> counts;  //!< what it found, by name
    double seconds = 0;
    std::size_t bytes = 0;  //!< held by its results
};

/** The map and everything that was found on the way to it. */
struct Extraction
{
    ClassifiedGrid grid;  //!< after the filter: the cells that all else speaks of
    WallLines walls;      //!< empty unless places are cut along them
    DistanceMap distances;
    std::vector<DoorCandidate> doorCandidates;
    VoronoiGraph voronoi;
    std::vector<CriticalPoint> criticalPoints;
    PlaceGraph graph;
    PlaceImage places;
    TopologicalMap map;
    std::vector<StageReport> reports;
};

/** From a 3D or 2D occupancy grid to an augmented topological map, in the paper's five stages.
 *
 * Deterministic: the same grid and options give the same result. Source: Gr2To paper, section 4.
 */
class Gr2To
{
 public:
    /** \throws std::invalid_argument  an option breaks its rule */
    explicit Gr2To(Gr2ToOptions options = Gr2ToOptions::preset("default"));

    /** \throws InputError  the grid has no free or no occupied cell; see requireUsable() in io */
    Extraction extract(const ClassifiedGrid& input) const;

    /** First stage of 3D input, eq. (7). \param report  when given, receives what the stage did
     * \throws InputError  see GridCompressor::compress()
     */
    CompressedGrid compress(const octomap::OcTree& tree, StageReport* report = nullptr) const;
    /** All else of 3D input: as of 2D input, with heights. */
    Extraction extract(const CompressedGrid& input) const;
    /** All stages. */
    Extraction extract(const octomap::OcTree& tree) const;

 private:
    Extraction extract(const ClassifiedGrid& input, const HeightMap& heights) const;

    Gr2ToOptions m_options;
};
}  // namespace gr2to
