#include "Command.h"

namespace gr2to::cli
{
Commands allCommands()
{
    Commands commands;
    commands.push_back(makeExtract());
    commands.push_back(makeInfo());
    commands.push_back(makeValidate());
    commands.push_back(makeCompare());
    commands.push_back(makeRender());
    commands.push_back(makeMan());
    commands.push_back(makeOptions());
    return commands;
}
}  // namespace gr2to::cli
