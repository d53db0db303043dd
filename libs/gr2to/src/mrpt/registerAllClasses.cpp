#include "gr2to/mrpt/registerAllClasses.h"

#include <mrpt/core/initializer.h>

#include "gr2to/mrpt/CTopologicalMap.h"

MRPT_INITIALIZER(registerClassesOfGr2To)
{
    gr2to::registerAllClasses();
}

namespace gr2to
{
void registerAllClasses()
{
    mrpt::rtti::registerClass(CLASS_ID(CTopologicalMap));
}
}  // namespace gr2to
