#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "gr2to/pipeline/Gr2To.h"
#include "support/buildingMeasures.h"

using namespace gr2to;
using namespace gr2to::test;

/** Whole maps against summaries in tests/golden, which
 *
 *     GR2TO_REGENERATE_GOLDEN=1 build/dev/tests/Golden_unittest
 *
 * writes anew. Words, ids and their order must agree; lengths and positions within 0.1 m, two cells, and
 * areas within 0.2 m2.
 */
namespace
{
constexpr double kLength_m = 0.1;
constexpr double kArea_m2 = 0.2;

struct Case
{
    const char* name;
    const char* layout;
    const char* preset;
    double rotation_deg;
    double furniture;
    int seed;
};

const Case kCases[] = {{"straight", "straight", "default", 0, 0, 21},
                       {"turned", "l", "default", 23, 0, 22},
                       {"furnished", "t", "default", 0, 0.12, 23},
                       {"paper", "straight", "paper", 0, 0, 24}};

Extraction extract(const Case& c)
{
    auto options = buildingOptions(c.seed, c.rotation_deg, c.furniture);
    options.layout = c.layout;
    options.width = 18;
    options.height = 14;
    return Gr2To(Gr2ToOptions::preset(c.preset)).extract(generateBuilding(options).grid);
}

/** One line a place, then one a connection. */
std::string summaryOf(const TopologicalMap& map)
{
    std::ostringstream out;
    out.precision(3);
    out << std::fixed;
    for (const auto& [id, place] : map.places()) {
        out << "place " << id << (place.kind == PlaceKind::Corridor ? " corridor" : " room") << " area "
            << place.area_m2 << " centre " << place.center.x << " " << place.center.y << "\n";
    }
    for (const Connection& c : map.connections())
        out << "connection " << c.id << " " << c.from << " " << c.to
            << (c.doorway.real ? " door" : " opening") << " width " << c.doorway.size.length_m << " at "
            << c.doorway.position.mean.x << " " << c.doorway.position.mean.y << "\n";
    return out.str();
}

std::filesystem::path fileOf(const Case& c)
{
    return std::filesystem::path(GR2TO_SOURCE_DIR) / "tests/golden" / (std::string(c.name) + ".txt");
}

std::vector<std::string> wordsOf(const std::string& line)
{
    std::istringstream in(line);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

void expectSameLine(const std::string& expected, const std::string& found)
{
    const auto a = wordsOf(expected), b = wordsOf(found);
    ASSERT_EQ(a.size(), b.size()) << expected << "\nagainst\n" << found;
    double tolerance = kLength_m;
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (a[k] == "area" || a[k] == "centre") tolerance = a[k] == "area" ? kArea_m2 : kLength_m;
        if (a[k].find('.') == std::string::npos)
            EXPECT_EQ(a[k], b[k]) << expected << "\nagainst\n" << found;
        else
            EXPECT_NEAR(std::stod(a[k]), std::stod(b[k]), tolerance) << expected << "\nagainst\n" << found;
    }
}
}  // namespace

TEST(Golden, mapsAreAsTheyWere)
{
    for (const Case& c : kCases) {
        SCOPED_TRACE(c.name);
        const std::string summary = summaryOf(extract(c).map);
        if (std::getenv("GR2TO_REGENERATE_GOLDEN") != nullptr) {
            std::ofstream(fileOf(c)) << summary;
            continue;
        }
        std::ifstream golden(fileOf(c));
        ASSERT_TRUE(golden) << fileOf(c) << " is missing";
        std::istringstream found(summary);
        std::string expectedLine, foundLine;
        while (std::getline(golden, expectedLine)) {
            ASSERT_TRUE(std::getline(found, foundLine)) << "nothing instead of: " << expectedLine;
            expectSameLine(expectedLine, foundLine);
        }
        EXPECT_FALSE(std::getline(found, foundLine)) << "one more: " << foundLine;
    }
}
