#include "gr2to/topology/PlaceOutlines.h"

#include <algorithm>
#include <cmath>

#include "gr2to/grid/SegmentConflicts.h"
#include "gr2to/grid/SimplifiedArc.h"
#include "gr2to/topology/HoleSlits.h"

namespace gr2to
{
namespace
{
using Eigen::Vector2d;

constexpr double kMargin_cells = 0.1;  // between sides that do not meet; borders are a third of a cell apart
constexpr double kAreaError = 0.01;    // of an outline, as much as half the error that its place may see
constexpr int kMostSlitRounds = 16;    // a slit that ends at a hole takes another round
constexpr int kMostTightenings = 8;    // to a thousandth of a cell

/** Simplifies the arcs around places, each once, and puts them together. */
class OutlineAssembler
{
 public:
    OutlineAssembler(const LabelArcs& arcs, std::size_t count, double tolerance_cells)
        : m_arcs(arcs), m_numberOf(arcs.arcs.size(), kUnused)
    {
        for (const std::size_t r : mainRings(arcs, count)) {
            m_rings.push_back(r < arcs.rings.size() ? &arcs.rings[r] : nullptr);
            if (m_rings.back() == nullptr) continue;
            for (const HalfArc& side : m_rings.back()->sides)
                if (std::size_t& number = m_numberOf[side.arc]; number == kUnused) {
                    number = m_simple.size();
                    m_used.push_back(side.arc);
                    const LabelArc& arc = arcs.arcs[side.arc];
                    m_simple.emplace_back(arc.points, arc.isClosed(), tolerance_cells);
                }
        }
    }

    std::vector<std::vector<Vector2d>> assemble()
    {
        part();
        for (int k = 0; k < kMostTightenings && tighten(); ++k) part();
        std::vector<std::vector<Vector2d>> outlines;
        for (const LabelRing* ring : m_rings)
            outlines.push_back(ring ? polygonOf(*ring) : std::vector<Vector2d>());
        return outlines;
    }

 private:
    static constexpr std::size_t kUnused = static_cast<std::size_t>(-1);

    /** All sides; the vertices between arcs are the nodes, all others are numbered after them. */
    std::vector<Segment> segments() const
    {
        std::vector<Segment> all;
        std::size_t number = m_arcs.nodes.size();
        for (std::size_t k = 0; k < m_simple.size(); ++k) {
            const LabelArc& arc = m_arcs.arcs[m_used[k]];
            const std::vector<Vector2d>& vertices = m_simple[k].vertices();
            const std::size_t start = arc.isClosed() ? number++ : static_cast<std::size_t>(arc.from);
            const std::size_t end = arc.isClosed() ? start : static_cast<std::size_t>(arc.to);
            std::size_t last = start;
            for (std::size_t v = 1; v < vertices.size(); ++v) {
                const std::size_t next = v + 1 < vertices.size() ? number++ : end;
                all.push_back({vertices[v - 1], vertices[v], last, next});
                last = next;
            }
        }
        return all;
    }

    /** Brings sides that cross or touch others closer to their borders, which do neither. */
    void part()
    {
        for (bool again = true; again;) {
            const std::vector<bool> conflicts = findConflicts(segments(), kMargin_cells);
            again = false;
            std::size_t number = 0;
            for (SimplifiedArc& arc : m_simple) {
                bool changed = false;
                for (std::size_t side = 0; side < arc.sides(); ++side)
                    if (conflicts[number++]) {
                        arc.refine(side);
                        changed = true;
                    }
                if (changed) arc.update();
                again = again || changed;
            }
        }
    }

    /** Brings the outlines closer to their borders whose area is too far off; whether there are any. */
    bool tighten()
    {
        std::vector<bool> tight(m_simple.size(), false);
        for (const LabelRing* ring : m_rings) {
            if (ring == nullptr) continue;
            double area = 0;
            for (const HalfArc& side : ring->sides)
                area += (side.reversed ? -1 : 1) * areaBeside(m_simple[m_numberOf[side.arc]].vertices());
            if (std::abs(area - ring->area_cells) <= kAreaError * ring->area_cells) continue;
            for (const HalfArc& side : ring->sides) tight[m_numberOf[side.arc]] = true;
        }
        for (std::size_t k = 0; k < tight.size(); ++k)
            if (tight[k]) {
                m_simple[k].tighten();
                m_simple[k].update();
            }
        return std::find(tight.begin(), tight.end(), true) != tight.end();
    }

    std::vector<Vector2d> polygonOf(const LabelRing& ring) const
    {
        std::vector<Vector2d> polygon;
        for (const HalfArc& side : ring.sides) {
            const std::vector<Vector2d>& vertices = m_simple[m_numberOf[side.arc]].vertices();
            if (side.reversed)
                polygon.insert(polygon.end(), vertices.rbegin(), vertices.rend() - 1);
            else
                polygon.insert(polygon.end(), vertices.begin(), vertices.end() - 1);
        }
        return polygon;
    }

    const LabelArcs& m_arcs;
    std::vector<const LabelRing*> m_rings;  //!< of each label its largest; null for none
    std::vector<std::size_t> m_numberOf;    //!< of each arc in m_simple
    std::vector<std::size_t> m_used;        //!< the arcs of m_simple
    std::vector<SimplifiedArc> m_simple;
};
}  // namespace

std::vector<std::vector<Vector2d>> outlinePlaces(const PlaceImage& places, std::size_t count,
                                                 double tolerance_cells)
{
    LabelArcs arcs = traceArcs(places);
    PlaceImage slit;  // made when there is one
    for (int k = 0; k < kMostSlitRounds; ++k) {
        const std::vector<Cell> cells = findSlits(arcs, count, k == 0 ? places : slit);
        if (cells.empty()) break;
        if (k == 0) slit = places;
        for (const Cell c : cells) slit.ids[slit.index(c)] = 0;
        arcs = traceArcs(slit);
    }
    return OutlineAssembler(arcs, count, tolerance_cells).assemble();
}
}  // namespace gr2to
