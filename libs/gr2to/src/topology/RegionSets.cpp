#include "gr2to/topology/RegionSets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gr2to
{
namespace
{
constexpr double kQuarterTurn = 1.57079632679489661923;
constexpr double kSameFrame_rad = 0.12;  // about 7 degrees: rectangles hardly differ
}  // namespace

RegionSets::Extent::Extent()
{
    minAlong.fill(std::numeric_limits<double>::infinity());
    minAcross.fill(std::numeric_limits<double>::infinity());
    maxAlong.fill(-std::numeric_limits<double>::infinity());
    maxAcross.fill(-std::numeric_limits<double>::infinity());
}

void RegionSets::Extent::include(const Extent& other)
{
    for (std::size_t k = 0; k < kMostFrames; ++k) {
        minAlong[k] = std::min(minAlong[k], other.minAlong[k]);
        maxAlong[k] = std::max(maxAlong[k], other.maxAlong[k]);
        minAcross[k] = std::min(minAcross[k], other.minAcross[k]);
        maxAcross[k] = std::max(maxAcross[k], other.maxAcross[k]);
    }
}

/** Directions at right angles have one frame, and so have directions that nearly agree. */
std::vector<RegionSets::Frame> RegionSets::framesOf(const std::vector<LineDirection>& directions)
{
    std::vector<double> angles;
    for (const LineDirection& direction : directions) {
        double angle = std::fmod(
            0.5 * std::atan2(direction.doubleSin(), direction.doubleCos()) + kQuarterTurn, kQuarterTurn);
        const bool known = std::any_of(angles.begin(), angles.end(), [&](double other) {
            const double difference = std::abs(angle - other);
            return std::min(difference, kQuarterTurn - difference) < kSameFrame_rad;
        });
        if (!known && angles.size() < kMostFrames) angles.push_back(angle);
    }
    if (angles.empty()) angles.push_back(0);
    std::vector<Frame> frames;
    frames.reserve(angles.size());
    for (const double angle : angles) frames.push_back({std::cos(angle), std::sin(angle)});
    return frames;
}

RegionSets::RegionSets(const FaceMap& faces, const DistanceMap& distances,
                       const std::vector<LineDirection>& directions)
    : m_frames(framesOf(directions)),
      m_parent(static_cast<std::size_t>(faces.count()) + 1),
      m_cells(m_parent.size()),
      m_squaredRadius(m_parent.size()),
      m_extents(m_parent.size())
{
    std::iota(m_parent.begin(), m_parent.end(), 0);
    const std::vector<int>& ofCell = faces.ofCell();
    const auto width = static_cast<std::size_t>(distances.width);
    for (std::size_t begin = 0; begin < ofCell.size();) {  // runs of cells of one face in one row
        const std::size_t row = begin / width, rowEnd = (row + 1) * width;
        std::size_t end = begin + 1;
        while (end < rowEnd && ofCell[end] == ofCell[begin]) ++end;
        if (ofCell[begin] != 0) {
            const auto face = static_cast<std::size_t>(ofCell[begin]);
            m_cells[face] += static_cast<std::int64_t>(end - begin);
            for (std::size_t i = begin; i < end; ++i)
                m_squaredRadius[face] = std::max(m_squaredRadius[face], distances.squared[i]);
            const auto y = static_cast<double>(row);
            include(face, static_cast<double>(begin - row * width), y);
            include(face, static_cast<double>(end - 1 - row * width), y);
        }
        begin = end;
    }
}

void RegionSets::include(std::size_t face, double x, double y)
{
    Extent& extent = m_extents[face];
    for (std::size_t k = 0; k < m_frames.size(); ++k) {
        const double along = x * m_frames[k].cos + y * m_frames[k].sin;
        const double across = y * m_frames[k].cos - x * m_frames[k].sin;
        extent.minAlong[k] = std::min(extent.minAlong[k], along);
        extent.maxAlong[k] = std::max(extent.maxAlong[k], along);
        extent.minAcross[k] = std::min(extent.minAcross[k], across);
        extent.maxAcross[k] = std::max(extent.maxAcross[k], across);
    }
}

int RegionSets::find(int face)
{
    auto f = static_cast<std::size_t>(face);
    while (m_parent[f] != static_cast<int>(f))
        f = static_cast<std::size_t>(m_parent[f] = m_parent[static_cast<std::size_t>(m_parent[f])]);
    return static_cast<int>(f);
}

void RegionSets::join(int region, int other)
{
    const auto a = static_cast<std::size_t>(region), b = static_cast<std::size_t>(other);
    m_parent[b] = region;
    m_cells[a] += m_cells[b];
    m_squaredRadius[a] = std::max(m_squaredRadius[a], m_squaredRadius[b]);
    m_extents[a].include(m_extents[b]);
}

double RegionSets::radius_cells(int region) const
{
    return std::sqrt(static_cast<double>(m_squaredRadius[static_cast<std::size_t>(region)]));
}

double RegionSets::rectangularity(int region, int other) const
{
    Extent extent = m_extents[static_cast<std::size_t>(region)];
    extent.include(m_extents[static_cast<std::size_t>(other)]);
    const auto filled = static_cast<double>(cells(region) + (region == other ? 0 : cells(other)));
    double best = 0;
    for (std::size_t k = 0; k < m_frames.size(); ++k)
        best = std::max(best, filled / ((extent.maxAlong[k] - extent.minAlong[k] + 1) *
                                        (extent.maxAcross[k] - extent.minAcross[k] + 1)));
    return std::min(best, 1.0);
}
}  // namespace gr2to
