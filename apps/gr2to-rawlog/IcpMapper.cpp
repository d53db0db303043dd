#include "IcpMapper.h"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <algorithm>
#include <chrono>

#include "gr2to/io/PlanarScan.h"

namespace gr2to::rawlog
{
using mrpt::obs::CActionCollection;
using mrpt::obs::CObservation;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationImage;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CSensoryFrame;

namespace
{
/** What differs from MRPT's defaults: more keyframes, and a points map to match with. */
void setDefaults(mrpt::slam::CMetricMapBuilderICP& builder)
{
    builder.ICP_params.maxIterations = 80;
    builder.ICP_params.thresholdDist = 0.3;
    builder.ICP_params.thresholdAng = mrpt::DEG2RAD(5.0);
    builder.ICP_params.ALFA = 0.8;
    builder.ICP_params.smallestThresholdDist = 0.05;
    builder.ICP_params.onlyUniqueRobust = true;
    builder.ICP_options.localizationLinDistance = 0.2;
    builder.ICP_options.localizationAngDistance = mrpt::DEG2RAD(5.0);
    builder.ICP_options.insertionLinDistance = 0.5;
    builder.ICP_options.insertionAngDistance = mrpt::DEG2RAD(20.0);
}

/** The colour image of a range image; null when it has none. */
CObservationImage::Ptr imageOf(const CObservation& observation)
{
    const auto& depth = dynamic_cast<const mrpt::obs::CObservation3DRangeScan&>(observation);
    if (!depth.hasIntensityImage) return nullptr;
    auto image = CObservationImage::Create();
    image->image = depth.intensityImage;
    image->cameraParams = depth.cameraParamsIntensity;
    image->cameraPose = depth.sensorPose;
    image->sensorLabel = depth.sensorLabel + "_image";
    image->timestamp = depth.timestamp;
    return image;
}
}  // namespace

IcpMapper::IcpMapper(const mrpt::config::CConfigFileBase& config) : m_now(mrpt::Clock::fromDouble(1))
{
    m_builder.setVerbosityLevel(mrpt::system::LVL_ERROR);
    setDefaults(m_builder);
    m_builder.ICP_params.loadFromConfigFile(config, "ICP");
    m_builder.ICP_options.loadFromConfigFile(config, "MappingApplication");
    if (m_builder.ICP_options.mapInitializers.size() == 0) {
        mrpt::maps::CSimplePointsMap::TMapDefinition points;
        points.insertionOpts.minDistBetweenLaserPoints = 0.05f;
        points.insertionOpts.isPlanarMap = true;
        m_builder.ICP_options.mapInitializers.push_back(points);
    }
    m_builder.setVerbosityLevel(mrpt::system::LVL_ERROR);
    m_builder.initialize();
}

void IcpMapper::process(const mrpt::serialization::CSerializable::Ptr& entry)
{
    if (const auto action = std::dynamic_pointer_cast<CActionCollection>(entry))
        m_action = action;
    else if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(entry))
        processFrame(*frame);
    else if (const auto observation = std::dynamic_pointer_cast<CObservation>(entry))
        for (const auto& one : usable(observation)) {
            if (one->timestamp == INVALID_TIMESTAMP ||
                (IS_CLASS(*one, CObservationOdometry) && one->timestamp <= m_now))
                one->timestamp = laterTime();
            m_now = std::max(m_now, one->timestamp);
            m_builder.processObservation(one);
        }
}

void IcpMapper::processFrame(const CSensoryFrame& frame)
{
    CSensoryFrame used;
    for (const auto& observation : frame)
        for (const auto& one : usable(observation)) used.insert(one);
    CActionCollection none;
    CActionCollection& action = m_action ? *m_action : none;
    stamp(used, action);
    m_builder.processActionObservation(action, used);
    m_action.reset();
}

/** Odometry without time, or with times that do not grow, has no speed: MRPT's estimator would jump. */
void IcpMapper::stamp(CSensoryFrame& frame, CActionCollection& action)
{
    constexpr std::chrono::milliseconds LEAST_STEP(1);
    mrpt::system::TTimeStamp time = INVALID_TIMESTAMP;
    for (const auto& observation : frame)
        if (time == INVALID_TIMESTAMP) time = observation->timestamp;
    const bool useless = time == INVALID_TIMESTAMP || time < m_now + LEAST_STEP;
    if (useless) time = laterTime();
    for (auto& observation : frame)
        if (useless || observation->timestamp == INVALID_TIMESTAMP) observation->timestamp = time;
    for (auto& one : action)
        if (useless || one->timestamp == INVALID_TIMESTAMP || one->timestamp <= m_now) one->timestamp = time;
    m_now = time;
}

mrpt::system::TTimeStamp IcpMapper::laterTime() const
{
    constexpr std::chrono::milliseconds STEP(100);
    return m_now + STEP;
}

std::vector<CObservation::Ptr> IcpMapper::usable(const CObservation::Ptr& observation)
{
    std::vector<CObservation::Ptr> used;
    if (const auto scan = planarScanOf(*observation)) {
        used.push_back(scan);
        if (const auto image = imageOf(*observation)) used.push_back(image);
    } else if (IS_CLASS(*observation, CObservation2DRangeScan) ||
               IS_CLASS(*observation, CObservationOdometry) || IS_CLASS(*observation, CObservationImage))
        used.push_back(observation);
    else
        ++m_ignored[observation->GetRuntimeClass()->className];
    if (!used.empty() && IS_CLASS(*used.front(), CObservation2DRangeScan)) ++m_scans;
    return used;
}

mrpt::maps::CSimpleMap IcpMapper::map() const
{
    mrpt::maps::CSimpleMap map;
    m_builder.getCurrentlyBuiltMap(map);
    return map;
}
}  // namespace gr2to::rawlog
