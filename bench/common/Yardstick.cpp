#include "common/Yardstick.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "common/measure.h"

namespace gr2to::bench
{
struct Yardstick::Images
{
    cv::Mat obstacles;  //!< 0 on obstacles, 255 on free cells
    cv::Mat distances;
};

Yardstick::Yardstick(const ClassifiedGrid& grid) : m_images(std::make_unique<Images>())
{
    cv::setNumThreads(1);
    m_images->obstacles.create(grid.height(), grid.width(), CV_8U);
    for (int y = 0; y < grid.height(); ++y) {
        const CellState* cells = grid.row(y);
        auto* pixels = m_images->obstacles.ptr<std::uint8_t>(y);
        for (int x = 0; x < grid.width(); ++x) pixels[x] = cells[x] == CellState::Free ? 255 : 0;
    }
}

Yardstick::~Yardstick() = default;

void Yardstick::run()
{
    cv::distanceTransform(m_images->obstacles, m_images->distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
}

double Yardstick::seconds(int runs)
{
    std::vector<double> each;
    each.reserve(static_cast<std::size_t>(runs));
    for (int i = 0; i < runs; ++i) each.push_back(cpuSecondsOf([this] { run(); }));
    return median(std::move(each));
}
}  // namespace gr2to::bench
