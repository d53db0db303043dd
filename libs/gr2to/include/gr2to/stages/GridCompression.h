#pragma once

#include <optional>

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/ClassifiedGrid.h"
#include "gr2to/grid/HeightMap.h"
#include "gr2to/grid/VoxelBoxes.h"

namespace octomap
{
class OcTree;
}

namespace gr2to
{
/** The six parameters of eq. (7), and those of the filter that follows it; section `compression`.
 *
 * The paper counts voxels; here its two counts are heights, so that an octree of another resolution needs no
 * other values: NO > NO_min is NO * voxel > no_min.
 */
struct TCompressionOptions : OptionTable
{
    std::optional<double> z_min;    //!< z_min
    std::optional<double> z_max;    //!< z_max
    double nf_max = 0.8;            //!< NF_max
    double no_min = 0;              //!< NO_min
    double p_max = 0.45;            //!< P_Max
    double p_min = 0.55;            //!< P_Min
    double furniture_height = 1.8;  //!< 0: no filter
    double headroom = 1.8;

    std::string section() const override { return "compression"; }
    std::vector<OptionField> fields() override;

 protected:
    void checkRules() const override;
};

/** The heights between which a 3D map was compressed [m], map frame, and where they come from. */
struct CompressedRange
{
    double z_min_m = 0;
    double z_max_m = 0;
    bool floorFound =
        false;  //!< a floor was found in the data, and heights are measured from it; else from z_min
    bool ceilingFound = false;  //!< z_max is where a ceiling was found in the data
};

/** What the first stage makes of a 3D map. */
struct CompressedGrid
{
    ClassifiedGrid grid;
    HeightMap heights;
    CompressedRange range;
    std::size_t leaves = 0;          //!< of the octree that are free or occupied
    std::size_t layers = 0;          //!< of voxels between z_min and z_max
    std::size_t furnitureCells = 0;  //!< cells that the filter made free
};

/** The voxels of an octree that are free (probability at most `p_max`) or occupied (at least `p_min`). Cost:
 * one visit of the leaves. */
VoxelBoxes voxelsOf(const octomap::OcTree& tree, double p_max, double p_min);

/** First stage on 3D input: compresses all voxels over a cell into that cell, eq. (7), and takes furniture
 * out.
 *
 * With NO the number of voxels of a column between z_min and z_max whose occupancy probability is at least
 * P_Min, and NF the number of those at most P_Max, a cell is occupied when NO > NO_min and NF < NF_max, free
 * when NF > NF_max, else unknown. A leaf of the octree above the lowest level counts as all voxels that it
 * covers, in every column that it covers. z_min and z_max that are not given are floor and ceiling, see
 * findRoomHeight(), and the lowest and highest occupied voxel where there is none.
 *
 * Furniture (by height and support): a column that eq. (7) does not make free becomes free when nothing in it
 * is occupied from `furniture_height` above the floor upwards and at least 0.3 m of voxels there are free:
 * it carries no ceiling, whatever stands in it ends below, and so it bounds no place. What hangs over free
 * voxels is no obstacle by eq. (7) itself.
 *
 * Source: Gr2To paper, section 4, first stage.
 */
class GridCompressor
{
 public:
    /** \throws std::invalid_argument  an option is out of range */
    explicit GridCompressor(TCompressionOptions options);

    /** \throws InputError  the tree is empty, the z range lies outside of it, or NO_min or NF_max leave no
     * occupied or no free cell. Cost: one visit of the leaves, linear in the voxels' columns.
     */
    CompressedGrid compress(const octomap::OcTree& tree) const;
    /** The same of voxels that were read otherwise. */
    CompressedGrid compress(const VoxelBoxes& voxels) const;

 private:
    TCompressionOptions m_options;
};
}  // namespace gr2to
