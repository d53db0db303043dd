#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "support/BuildingGenerator.h"

namespace gr2to::test
{
/** A building of the default kind. */
TBuildingOptions buildingOptions(int seed, double rotation_deg = 0.0, double furniture = 0.0);
/** Buildings of every layout, straight and turned, bare and furnished. */
std::vector<TBuildingOptions> variousBuildings();
/** For failure messages: what the building is made from. */
std::string nameOf(const TBuildingOptions& options);

/** Cell that holds a point of the map [m]; it may lie outside the grid. */
Cell cellAt(const ClassifiedGrid& grid, const Eigen::Vector2d& p);
/** Unit vector from room `a` of a door to room `b`. */
Eigen::Vector2d passage(const BuildingDoor& door);
/** Unit vector along the wall that the door is in. */
Eigen::Vector2d across(const BuildingDoor& door);
/** Free length through the door's centre along its wall, sampled at a tenth of a cell [m]. */
double freeRun(const ClassifiedGrid& grid, const BuildingDoor& door);

/** Free cells connected by their sides. */
struct Components
{
    int count = 0;
    std::vector<int> numbers;  //!< of every cell, from 1; 0 where it is not free or shut
};
/** \param shut  cells that count as occupied; empty: none */
Components freeComponents(const ClassifiedGrid& grid, const std::vector<bool>& shut = {});
/** The cells of all doorways by the annotation: the opening in the thickness of its wall, half a cell more
 * around. */
std::vector<bool> doorwayCells(const Building& building);
}  // namespace gr2to::test
