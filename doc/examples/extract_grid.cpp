/** From a grid's file to its places and doors: `extract_grid FILE [RESOLUTION_M]`. */
#include <gr2to/io/GridReader.h>
#include <gr2to/pipeline/Gr2To.h>

#include <iostream>

int main(int argc, char** argv)
try {
    if (argc < 2 || argc > 3) throw std::invalid_argument("usage: extract_grid FILE [RESOLUTION_M]");
    gr2to::TGridReaderOptions reading;
    if (argc == 3) reading.set("resolution", argv[2]);  // a bare image does not state it

    const gr2to::ClassifiedGrid grid = gr2to::readGrid(argv[1], reading);
    const gr2to::Extraction found = gr2to::Gr2To().extract(grid);
    for (const auto& [id, place] : found.map.places())
        std::cout << "place " << id << ": " << place.area_m2 << " m2 around (" << place.center.x << ", "
                  << place.center.y << "), " << place.walls.size() << " walls\n";
    for (const auto& connection : found.map.connections())
        if (const gr2to::Doorway& door = connection.doorway; door.real)
            std::cout << "door from " << connection.from << " to " << connection.to << ": "
                      << door.size.length_m << " m wide at (" << door.position.mean.x << ", "
                      << door.position.mean.y << ")\n";
    return 0;
} catch (const std::exception& error) {
    std::cerr << "extract_grid: " << error.what() << "\n";
    return 2;
}
