#include "gr2to/grid/SimplifiedArc.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gr2to
{
namespace
{
using Eigen::Vector2d;

constexpr double kMostShift_cells = 0.75;  // the corners of steps are as far from their middle
constexpr double kJog_cells = 0.5;         // less is no more than a step
constexpr double kMuchCloser = 0.25;       // of the distance, when a side is no slope but has a jog
constexpr int kMostSplits = 2;             // of a side with jogs at both ends, one after the other
constexpr double kStraight = 0.3;  // sine of the turn below which two sides move their common vertex as one

double cross(const Vector2d& a, const Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

Vector2d leftNormal(const Vector2d& from, const Vector2d& to)
{
    const Vector2d along = to - from;
    const double length = along.norm();
    return length > 0 ? Vector2d(-along.y() / length, along.x() / length) : Vector2d(0, 0);
}

double squaredDistance(const Vector2d& p, const Vector2d& a, const Vector2d& b)
{
    const Vector2d along = b - a;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
    return (p - a - t * along).squaredNorm();
}
}  // namespace

SimplifiedArc::SimplifiedArc(const std::vector<Vector2d>& chain, bool closed, double tolerance)
    : m_chain(&chain),
      m_closed(closed),
      m_tolerance(tolerance),
      m_kept(chain.size(), false),
      m_pinned(chain.size(), false)
{
    const std::size_t last = chain.size() - 1;
    m_kept[0] = m_kept[last] = true;
    if (closed) m_kept[farthest(0, last, nullptr)] = true;
    update();
}

void SimplifiedArc::refine(std::size_t side)
{
    const std::size_t first = m_chosen[side], last = m_chosen[side + 1];
    if (m_pinned[first] && m_pinned[last]) {
        if (last - first > 1) m_kept[farthest(first, last, nullptr)] = true;
        return;
    }
    m_pinned[first] = m_pinned[last] = true;
    if (m_closed && (first == 0 || last + 1 == m_chain->size())) m_pinned.front() = m_pinned.back() = true;
}

void SimplifiedArc::tighten()
{
    m_tolerance /= 2;
}

void SimplifiedArc::update()
{
    std::vector<std::size_t> before;
    for (std::size_t k = 0; k < m_kept.size(); ++k)
        if (m_kept[k]) before.push_back(k);
    for (std::size_t k = 0; k + 1 < before.size(); ++k) choose(before[k], before[k + 1]);
    m_chosen.clear();
    for (std::size_t k = 0; k < m_kept.size(); ++k)
        if (m_kept[k]) m_chosen.push_back(k);
    place();
}

/** Douglas and Peucker's rule between two kept points. */
void SimplifiedArc::choose(std::size_t first, std::size_t last)
{
    std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        if (to - from < 2) continue;
        double distance = 0;
        const std::size_t middle = farthest(from, to, &distance);
        const bool atNode = !m_closed && (from == 0 || to + 1 == m_chain->size());
        if (distance <= m_tolerance && !(atNode && hasJogs(from, to, distance))) continue;
        m_kept[middle] = true;
        open.emplace_back(from, middle);
        open.emplace_back(middle, to);
    }
}

/** Whether a few more vertices bring a side much closer to the chain: where a wall's face ends beside a node,
 * a side without them would run askew from the wall's other end to the node. */
bool SimplifiedArc::hasJogs(std::size_t first, std::size_t last, double distance) const
{
    return distance > kJog_cells && isReached(first, last, kMuchCloser * distance, kMostSplits);
}

bool SimplifiedArc::isReached(std::size_t first, std::size_t last, double distance, int splits) const
{
    if (last - first < 2) return true;
    double least = 0;
    const std::size_t middle = farthest(first, last, &least);
    if (least <= distance) return true;
    return splits > 0 && isReached(first, middle, distance, splits - 1) &&
           isReached(middle, last, distance, splits - 1);
}

/** The point between two that is farthest from the side that joins them. */
std::size_t SimplifiedArc::farthest(std::size_t first, std::size_t last, double* distance) const
{
    const std::vector<Vector2d>& chain = *m_chain;
    double most = -1;
    std::size_t best = first + 1;
    for (std::size_t k = first + 1; k < last; ++k)
        if (const double squared = squaredDistance(chain[k], chain[first], chain[last]); squared > most) {
            most = squared;
            best = k;
        }
    if (distance != nullptr) *distance = std::sqrt(std::max(most, 0.0));
    return best;
}

/** How far to the left a side has to move to have as much of the chain's area on either side [cells]. */
double SimplifiedArc::lean(std::size_t side) const
{
    const std::vector<Vector2d>& chain = *m_chain;
    const Vector2d &a = chain[m_chosen[side]], &b = chain[m_chosen[side + 1]];
    double twice = 0;
    for (std::size_t k = m_chosen[side] + 1; k < m_chosen[side + 1]; ++k)
        twice += cross(chain[k] - a, chain[k + 1] - a);
    const double length = (b - a).norm();
    if (twice == 0 || length == 0) return 0;
    const bool turns = !m_closed && (side == 0) != (side + 2 == m_chosen.size());  // about its fixed end
    return -twice / 2 / length * (turns ? 2 : 1);
}

/** Where the two sides of a vertex meet after each has moved, relative to where they met. */
Vector2d SimplifiedArc::shiftOf(std::size_t vertex, const std::vector<double>& leans) const
{
    const std::vector<Vector2d>& chain = *m_chain;
    const std::size_t last = m_chosen.size() - 1;
    const std::size_t before = vertex == 0 ? last - 1 : vertex - 1, side = vertex == last ? 0 : vertex;
    const Vector2d &a = chain[m_chosen[before]], &b = chain[m_chosen[vertex]], &c = chain[m_chosen[side + 1]];
    const Vector2d n = leftNormal(a, b), m = leftNormal(b, c);
    const double p = leans[before], q = leans[side], turn = cross(n, m);
    Vector2d shift(0, 0);
    if (std::abs(turn) > kStraight)
        shift = Vector2d(p * m.y() - q * n.y(), q * n.x() - p * m.x()) / turn;
    else if (n.dot(m) > 0) {
        const double f = (b - a).norm(), g = (c - b).norm();
        shift = (p * f + q * g) / (f + g) * (n + m).normalized();
    }
    const double length = shift.norm();
    return length > kMostShift_cells ? Vector2d(shift * (kMostShift_cells / length)) : shift;
}

void SimplifiedArc::place()
{
    const std::size_t last = m_chosen.size() - 1;
    std::vector<double> leans(last);
    for (std::size_t side = 0; side < last; ++side) leans[side] = lean(side);
    m_vertices.clear();
    for (std::size_t v = 0; v <= last; ++v) {
        m_vertices.push_back((*m_chain)[m_chosen[v]]);
        const bool fixed = m_pinned[m_chosen[v]] || (!m_closed && (v == 0 || v == last));
        if (!fixed) m_vertices.back() += shiftOf(v, leans);
    }
}
}  // namespace gr2to
