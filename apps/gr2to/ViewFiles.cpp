#include "ViewFiles.h"

#include <cmath>

namespace gr2to::cli
{
namespace
{
PlaceId placeAt(const Extraction& extraction, const mrpt::math::TPoint3D& point)
{
    const auto there = extraction.grid.frame().toGrid(point.x, point.y);
    const Cell cell{static_cast<int>(std::lround(there.x())), static_cast<int>(std::lround(there.y()))};
    return extraction.grid.contains(cell) ? extraction.places.at(cell) : PlaceId{0};
}
}  // namespace

std::vector<std::pair<std::string, std::string>> addViews(Extraction& extraction,
                                                          std::vector<CapturedView> views)
{
    std::vector<std::pair<std::string, std::string>> files;
    for (CapturedView& captured : views) {
        const PlaceId id = placeAt(extraction, captured.view.position.mean);
        if (id == 0) continue;
        auto& ofPlace = extraction.map.place(id).views;
        captured.view.image =
            "views/" + std::to_string(id) + "_" + std::to_string(ofPlace.size()) + captured.ending;
        files.emplace_back(captured.view.image, std::move(captured.bytes));
        ofPlace.push_back(captured.view);
    }
    return files;
}
}  // namespace gr2to::cli
