#pragma once

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/slam/CMetricMapBuilderICP.h>

#include <map>
#include <string>
#include <vector>

namespace gr2to::rawlog
{
/** Makes a simplemap of a rawlog's entries, by MRPT's CMetricMapBuilderICP.
 *
 * Used are laser scans, range images (as the scans that planarScanOf() makes of them) and odometry, as
 * observations or as actions; images go along into the
 * keyframes. What lacks a time gets that of its frame; a frame that lacks one, or is not
 * a millisecond later than the one before, is taken to come 0.1 s after it.
 */
class IcpMapper
{
 public:
    /** \param config  sections [ICP] and [MappingApplication], as MRPT's icp-slam reads them; MRPT's and
     * these defaults stand in for what is missing \throws std::exception  as MRPT reports a configuration
     * that it cannot use
     */
    explicit IcpMapper(const mrpt::config::CConfigFileBase& config);

    void process(const mrpt::serialization::CSerializable::Ptr& entry);
    mrpt::maps::CSimpleMap map() const;

    std::size_t scans() const { return m_scans; }
    /** How many observations were not used, by their class. */
    const std::map<std::string, std::size_t>& ignored() const { return m_ignored; }

 private:
    void processFrame(const mrpt::obs::CSensoryFrame& frame);
    /** What of an observation goes into the map; nothing when it is of no use. */
    std::vector<mrpt::obs::CObservation::Ptr> usable(const mrpt::obs::CObservation::Ptr& observation);
    /** Gives times to what lacks one. */
    void stamp(mrpt::obs::CSensoryFrame& frame, mrpt::obs::CActionCollection& action);
    mrpt::system::TTimeStamp laterTime() const;

    mrpt::slam::CMetricMapBuilderICP m_builder;
    mrpt::obs::CActionCollection::Ptr m_action;  //!< that the next frame belongs to
    mrpt::system::TTimeStamp m_now;
    std::size_t m_scans = 0;
    std::map<std::string, std::size_t> m_ignored;
};
}  // namespace gr2to::rawlog
