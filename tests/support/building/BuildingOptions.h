#pragma once

#include <string>
#include <vector>

#include "gr2to/base/OptionTable.h"

namespace gr2to::test
{
/** What a generated building looks like; see the table in BuildingOptions.cpp for ranges and meanings. */
struct TBuildingOptions : OptionTable
{
    int seed = 1;
    std::string layout = "auto";
    double resolution = 0.05;
    double width = 40.0;
    double height = 18.0;
    int tiles_x = 1;
    int tiles_y = 1;
    double corridor_width = 2.0;
    double room_min_size = 2.8;
    double room_max_size = 6.5;
    double door_min_width = 0.8;
    double door_max_width = 1.0;
    double double_doors = 0.1;
    double suites = 0.1;
    double extra_doors = 0.1;
    double closed_doors = 0.0;
    double wall_thickness = 0.15;
    double outer_wall_thickness = 0.3;
    double furniture = 0.0;
    double noise = 0.0;
    double speckle = 0.0;
    double wall_jitter = 0.0;
    double rotation = 0.0;
    double margin = 1.0;

    std::string section() const override { return "building"; }
    std::vector<OptionField> fields() override;

 protected:
    void checkRules() const override;
};
}  // namespace gr2to::test
