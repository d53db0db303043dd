#include "support/rawlogs.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>

#include "gr2to/grid/RayCasting.h"
#include "support/rooms.h"

namespace gr2to::test
{
namespace
{
mrpt::obs::CObservation2DRangeScan::Ptr scanAt(const ClassifiedGrid& grid, double x_m, double y_m)
{
    constexpr std::size_t RAYS = 361;
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    scan->aperture = static_cast<float>(2 * M_PI);
    scan->maxRange = 20;
    scan->sensorLabel = "laser";
    scan->resizeScan(RAYS);
    for (std::size_t i = 0; i < RAYS; ++i) {
        const double angle = -M_PI + 2 * M_PI * static_cast<double>(i) / (RAYS - 1);
        const RayEnd end = castRay(grid, grid.frame().toGrid(x_m, y_m), {std::cos(angle), std::sin(angle)});
        scan->setScanRange(i, static_cast<float>(end.enter * grid.resolution_m()));
        scan->setScanRangeValidity(i, true);
    }
    return scan;
}

/** Two rooms of 2.95 m by 2.95 m and a door of 0.85 m between them. */
ClassifiedGrid world()
{
    return twoSquareRooms();
}
}  // namespace

std::string archiveOf(const std::vector<const mrpt::serialization::CSerializable*>& objects)
{
    mrpt::io::CMemoryStream stream;
    auto archive = mrpt::serialization::archiveFrom(stream);
    for (const auto* object : objects) archive << *object;
    return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}

std::string walkThroughRooms(int steps, bool timestamps)
{
    constexpr double STEP_m = 0.2, PERIOD_s = 0.5, START_s = 1e9;
    const ClassifiedGrid grid = world();
    std::string bytes;
    for (int i = 0; i < steps; ++i) {
        const auto time = timestamps ? mrpt::Clock::fromDouble(START_s + i * PERIOD_s) : INVALID_TIMESTAMP;
        mrpt::obs::CActionRobotMovement2D movement;
        movement.computeFromOdometry(mrpt::poses::CPose2D(i == 0 ? 0 : STEP_m, 0, 0), {});
        movement.timestamp = time;
        mrpt::obs::CActionCollection actions;
        actions.insert(movement);
        mrpt::obs::CSensoryFrame frame;
        const auto scan = scanAt(grid, 1 + i * STEP_m, 1.5);
        scan->timestamp = time;
        frame.insert(scan);
        bytes += archiveOf({&actions, &frame});
    }
    return bytes;
}
}  // namespace gr2to::test
