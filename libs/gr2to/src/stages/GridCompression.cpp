#include "gr2to/stages/GridCompression.h"

#include <algorithm>
#include <cmath>

#include "base/vectorised.h"
#include "gr2to/base/errors.h"
#include "gr2to/base/text.h"
#include "gr2to/grid/HeightHistogram.h"
#include "gr2to/grid/VoxelColumns.h"
#include "stages/octreeLeaves.h"

namespace gr2to
{
namespace
{
constexpr double kAirOverFurniture_m = 0.3;  // less may be a ray that grazed the top of a wall
constexpr double kAirUnderLintel_m = 0.5;

/** A height in voxels; a hair off a whole number is that number, so that 0.15 m are three voxels of 0.05 m.
 */
double voxelsIn(double height_m, double voxel_m)
{
    const double voxels = height_m / voxel_m, whole = std::round(voxels);
    return std::abs(voxels - whole) < 1e-6 ? whole : voxels;
}

/** The layers that are compressed, and the floor. */
struct Layers
{
    int first = 0;
    int last = 0;  //!< after the highest
    int floor = 0;
    CompressedRange range;
};

/** Finds the layers from options and data. */
class LayerChooser
{
 public:
    LayerChooser(const VoxelBoxes& voxels, const VoxelBounds& bounds, const TCompressionOptions& options)
        : m_voxels(voxels), m_bounds(bounds), m_options(options)
    {
    }

    Layers choose() const
    {
        if (m_bounds.lastZ == 0)
            throw InputError(
                "the octree has no voxel that is free (probability at most compression.p_max = " +
                numberText(m_options.p_max) + ") or occupied (at least compression.p_min = " +
                numberText(m_options.p_min) + "); check that it is the right file");
        requireInside(m_options.z_min, "z_min");
        requireInside(m_options.z_max, "z_max");
        const HeightHistogram histogram = heightHistogram(m_voxels, m_bounds);
        const RoomHeight room = findRoomHeight(histogram, m_voxels.resolution_m);
        Layers layers;
        layers.first = m_options.z_min ? layerFrom(*m_options.z_min) : room.floor.value_or(lowest(histogram));
        layers.last =
            m_options.z_max ? layerFrom(*m_options.z_max) : room.ceiling.value_or(highest(histogram) + 1);
        layers.first = std::max(layers.first, m_bounds.firstZ);
        layers.last = std::min(layers.last, m_bounds.lastZ);
        layers.range = {m_voxels.lowerSide_m(layers.first), m_voxels.lowerSide_m(layers.last),
                        room.floor && *room.floor <= layers.last, !m_options.z_max && room.ceiling};
        layers.floor = layers.range.floorFound ? *room.floor : layers.first;
        if (layers.first >= layers.last)
            throw InputError("no voxel's centre lies between z_min = " +
                             numberText(m_options.z_min.value_or(layers.range.z_min_m)) +
                             " m and z_max = " + numberText(m_options.z_max.value_or(layers.range.z_max_m)) +
                             " m; give compression.z_min and compression.z_max farther apart");
        return layers;
    }

 private:
    void requireInside(const std::optional<double>& z, const std::string& name) const
    {
        const double low = m_voxels.lowerSide_m(m_bounds.firstZ), high = m_voxels.lowerSide_m(m_bounds.lastZ);
        const bool outside = z && (name == "z_min" ? *z >= high : *z <= low);
        if (outside)
            throw InputError("compression." + name + " = " + numberText(*z) +
                             " m lies outside of the octree, which reaches from z = " + numberText(low) +
                             " m to " + numberText(high) +
                             " m; give a height within it, or none to have floor and ceiling found");
    }
    /** The lowest layer whose centre is at a height or above it. */
    int layerFrom(double z_m) const
    {
        const double layer = std::ceil(z_m / m_voxels.resolution_m - 0.5 - 1e-6);
        return VoxelBoxes::kOrigin + static_cast<int>(std::clamp(layer, -32768.0, 32767.0));
    }
    static int lowest(const HeightHistogram& h)
    {
        const auto at = std::find_if(h.occupied.begin(), h.occupied.end(), [](auto n) { return n > 0; });
        return h.firstLayer + static_cast<int>(at - h.occupied.begin());
    }
    static int highest(const HeightHistogram& h)
    {
        const auto at = std::find_if(h.occupied.rbegin(), h.occupied.rend(), [](auto n) { return n > 0; });
        return h.firstLayer + static_cast<int>(h.occupied.rend() - at) - 1;
    }

    const VoxelBoxes& m_voxels;
    const VoxelBounds& m_bounds;
    const TCompressionOptions& m_options;
};

/** Eq. (7), the filter and the heights, on the columns between z_min and z_max. */
class Compression
{
 public:
    Compression(const VoxelColumns& columns, const Layers& layers, const TCompressionOptions& options,
                double voxel_m, CompressedGrid& result)
        : m_columns(columns),
          m_layers(layers),
          m_options(options),
          m_voxel_m(voxel_m),
          m_noMin(voxelsIn(options.no_min, voxel_m)),
          m_nfMax(voxelsIn(options.nf_max, voxel_m)),
          m_air(voxelsIn(kAirOverFurniture_m, voxel_m)),
          m_floor(layers.floor - layers.first),
          m_tallest(std::max(0, m_floor + static_cast<int>(voxelsIn(options.furniture_height, voxel_m)))),
          m_head(m_floor + static_cast<int>(std::ceil(voxelsIn(options.headroom, voxel_m)))),
          m_result(result)
    {
    }

    void compress()
    {
        compressAll();
        if (m_free == 0) complain("nf_max", m_options.nf_max, "free", m_mostFree);
        if (m_occupied == 0) complain("no_min", m_options.no_min, "occupied", m_mostOccupied);
    }

 private:
    GR2TO_VECTORISED void compressAll()
    {
        for (std::size_t i = 0; i < m_columns.size(); ++i)
            if (!m_columns.isUnknown(i)) compress(i);
    }

    [[gnu::always_inline]] void compress(std::size_t i)
    {
        const int no = m_columns.countOccupied(i), nf = m_columns.countFree(i);
        m_mostOccupied = std::max(m_mostOccupied, no);
        m_mostFree = std::max(m_mostFree, nf);
        CellState state = equation7(no, nf);
        m_free += state == CellState::Free ? 1 : 0;
        if (state != CellState::Free && carriesNothing(i)) {
            state = CellState::Free;
            ++m_result.furnitureCells;
        }
        m_result.grid[i] = state;
        if (state == CellState::Occupied) {
            ++m_occupied;
            m_result.heights.setTop(i, wallTop(i) - m_floor);
        } else if (state == CellState::Free && no > 0)
            m_result.heights.setLintel(i, lintelBottom(i) - m_floor);
    }

    CellState equation7(int no, int nf) const
    {
        if (no > m_noMin && nf < m_nfMax) return CellState::Occupied;
        return nf > m_nfMax ? CellState::Free : CellState::Unknown;
    }

    /** The filter: nothing is occupied above furniture's height, and the air there was seen. */
    bool carriesNothing(std::size_t i) const
    {
        return m_options.furniture_height > 0 && m_columns.highestOccupied(i) < m_tallest &&
               m_columns.countFree(i, m_tallest, m_columns.layers()) >= m_air;
    }

    [[noreturn]] void complain(const std::string& option, double value, const std::string& state,
                               int most) const
    {
        throw InputError("compression." + option + " = " + numberText(value) + " m leaves no " + state +
                         " cell: the column with most has " + numberText(most * m_voxel_m) + " m of " +
                         state + " voxels between z = " + numberText(m_layers.range.z_min_m) + " m and " +
                         numberText(m_layers.range.z_max_m) + " m; lower it");
    }

    /** The layer above the highest occupied one; where the range was cut off by an option nobody knows how
     * far a wall goes on: the floor's layer then, no height. */
    int wallTop(std::size_t i) const
    {
        const int top = m_columns.highestOccupied(i) + 1;
        const bool cutOff = top == m_columns.layers() && m_options.z_max;
        return cutOff ? m_floor : top;
    }

    /** The lowest occupied layer over the headroom, with free air right below. */
    int lintelBottom(std::size_t i) const
    {
        const int bottom = m_columns.lowestOccupied(i, m_head);
        if (bottom < 0) return m_floor;
        const int air = std::max(1, static_cast<int>(std::lround(kAirUnderLintel_m / m_voxel_m)));
        return 2 * m_columns.countFree(i, bottom - air, bottom) >= air ? bottom : m_floor;
    }

    const VoxelColumns& m_columns;
    const Layers& m_layers;
    const TCompressionOptions& m_options;
    double m_voxel_m;
    double m_noMin, m_nfMax, m_air;  //!< [voxels]
    int m_floor, m_tallest,
        m_head;  //!< layers: of the floor, of the lowest over furniture, of the lowest lintel
    CompressedGrid& m_result;
    int m_mostOccupied = 0, m_mostFree = 0;  //!< voxels of a column
    std::size_t m_occupied = 0, m_free = 0;  //!< cells, free ones without furniture
};
}  // namespace

std::vector<OptionField> TCompressionOptions::fields()
{
    return {
        {"z_min", &z_min, "m",
         "Height from which voxels count, z_min of eq. (7); auto: above the floor found in the data."},
        {"z_max", &z_max, "m",
         "Height up to which voxels count, z_max of eq. (7); auto: below the ceiling found in the data."},
        {"nf_max", &nf_max, "m",
         "A column with free voxels of more than this height in all is free, NF_max of eq. (7); an occupied "
         "one has "
         "less.",
         0, 100},
        {"no_min", &no_min, "m",
         "An occupied column has occupied voxels of more than this height in all, NO_min of eq. (7).", 0,
         100},
        {"p_max", &p_max, "ratio",
         "A voxel is free when its occupancy probability is at most this, P_Max of eq. (7).", 0, 1},
        {"p_min", &p_min, "ratio",
         "A voxel is occupied when its occupancy probability is at least this, P_Min of eq. (7).", 0, 1},
        {"furniture_height", &furniture_height, "m",
         "Things that end below this height above the floor, with air over them, are removed; 0 keeps all.",
         0, 10},
        {"headroom", &headroom, "m",
         "What hangs higher than this above the floor over free space can be a lintel.", 0.5, 10}};
}

void TCompressionOptions::checkRules() const
{
    if (z_min && z_max && *z_min >= *z_max)
        throw std::invalid_argument("compression.z_max = " + numberText(*z_max) +
                                    " m must exceed compression.z_min = " + numberText(*z_min) + " m");
    if (p_max >= p_min)
        throw std::invalid_argument("compression.p_min = " + numberText(p_min) +
                                    " must exceed compression.p_max = " + numberText(p_max));
}

VoxelBoxes voxelsOf(const octomap::OcTree& tree, double p_max, double p_min)
{
    return leavesOf(tree, p_max, p_min);
}

GridCompressor::GridCompressor(TCompressionOptions options) : m_options(std::move(options))
{
    m_options.check();
}

CompressedGrid GridCompressor::compress(const octomap::OcTree& tree) const
{
    return compress(voxelsOf(tree, m_options.p_max, m_options.p_min));
}

CompressedGrid GridCompressor::compress(const VoxelBoxes& voxels) const
{
    VoxelBounds bounds = boundsOf(voxels);
    const Layers layers = LayerChooser(voxels, bounds, m_options).choose();
    bounds.firstZ = layers.first;
    bounds.lastZ = layers.last;
    const VoxelColumns columns(voxels, bounds);
    CompressedGrid result;
    GridFrame frame{voxels.resolution_m, voxels.lowerSide_m(bounds.firstX), voxels.lowerSide_m(bounds.firstY),
                    0};
    result.grid = ClassifiedGrid(columns.width(), columns.height(), frame);
    result.range = layers.range;
    result.leaves = voxels.count();
    result.layers = static_cast<std::size_t>(columns.layers());
    result.heights = HeightMap(columns.width(), columns.height(), voxels.resolution_m);
    result.heights.floor_m = voxels.lowerSide_m(layers.floor);
    Compression(columns, layers, m_options, voxels.resolution_m, result).compress();
    return result;
}
}  // namespace gr2to
