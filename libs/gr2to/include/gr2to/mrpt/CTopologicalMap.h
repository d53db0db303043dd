#pragma once

#include <mrpt/serialization/CSerializable.h>

#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
/** The augmented topological map as a class that MRPT's archives can store and load, with every attribute.
 *
 * Its registered name is `gr2to::CTopologicalMap`; an application that loads archives calls
 * registerAllClasses() once.
 */
class CTopologicalMap : public mrpt::serialization::CSerializable
{
    DEFINE_SERIALIZABLE(CTopologicalMap, gr2to)

 public:
    CTopologicalMap() = default;
    explicit CTopologicalMap(TopologicalMap m) : map(std::move(m)) {}

    TopologicalMap map;
};
}  // namespace gr2to
