#include "gr2to/topology/TopologicalMap.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace gr2to
{
namespace
{
template <class Predicate>
std::vector<Connection> connectionsThat(const TopologicalMap::Graph& graph, Predicate accept)
{
    std::vector<Connection> result;
    for (const auto& [ends, connection] : graph.edges)
        if (accept(connection)) result.push_back(connection);
    std::stable_sort(result.begin(), result.end(),
                     [](const Connection& a, const Connection& b) { return a.id < b.id; });
    return result;
}
}  // namespace

void TopologicalMap::addPlace(Place place)
{
    const PlaceId id = place.id;
    if (id == 0) throw std::invalid_argument("a place has id 0; ids start at 1");
    const bool fresh = m_places.emplace(id, std::move(place)).second;
    if (!fresh)
        throw std::invalid_argument("place " + std::to_string(id) + ": the id is taken; ids must be unique");
}

void TopologicalMap::addConnection(Connection connection)
{
    if (connection.id == 0) throw std::invalid_argument("a connection has id 0; ids start at 1");
    const std::string name = "connection " + std::to_string(connection.id);
    for (const PlaceId end : {connection.from, connection.to})
        if (m_places.count(end) == 0)
            throw std::invalid_argument(name + ": there is no place " + std::to_string(end) +
                                        "; add places before the connections that touch them");
    if (connection.from == connection.to)
        throw std::invalid_argument(name + ": both its ends are place " + std::to_string(connection.from) +
                                    "; a connection joins two different places");
    if (!m_connectionIds.insert(connection.id).second)
        throw std::invalid_argument(name + ": the id is taken; ids must be unique");
    if (connection.from > connection.to) std::swap(connection.from, connection.to);
    m_graph.insertEdge(connection.from, connection.to, connection);
}

std::vector<Connection> TopologicalMap::connections() const
{
    return connectionsThat(m_graph, [](const Connection&) { return true; });
}

std::vector<Connection> TopologicalMap::connectionsOf(PlaceId id) const
{
    return connectionsThat(m_graph, [id](const Connection& c) { return c.from == id || c.to == id; });
}

bool operator==(const TopologicalMap& a, const TopologicalMap& b)
{
    return a.frame == b.frame && a.resolution_m == b.resolution_m && a.source == b.source &&
           a.m_places == b.m_places && a.connections() == b.connections();
}
}  // namespace gr2to
