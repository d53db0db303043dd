#include "gr2to/grid/SegmentConflicts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gr2to
{
namespace
{
using Eigen::Vector2d;

constexpr double kBucket_cells = 16;

double cross(const Vector2d& a, const Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

bool isNear(const Vector2d& p, const Segment& s, double margin)
{
    const Vector2d along = s.to - s.from;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp((p - s.from).dot(along) / squared, 0.0, 1.0) : 0.0;
    return (p - s.from - t * along).squaredNorm() <= margin * margin;
}

bool cross(const Segment& s, const Segment& t)
{
    const Vector2d a = s.to - s.from, b = t.to - t.from;
    const double p = cross(a, t.from - s.from), q = cross(a, t.to - s.from);
    const double u = cross(b, s.from - t.from), v = cross(b, s.to - t.from);
    return ((p > 0) != (q > 0)) && ((u > 0) != (v > 0));
}

bool haveConflict(const Segment& s, const Segment& t, double margin)
{
    const bool startShared = s.start == t.start || s.start == t.end;
    const bool endShared = s.end == t.start || s.end == t.end;
    const bool fromShared = t.start == s.start || t.start == s.end;
    const bool toShared = t.end == s.start || t.end == s.end;
    if (startShared && endShared) return true;
    if ((!startShared && isNear(s.from, t, margin)) || (!endShared && isNear(s.to, t, margin))) return true;
    if ((!fromShared && isNear(t.from, s, margin)) || (!toShared && isNear(t.to, s, margin))) return true;
    return !startShared && !endShared && cross(s, t);
}

/** Square buckets with the segments that pass through them or nearby. */
class Buckets
{
 public:
    Buckets(const std::vector<Segment>& segments, double margin) : m_margin(margin)
    {
        Vector2d high = -m_low;
        for (const Segment& s : segments) {
            m_low = m_low.cwiseMin(s.from).cwiseMin(s.to);
            high = high.cwiseMax(s.from).cwiseMax(s.to);
        }
        m_columns = bucketOf(high.x() + margin, m_low.x() - margin) + 1;
        m_rows = bucketOf(high.y() + margin, m_low.y() - margin) + 1;
        m_begin.assign(m_columns * m_rows + 1, 0);
        for (const Segment& s : segments) visit(s, [&](std::size_t bucket) { ++m_begin[bucket + 1]; });
        for (std::size_t b = 0; b + 1 < m_begin.size(); ++b) m_begin[b + 1] += m_begin[b];
        std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
        m_members.resize(m_begin.back());
        for (std::size_t k = 0; k < segments.size(); ++k)
            visit(segments[k], [&](std::size_t bucket) { m_members[next[bucket]++] = k; });
    }

    /** Calls for every two segments in one bucket, perhaps more than once. */
    template <class Call>
    void forEachPair(const Call& call) const
    {
        for (std::size_t b = 0; b + 1 < m_begin.size(); ++b)
            for (std::size_t i = m_begin[b]; i < m_begin[b + 1]; ++i)
                for (std::size_t j = i + 1; j < m_begin[b + 1]; ++j) call(m_members[i], m_members[j]);
    }

 private:
    static std::size_t bucketOf(double at, double low)
    {
        return static_cast<std::size_t>(std::max(0.0, (at - low) / kBucket_cells));
    }

    /** Calls for the buckets of a segment: row by row those between where it enters and leaves the row. */
    template <class Call>
    void visit(const Segment& s, const Call& call) const
    {
        const Vector2d& a = s.from.y() <= s.to.y() ? s.from : s.to;
        const Vector2d& b = s.from.y() <= s.to.y() ? s.to : s.from;
        const double left = m_low.x() - m_margin, bottom = m_low.y() - m_margin;
        const double slope = b.y() > a.y() ? (b.x() - a.x()) / (b.y() - a.y()) : 0;
        const std::size_t firstRow = bucketOf(a.y() - m_margin, bottom),
                          lastRow = bucketOf(b.y() + m_margin, bottom);
        for (std::size_t row = firstRow; row <= lastRow; ++row) {
            const double lower = bottom + static_cast<double>(row) * kBucket_cells - m_margin;
            const double upper = lower + kBucket_cells + 2 * m_margin;
            double p = a.x(), q = b.x();
            if (slope != 0) {
                p = a.x() + slope * (std::clamp(lower, a.y(), b.y()) - a.y());
                q = a.x() + slope * (std::clamp(upper, a.y(), b.y()) - a.y());
            }
            const std::size_t last = bucketOf(std::max(p, q) + m_margin, left);
            for (std::size_t column = bucketOf(std::min(p, q) - m_margin, left); column <= last; ++column)
                call(row * m_columns + column);
        }
    }

    double m_margin;
    Vector2d m_low = Vector2d::Constant(std::numeric_limits<double>::infinity());
    std::size_t m_columns = 0, m_rows = 0;
    std::vector<std::size_t> m_begin;    //!< of each bucket's members, and the end of the last
    std::vector<std::size_t> m_members;  //!< segments, bucket by bucket
};
}  // namespace

std::vector<bool> findConflicts(const std::vector<Segment>& segments, double margin)
{
    std::vector<bool> inConflict(segments.size(), false);
    if (segments.empty()) return inConflict;
    Buckets(segments, margin).forEachPair([&](std::size_t i, std::size_t j) {
        if (inConflict[i] && inConflict[j]) return;
        if (haveConflict(segments[i], segments[j], margin)) inConflict[i] = inConflict[j] = true;
    });
    return inConflict;
}
}  // namespace gr2to
