#include "gr2to/compare/GraphScores.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "compare/ratios.h"
#include "gr2to/compare/Assignment.h"

namespace gr2to
{
namespace
{
/** A door this near an annotated one is that door [m]. */
constexpr double kDoorRadius_m = 0.75;
/** Cost of pairing doors that are farther apart: more than any number of near pairs could save. */
constexpr double kTooFar = 1e6;

using Interfaces = std::vector<ReferenceInterface>;

double distance_m(const PredictedDoor& door, const ReferenceInterface& interface, double resolution_m)
{
    return (door.mid_px - interface.mid_px).norm() * resolution_m;
}

SparseCosts doorCosts(const std::vector<PredictedDoor>& doors, const Interfaces& annotated,
                      double resolution_m)
{
    SparseCosts costs{doors.size(), annotated.size(), kTooFar, {}};
    for (std::size_t p = 0; p < doors.size(); ++p)
        for (std::size_t a = 0; a < annotated.size(); ++a)
            if (const double d = distance_m(doors[p], annotated[a], resolution_m); d <= kDoorRadius_m)
                costs.entries.push_back({p, a, d});
    return costs;
}

/** Whether a door lies where the annotation has a passage of another kind. */
bool isAtAny(const Interfaces& others, const PredictedDoor& door, double resolution_m)
{
    return std::any_of(others.begin(), others.end(), [&](const auto& other) {
        return distance_m(door, other, resolution_m) <= std::max(kDoorRadius_m, other.width_m / 2);
    });
}
}  // namespace

PredictedGraph predictedGraph(const TopologicalMap& map, const GridFrame& frame, int height)
{
    PredictedGraph graph;
    for (const auto& connection : map.connections()) {
        graph.edges.emplace_back(connection.from, connection.to);
        const Doorway& doorway = connection.doorway;
        if (!doorway.real) continue;
        const Eigen::Vector2d cell = frame.toGrid(doorway.position.mean.x, doorway.position.mean.y);
        graph.doors.push_back({{cell.x(), height - 1 - cell.y()}, doorway.size.length_m});
    }
    return graph;
}

DoorScores doorScores(const std::vector<PredictedDoor>& doors, const Interfaces& interfaces,
                      double resolution_m)
{
    Interfaces annotated, others;
    for (const auto& i : interfaces) (i.kind == InterfaceKind::Door ? annotated : others).push_back(i);
    const SparseCosts costs = doorCosts(doors, annotated, resolution_m);
    const auto annotatedOf = assignRows(costs);
    std::vector<bool> found(doors.size(), false);
    std::size_t hits = 0, neutral = 0, widths = 0;
    double widthErrors = 0;
    for (const auto& near : costs.entries) {
        if (annotatedOf[near.row] != near.column) continue;
        found[near.row] = true;
        ++hits;
        if (doors[near.row].width_m == 0.0) continue;
        widthErrors += std::abs(doors[near.row].width_m - annotated[near.column].width_m);
        ++widths;
    }
    for (std::size_t p = 0; p < doors.size(); ++p)
        if (!found[p] && isAtAny(others, doors[p], resolution_m)) ++neutral;
    DoorScores scores;
    scores.precision = ratio(hits, doors.size());
    scores.recall = ratio(hits, annotated.size());
    scores.f1 = f1Of(scores.precision, scores.recall);
    scores.precisionLenient = ratio(hits, doors.size() - neutral);
    scores.annotated = static_cast<int>(annotated.size());
    scores.predicted = static_cast<int>(doors.size());
    if (widths > 0) scores.widthError_m = widthErrors / static_cast<double>(widths);
    return scores;
}

namespace
{
/** A room by its label, or a segment that overlaps no room by its negative id. */
using RoomName = int;
using NamePair = std::pair<RoomName, RoomName>;

/** For every place id the room that it stands for, 0 when the id does not occur. */
std::vector<RoomName> nameSegments(const ContingencyTable& table)
{
    const auto& segments = table.segments();
    std::vector<RoomName> names(segments.empty() ? 0 : segments.back().id + std::size_t{1}, 0);
    std::vector<std::size_t> best(segments.size(), 0);
    for (const auto& s : segments) names[s.id] = -RoomName{s.id};
    for (const auto& o : table.overlaps()) {
        if (o.cells <= best[o.segment]) continue;
        best[o.segment] = o.cells;
        names[segments[o.segment].id] = table.rooms()[o.room].id;
    }
    return names;
}

std::set<NamePair> pairsOf(const Interfaces& interfaces, bool slits)
{
    std::set<NamePair> pairs;
    for (const auto& i : interfaces)
        if ((i.kind == InterfaceKind::Slit) == slits) pairs.insert(std::minmax(RoomName{i.a}, RoomName{i.b}));
    return pairs;
}
}  // namespace

EdgeScores edgeScores(const std::vector<std::pair<PlaceId, PlaceId>>& edges, const Interfaces& interfaces,
                      const ContingencyTable& all)
{
    const auto names = nameSegments(all);
    const auto nameOf = [&](PlaceId id) { return id < names.size() ? names[id] : 0; };
    std::set<std::pair<PlaceId, PlaceId>> distinct;
    for (const auto& [a, b] : edges) distinct.insert(std::minmax(a, b));
    const auto real = pairsOf(interfaces, false);
    const auto slits = pairsOf(interfaces, true);
    std::set<NamePair> named;
    EdgeScores scores;
    for (const auto& [a, b] : distinct) {
        const NamePair pair = std::minmax({nameOf(a), nameOf(b)});
        if (nameOf(a) == 0 || nameOf(b) == 0) continue;
        if (pair.first == pair.second)
            ++scores.internal;
        else if (slits.count(pair) == 0 || real.count(pair) > 0)
            named.insert(pair);
    }
    const auto right = static_cast<std::size_t>(std::count_if(
        named.begin(), named.end(), [&](const NamePair& pair) { return real.count(pair) > 0; }));
    scores.precision = ratio(right, named.size());
    scores.recall = ratio(right, real.size());
    scores.f1 = f1Of(scores.precision, scores.recall);
    scores.annotated = static_cast<int>(real.size());
    scores.predicted = static_cast<int>(named.size());
    return scores;
}
}  // namespace gr2to
