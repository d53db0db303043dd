#include "support/annotatedMaps.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace gr2to::test
{
namespace fs = std::filesystem;

namespace
{
bool endsWith(const std::string& name, const std::string& end)
{
    return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

/** The resolution that the annotation beside an image states; 0.05 m where there is none. */
double resolutionOf(const fs::path& image)
{
    const std::string name = image.filename().string();
    std::ifstream file(image.parent_path() / (name.substr(0, name.find('.')) + ".gt.json"));
    if (!file) return 0.05;
    return nlohmann::json::parse(file).value("resolution_m", 0.05);
}
}  // namespace

std::vector<AnnotatedMap> annotatedMaps(const std::string& folder)
{
    const fs::path root = fs::path(GR2TO_EVALUATION_DATA) / folder;
    std::vector<AnnotatedMap> maps;
    if (!fs::is_directory(root)) return maps;
    for (const auto& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        const bool isGrid =
            endsWith(name, ".pgm") || (endsWith(name, ".png") && !endsWith(name, "gt_labels.png"));
        if (isGrid) maps.push_back({entry.path(), resolutionOf(entry.path())});
    }
    std::sort(maps.begin(), maps.end(),
              [](const AnnotatedMap& a, const AnnotatedMap& b) { return a.image < b.image; });
    return maps;
}
}  // namespace gr2to::test
