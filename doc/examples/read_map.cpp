/** What surrounds each place of a stored map: `read_map TOPOMAP`, an XML file or an archive. */
#include <gr2to/mrpt/archive.h>

#include <cmath>
#include <iostream>

int main(int argc, char** argv)
try {
    if (argc != 2) throw std::invalid_argument("usage: read_map TOPOMAP");

    const gr2to::TopologicalMap map = gr2to::loadTopologicalMap(argv[1]);
    for (const auto& [id, place] : map.places()) {
        double brick = 0, virtualLength = 0;
        for (const gr2to::Wall& wall : place.walls) (wall.real ? brick : virtualLength) += wall.size.length_m;
        std::cout << "place " << id << ": " << brick << " m of real wall, " << virtualLength
                  << " m of virtual wall\n";
        for (const gr2to::Connection& way : map.connectionsOf(id)) {
            const gr2to::Doorway& door = way.doorway;
            std::cout << "  to place " << (way.from == id ? way.to : way.from)
                      << (door.real ? " by a door " : " by an opening ") << door.size.length_m
                      << " m wide, +-" << std::sqrt(door.size.covariance(0, 0)) << " m\n";
        }
    }
    return 0;
} catch (const std::exception& error) {
    std::cerr << "read_map: " << error.what() << "\n";
    return 2;
}
