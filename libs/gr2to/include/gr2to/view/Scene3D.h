#pragma once

#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfObjects.h>

#include <string>

#include "gr2to/base/OptionTable.h"
#include "gr2to/grid/VoxelBoxes.h"
#include "gr2to/topology/TopologicalMap.h"

namespace gr2to
{
/** How a topological map is drawn in three dimensions. */
struct TSceneOptions : OptionTable
{
    double wall_height = 2.5;   //!< of walls whose height was not measured [m]
    double wall_opacity = 0.6;  //!< 1 hides what is behind a wall
    double door_height = 2.0;   //!< of doors whose height was not measured [m]
    bool graph = true;          //!< places and connections as a graph above the walls
    double graph_height = 3.5;  //!< above the floor [m]
    double azimuth = -90;   //!< where the eye is, seen from the map's middle, from x counter-clockwise [deg]
    double elevation = 55;  //!< of the eye above the floor [deg]
    int width = 1600;       //!< of a picture [px]
    int height = 1000;      //!< of a picture [px]

    std::string section() const override { return "scene"; }
    std::vector<OptionField> fields() override;
};

/** The map as objects of MRPT's scenes, in its own frame [m]: the places' floors in the colours of the
 * overlay, real walls and doors as upright planes, virtual walls as lines on the floor, and the graph above.
 */
mrpt::opengl::CSetOfObjects::Ptr drawMap(const TopologicalMap& map, const TSceneOptions& options = {});

/** The occupied voxels of a 3D map as voxels of MRPT's scenes (mrpt::opengl::COctoMapVoxels), for the same
 * frame: the higher the lighter. Floor and ceiling are left out where they are found (findRoomHeight()), as
 * they would hide the rooms. \throws InputError  no voxel is left
 */
mrpt::opengl::CRenderizable::Ptr drawVoxels(const VoxelBoxes& voxels);

/** A scene of the map with a camera that sees all of it, ready for MRPT's viewers. */
mrpt::opengl::COpenGLScene::Ptr makeScene(const TopologicalMap& map, const TSceneOptions& options = {});

/** A picture of a scene as the bytes of a PNG file, drawn off screen with no display (EGL).
 *
 * \throws OutputError  no such context can be had on this machine, or there is no memory for the picture
 */
std::string renderPng(const mrpt::opengl::COpenGLScene& scene, const TSceneOptions& options = {});
}  // namespace gr2to
