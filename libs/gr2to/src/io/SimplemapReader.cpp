#include "io/SimplemapReader.h"

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDF.h>
#include <mrpt/poses/CPosePDF.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "gr2to/base/errors.h"
#include "gr2to/io/PlanarScan.h"
#include "io/ArchiveObjects.h"
#include "io/Gridmap.h"
#include "io/Gzip.h"
#include "io/ImageRule.h"
#include "io/errorText.h"

namespace gr2to::io
{
using mrpt::maps::CSimpleMap;
using mrpt::obs::CSensoryFrame;
using mrpt::poses::CPose3DPDF;
using mrpt::poses::CPosePDF;

namespace
{
constexpr int kNewestVersion = 1;
constexpr char kEndFlag = '\x88';

template <class T>
std::shared_ptr<T> take(ArchiveObjects& objects, const char* what, std::size_t keyframe)
{
    auto object = std::dynamic_pointer_cast<T>(objects.next());
    if (!object)
        throw InputError(objects.name() + " is damaged: keyframe " + std::to_string(keyframe) + " has no " +
                         what);
    return object;
}

CPose3DPDF::Ptr takePose(ArchiveObjects& objects, int version, std::size_t keyframe)
{
    if (version > 0) return take<CPose3DPDF>(objects, "3D pose", keyframe);
    return CPose3DPDF::Ptr(CPose3DPDF::createFrom2D(*take<CPosePDF>(objects, "2D pose", keyframe)));
}

/** Classes and how often each occurs, in words. */
std::string listOf(const std::map<std::string, std::size_t>& classes)
{
    std::string text;
    for (const auto& [name, count] : classes)
        text.append(text.empty() ? "" : ", ").append(std::to_string(count)).append(" ").append(name);
    return text.empty() ? "none" : text;
}

/** Builds the grid as MRPT's CMetricMap::loadFromSimpleMap() does, but counts and checks on the way. */
class GridBuilder
{
 public:
    GridBuilder(std::string name, double resolution_m, const TScanOptions& options)
        : m_name(std::move(name)), m_resolution(resolution_m), m_options(options)
    {
    }

    void insert(const CSimpleMap& map)
    {
        for (std::size_t i = 0; i < map.size(); ++i) {
            const auto [pdf, frame] = map.get(i);
            const mrpt::poses::CPose3D pose = pdf->getMeanVal();
            makeRoomFor(pose, i);
            for (const auto& observation : *frame) insert(*observation, pose);
        }
        if (counts.inserted > 0) return;
        throw InputError(m_name + " has no observation that a grid can be built of; it holds " +
                         std::to_string(map.size()) +
                         " keyframes with these observations: " + listOf(m_classes) +
                         "; horizontal laser scans and range images are needed (see scans.max_tilt)");
    }

    mrpt::maps::COccupancyGridMap2D grid;
    ScanCounts counts;

 private:
    /** Refuses what would take all memory before MRPT asks for it. */
    void makeRoomFor(const mrpt::poses::CPose3D& pose, std::size_t keyframe)
    {
        const double cellsAround = m_options.max_range / m_resolution;
        const double x = pose.x() / m_resolution, y = pose.y() / m_resolution;
        if (keyframe == 0) {
            m_low[0] = m_high[0] = x;
            m_low[1] = m_high[1] = y;
            const auto at = [&](double metres, double add) { return static_cast<float>(metres + add); };
            grid.setSize(at(pose.x(), -1), at(pose.x(), 1), at(pose.y(), -1), at(pose.y(), 1),
                         static_cast<float>(m_resolution), 0.5f);
            m_options.applyTo(grid);
        }
        m_low[0] = std::min(m_low[0], x), m_high[0] = std::max(m_high[0], x);
        m_low[1] = std::min(m_low[1], y), m_high[1] = std::max(m_high[1], y);
        const double width = m_high[0] - m_low[0] + 2 * cellsAround,
                     height = m_high[1] - m_low[1] + 2 * cellsAround;
        // Written so that NaN and infinity fail as well.
        if (!(std::max(width, height) <= ClassifiedGrid::maxSide()) ||
            !(std::abs(x) + std::abs(y) < kFarthest))
            throw InputError(m_name + ": keyframe " + std::to_string(keyframe) + " lies at (" +
                             numberText(pose.x()) + ", " + numberText(pose.y()) +
                             ") m, so that the grid could need more than " +
                             std::to_string(ClassifiedGrid::maxSide()) +
                             " cells a side; choose a coarser --resolution or a smaller scans.max_range");
    }

    void insert(const mrpt::obs::CObservation& observation, const mrpt::poses::CPose3D& pose)
    {
        ++counts.observations;
        ++m_classes[observation.GetRuntimeClass()->className];
        const auto scan = planarScanOf(observation);
        if (grid.insertObservation(scan ? *scan : observation, pose)) ++counts.inserted;
    }

    static constexpr double kFarthest =
        1e8;  // cells; floats, which MRPT counts in, no longer tell them apart

    std::string m_name;
    double m_resolution;
    const TScanOptions& m_options;
    std::map<std::string, std::size_t> m_classes;
    double m_low[2]{};
    double m_high[2]{};
};
}  // namespace

CSimpleMap readSimplemap(std::string_view bytes, const std::string& name)
{
    constexpr std::size_t mostBytes = std::size_t{4} << 30U;
    std::string unpacked;
    if (isGzip(bytes)) {
        GzipReader gzip(bytes, name);
        gzip.readUpTo(unpacked, mostBytes);
        if (!gzip.finished()) throw InputError(name + " unpacks to more than 4 GiB; split the map");
        bytes = unpacked;
    }
    const auto header = archiveHeader(bytes);
    if (!header || kindOfClass(header->className) != "a simplemap")
        throw InputError(name + " holds no MRPT simplemap; check that it is the right file");
    if (header->version > kNewestVersion)
        throw InputError(name + " is a simplemap of version " + std::to_string(header->version) +
                         ", of a newer MRPT; this one reads up to version " + std::to_string(kNewestVersion) +
                         ": store it with MRPT 2.5");
    ArchiveObjects objects(bytes, name);
    objects.skip(header->size);
    CSimpleMap map;
    const std::uint32_t count = objects.nextNumber();
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto pose = takePose(objects, header->version, i);
        map.insert(pose, take<CSensoryFrame>(objects, "observations", i));
    }
    const std::string_view end(&kEndFlag, header->hasEndFlag ? 1 : 0);
    if (objects.rest().size() < end.size())
        throw EarlyEnd(name + " is truncated: the mark of its end is missing; get the whole file");
    if (objects.rest() != end)
        throw InputError(name + " is damaged: more data follow than its " + std::to_string(count) +
                         " keyframes");
    return map;
}

ClassifiedGrid gridOfSimplemap(const CSimpleMap& map, const std::string& name, double resolution_m,
                               const TScanOptions& options, const OccupancyThresholds& thresholds,
                               ScanCounts& counts)
{
    if (map.empty()) throw InputError(name + " is a simplemap without a keyframe; record one with scans");
    GridBuilder builder(name, resolution_m, options);
    builder.counts.keyframes = map.size();
    builder.insert(map);
    counts = builder.counts;
    return fromOccupancyGrid(builder.grid, thresholds);
}
}  // namespace gr2to::io
