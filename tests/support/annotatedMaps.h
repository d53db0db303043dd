#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gr2to::test
{
/** A grid image of the evaluation data. */
struct AnnotatedMap
{
    std::filesystem::path image;
    double resolution_m = 0.05;
};

/** The grid images of one folder of the evaluation data, by name; none when the data is absent. */
std::vector<AnnotatedMap> annotatedMaps(const std::string& folder);
}  // namespace gr2to::test
