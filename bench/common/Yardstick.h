#pragma once

#include <memory>

#include "gr2to/grid/ClassifiedGrid.h"

namespace gr2to::bench
{
/** OpenCV's exact distance transform of a grid's free cells, in one thread: what other costs are stated in.
 */
class Yardstick
{
 public:
    explicit Yardstick(const ClassifiedGrid& grid);
    ~Yardstick();
    Yardstick(const Yardstick&) = delete;
    Yardstick& operator=(const Yardstick&) = delete;

    /** One transform. */
    void run();
    /** Median CPU time of one transform [s]. */
    double seconds(int runs = 5);

 private:
    struct Images;
    std::unique_ptr<Images> m_images;
};
}  // namespace gr2to::bench
