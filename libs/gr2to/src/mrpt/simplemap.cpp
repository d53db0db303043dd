#include "gr2to/mrpt/simplemap.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>

#include "gr2to/grid/RayCasting.h"
#include "gr2to/io/XmlMap.h"
#include "gz.h"

namespace gr2to
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;

constexpr const char* kLabel = "gr2to";
constexpr std::size_t kFewestRays = 360;
constexpr double kGraze_cells = 0.1;  // MRPT adds up angles in single precision: some 1e-4 rad in a scan

/** Casts a scan on a grid around a point of the map frame. */
class ScanCaster
{
 public:
    ScanCaster(const ClassifiedGrid& grid, const mrpt::math::TPoint3D& center)
        : m_grid(grid), m_start(grid.frame().toGrid(center.x, center.y))
    {
    }

    bool startsFree() const
    {
        return m_grid.isFree(
            {static_cast<int>(std::lround(m_start.x())), static_cast<int>(std::lround(m_start.y()))});
    }

    CObservation2DRangeScan::Ptr cast(const TSimplemapOptions& options) const
    {
        const double reach_cells =
            std::min(longestOf(kFewestRays), options.dense_range / m_grid.resolution_m());
        const auto wanted =
            static_cast<std::size_t>(std::ceil(options.rays_per_cell * 2 * M_PI * reach_cells));
        return scanOf(std::max(kFewestRays, wanted));
    }

 private:
    RayEnd ray(std::size_t i, std::size_t count) const
    {
        const double angle =
            -M_PI + 2 * M_PI * static_cast<double>(i) / static_cast<double>(count) - m_grid.frame().yaw_rad;
        return castRay(m_grid, m_start, {std::cos(angle), std::sin(angle)});
    }

    double longestOf(std::size_t count) const
    {
        double longest = 0;
        for (std::size_t i = 0; i < count; ++i) longest = std::max(longest, ray(i, count).leave);
        return longest;
    }

    CObservation2DRangeScan::Ptr scanOf(std::size_t count) const
    {
        auto scan = CObservation2DRangeScan::Create();
        scan->aperture = static_cast<float>(2 * M_PI);
        scan->beamAperture = static_cast<float>(2 * M_PI / static_cast<double>(count));
        scan->stdError = static_cast<float>(m_grid.resolution_m() / std::sqrt(12.0));
        scan->rightToLeft = true;
        scan->resizeScan(count);
        float longest = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const RayEnd end = ray(i, count);
            const bool echo = end.state == CellState::Occupied && end.leave - end.enter > kGraze_cells;
            const double length = echo ? (end.enter + end.leave) / 2 : end.enter;
            const auto range = static_cast<float>(length * m_grid.resolution_m());
            scan->setScanRange(i, range);
            scan->setScanRangeValidity(i, echo);
            longest = std::max(longest, range);
        }
        scan->maxRange = longest;
        return scan;
    }

    const ClassifiedGrid& m_grid;
    Eigen::Vector2d m_start;
};

mrpt::poses::CPose3DPDFGaussian poseOf(const Place& place, double resolution_m)
{
    mrpt::poses::CPose3DPDFGaussian pose;
    pose.mean = mrpt::poses::CPose3D(place.center.x, place.center.y, place.center.z, 0, 0, 0);
    pose.cov.setZero();
    pose.cov(0, 0) = pose.cov(1, 1) = resolution_m * resolution_m / 12;
    return pose;
}

/** From the centre, and of a corridor, which nobody sees whole from there, from its doorways too. */
std::vector<CObservation2DRangeScan::Ptr> scansOf(const Place& place,
                                                  const std::vector<Connection>& connections,
                                                  const ClassifiedGrid& grid,
                                                  const TSimplemapOptions& options)
{
    std::vector<CObservation2DRangeScan::Ptr> scans;
    const auto castFrom = [&](const mrpt::math::TPoint3D& at) {
        const ScanCaster caster(grid, at);
        if (!caster.startsFree()) return;
        scans.push_back(caster.cast(options));
        scans.back()->sensorPose =
            mrpt::poses::CPose3D(at.x - place.center.x, at.y - place.center.y, 0, 0, 0, 0);
    };
    castFrom(place.center);
    if (place.kind != PlaceKind::Corridor) return scans;
    for (const Connection& c : connections)
        if (c.from == place.id || c.to == place.id) castFrom(c.doorway.position.mean);
    return scans;
}

mrpt::obs::CObservationImage::Ptr imageOf(const View& view, const Place& place)
{
    auto image = mrpt::obs::CObservationImage::Create();
    image->image.setExternalStorage(view.image);
    const auto& at = view.position.mean;
    image->cameraPose =
        mrpt::poses::CPose3D(at.x - place.center.x, at.y - place.center.y, at.z - place.center.z, 0, 0, 0);
    return image;
}
}  // namespace

std::vector<OptionField> TSimplemapOptions::fields()
{
    return {
        {"rays_per_cell", &rays_per_cell, "",
         "Rays of a keyframe's scan for each cell of the circle at its longest range.", 0.1, 20},
        {"dense_range", &dense_range, "m", "The most range that the number of rays is chosen for.", 1, 1000}};
}

mrpt::maps::CSimpleMap toSimplemap(const TopologicalMap& map, const ClassifiedGrid& grid,
                                   const TSimplemapOptions& options)
{
    options.check();
    mrpt::maps::CSimpleMap keyframes;
    const std::vector<Connection> connections = map.connections();
    for (const auto& [id, place] : map.places()) {
        auto frame = mrpt::obs::CSensoryFrame::Create();
        const auto add = [&](const mrpt::obs::CObservation::Ptr& observation, double time_s) {
            observation->timestamp = mrpt::Clock::fromDouble(time_s);
            observation->sensorLabel = kLabel;
            frame->insert(observation);
        };
        for (const auto& scan : scansOf(place, connections, grid, options)) add(scan, id);
        auto comment = mrpt::obs::CObservationComment::Create();
        comment->text = toXml(place);
        add(comment, id);
        for (const View& view : place.views) add(imageOf(view, place), view.time_s > 0 ? view.time_s : id);
        keyframes.insert(mrpt::poses::CPose3DPDFGaussian::Create(poseOf(place, grid.resolution_m())), frame);
    }
    return keyframes;
}

std::string encodeSimplemap(const mrpt::maps::CSimpleMap& map)
{
    mrpt::io::CMemoryStream stream;
    mrpt::serialization::archiveFrom(stream) << map;
    return compressGz({static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()});
}
}  // namespace gr2to
