#include <mrpt/rtti/CObject.h>

#include "gr2to/mrpt/registerAllClasses.h"

/** Returns 0 when MRPT's registry knows the map's class. */
int main()
{
#ifdef GR2TO_NAME_A_SYMBOL
    gr2to::registerAllClasses();
#endif
    return mrpt::rtti::findRegisteredClass("gr2to::CTopologicalMap") != nullptr ? 0 : 1;
}
