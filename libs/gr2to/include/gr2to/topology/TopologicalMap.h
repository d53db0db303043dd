#pragma once

#include <mrpt/graphs/CDirectedGraph.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "gr2to/topology/types.h"

namespace gr2to
{
/** The augmented topological map M_t = (P, C), eq. (1): places joined by connections with doorways.
 *
 * The edges live in an mrpt::graphs::CDirectedGraph, so MRPT's graph algorithms run on them; parallel
 * connections (two doors between the same rooms) and isolated places are kept. A connection is stored once,
 * from the smaller place id to the larger, and stands for both directions.
 */
class TopologicalMap
{
 public:
    using Graph = mrpt::graphs::CDirectedGraph<Connection>;

    std::string frame = "map";  //!< name of the frame that every position is expressed in
    double resolution_m = 0.0;  //!< side of a cell of the grid that the map was made from [m]
    std::string source;         //!< file name of that grid

    /** Adds a place. \throws std::invalid_argument  its id is 0 or taken */
    void addPlace(Place place);
    /** Adds a connection; swaps `from` and `to` into order.
     * \throws std::invalid_argument  its id is 0 or taken, a place does not exist, or both are the same
     */
    void addConnection(Connection connection);

    const std::map<PlaceId, Place>& places() const { return m_places; }
    /** \throws std::out_of_range  no such place */
    const Place& place(PlaceId id) const { return m_places.at(id); }
    Place& place(PlaceId id) { return m_places.at(id); }
    /** Connections in the order of their ids. */
    std::vector<Connection> connections() const;
    /** Connections that touch a place, in the order of their ids. */
    std::vector<Connection> connectionsOf(PlaceId id) const;
    const Graph& graph() const { return m_graph; }

    /** Everything that is wrong with the map, one line each; empty when the model's invariants hold.
     *
     * Places: ids from 1, a known kind, finite centre and area > 0, boundary of no or at least three finite
     * vertices whose sides do not cross; walls with unique ids from 1, unit normals, lengths > 0, finite
     * curvatures; connections with unique ids from 1 between two different existing places, the smaller id
     * first, a known door state, width > 0. Heights, where present, > 0. Views with an image, apertures
     * within [0, 2 pi], a finite time. Words non-empty UTF-8 without control characters. Every position
     * finite; every covariance finite, exactly symmetric and positive semi-definite, zero for an absent
     * height. Resolution positive and finite, a frame named, and frame, source and image names UTF-8.
     */
    std::vector<std::string> validate() const;

    friend bool operator==(const TopologicalMap& a, const TopologicalMap& b);

 private:
    std::map<PlaceId, Place> m_places;
    Graph m_graph;
    std::set<std::uint32_t> m_connectionIds;  //!< of the graph's edges, to refuse a taken id quickly
};
}  // namespace gr2to
