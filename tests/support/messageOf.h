#pragma once

#include <gtest/gtest.h>

#include <string>

namespace gr2to::test
{
/** The message of the exception of the given type that the action throws; a failure when it throws none. */
template <class Exception, class Action>
std::string messageOf(Action action)
{
    try {
        action();
    } catch (const Exception& e) {
        return e.what();
    }
    ADD_FAILURE() << "no exception";
    return "";
}
}  // namespace gr2to::test
