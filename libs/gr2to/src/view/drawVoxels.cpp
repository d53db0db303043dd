#include <mrpt/opengl/COctoMapVoxels.h>

#include <algorithm>

#include "gr2to/base/errors.h"
#include "gr2to/grid/HeightHistogram.h"
#include "gr2to/view/Scene3D.h"

namespace gr2to
{
namespace
{
constexpr double kDarkest = 80, kLightest = 215;  // grey levels of the lowest and the highest layer
constexpr std::uint8_t kOpacity = 255;

/** The layers between floor and ceiling, as far as these are found. */
VoxelBounds roomOf(const VoxelBoxes& voxels)
{
    VoxelBounds bounds = boundsOf(voxels);
    if (bounds.lastZ == 0) return bounds;
    const RoomHeight room = findRoomHeight(heightHistogram(voxels, bounds), voxels.resolution_m);
    bounds.firstZ = room.floor.value_or(bounds.firstZ);
    bounds.lastZ = room.ceiling.value_or(bounds.lastZ);
    return bounds;
}

/** Adds the occupied part of cubes that is in the room, layer by layer where a cube reaches out of it. */
class VoxelDrawing
{
 public:
    VoxelDrawing(const VoxelBoxes& voxels, const VoxelBounds& room, mrpt::opengl::COctoMapVoxels& drawn)
        : m_voxels(voxels), m_room(room), m_drawn(drawn)
    {
    }

    void add(const VoxelBox& box)
    {
        const int side = box.side();
        if (!box.occupied || box.z + side <= m_room.firstZ || box.z >= m_room.lastZ) return;
        if (box.z >= m_room.firstZ && box.z + side <= m_room.lastZ) return addCube(box.x, box.y, box.z, side);
        for (int z = std::max<int>(box.z, m_room.firstZ); z < std::min(box.z + side, m_room.lastZ); ++z)
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x) addCube(box.x + x, box.y + y, z, 1);
    }

 private:
    void addCube(int x, int y, int z, int side)
    {
        const double half_m = side * m_voxels.resolution_m / 2;
        const double part = (z + side / 2.0 - m_room.firstZ) / (m_room.lastZ - m_room.firstZ);
        const auto grey = static_cast<std::uint8_t>(kDarkest + (kLightest - kDarkest) * part);
        m_drawn.push_back_Voxel(mrpt::opengl::VOXEL_SET_OCCUPIED,
                                {mrpt::math::TPoint3Df(mrpt::math::TPoint3D(
                                     m_voxels.lowerSide_m(x) + half_m, m_voxels.lowerSide_m(y) + half_m,
                                     m_voxels.lowerSide_m(z) + half_m)),
                                 2 * half_m, mrpt::img::TColor(grey, grey, grey, kOpacity)});
    }

    const VoxelBoxes& m_voxels;
    const VoxelBounds& m_room;
    mrpt::opengl::COctoMapVoxels& m_drawn;
};
}  // namespace

mrpt::opengl::CRenderizable::Ptr drawVoxels(const VoxelBoxes& voxels)
{
    auto drawn = mrpt::opengl::COctoMapVoxels::Create();
    drawn->setName("octree");
    drawn->resizeVoxelSets(2);
    drawn->showVoxels(mrpt::opengl::VOXEL_SET_OCCUPIED, true);
    drawn->showGridLines(false);
    drawn->enableLights(true);
    const VoxelBounds room = roomOf(voxels);
    VoxelDrawing drawing(voxels, room, *drawn);
    voxels.forEach([&](const VoxelBox& box) { drawing.add(box); });
    if (drawn->getVoxelCount(mrpt::opengl::VOXEL_SET_OCCUPIED) == 0)
        throw InputError(
            "the octree has no occupied voxel between floor and ceiling; check that it is the right file");
    drawn->setBoundingBox(
        {voxels.lowerSide_m(room.firstX), voxels.lowerSide_m(room.firstY), voxels.lowerSide_m(room.firstZ)},
        {voxels.lowerSide_m(room.lastX), voxels.lowerSide_m(room.lastY), voxels.lowerSide_m(room.lastZ)});
    return drawn;
}
}  // namespace gr2to
