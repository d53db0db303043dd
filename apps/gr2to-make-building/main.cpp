#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <string>

#include "gr2to/base/errors.h"
#include "gr2to/base/files.h"
#include "gr2to/io/PngWriter.h"
#include "support/BuildingGenerator.h"

namespace
{
enum ExitCode
{
    kDone = 0,
    kFailed = 1,
    kBadUsage = 2
};

struct Arguments
{
    std::map<std::string, std::optional<std::string>> options;  //!< values as typed, by the field's name
    std::string folder = ".";
    std::string name = "building";
    std::optional<std::string> image;
};

/** `corridor_width` is `--corridor-width` on the command line. */
std::string flagOf(std::string field)
{
    std::replace(field.begin(), field.end(), '_', '-');
    return "--" + field;
}

std::string helpOf(const gr2to::OptionField& field)
{
    std::string text = field.meaning + " [" + field.typeText();
    if (!field.unit.empty()) text += ", " + field.unit;
    if (!field.rangeText().empty()) text += ", within " + field.rangeText();
    return text + "; default " + field.valueText() + "]";
}

void declare(CLI::App& app, Arguments& arguments)
{
    app.add_option("-o,--output", arguments.folder, "Folder to write into; made when missing [default: here]")
        ->type_name("DIR");
    app.add_option("--name", arguments.name, "Base name of the files [default: building]")->type_name("NAME");
    app.add_option("--image", arguments.image, "Name of the grid's image [default: NAME.clean.png]")
        ->type_name("FILE");
    gr2to::test::TBuildingOptions defaults;
    for (const auto& field : defaults.fields())
        app.add_option(flagOf(field.name), arguments.options[field.name], helpOf(field))->type_name("VALUE");
    app.footer(
        "Writes NAME.clean.png (254 free, 205 unknown, 0 occupied), NAME.yaml (ROS map_server), "
        "NAME.gt_labels.png\n"
        "(room of every free cell) and NAME.gt.json (rooms, doors, walls). Exit codes: 0 done, 1 failed, 2 "
        "bad usage.");
}

gr2to::test::TBuildingOptions optionsFrom(const Arguments& arguments)
{
    gr2to::test::TBuildingOptions options;
    for (const auto& [name, text] : arguments.options)
        if (text) options.set(name, *text);
    return options;
}

/** The name becomes part of paths, of YAML and of JSON. */
void requirePlain(const std::string& option, const std::string& name)
{
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
    };
    if (name.empty() || name.front() == '.' || !std::all_of(name.begin(), name.end(), plain))
        throw gr2to::InputError(
            option + " '" + name +
            "' must be a file name of letters, digits, '_', '-' and '.'; the folder goes to -o");
}

void run(const Arguments& arguments)
{
    const std::filesystem::path folder = arguments.folder;
    const std::string& name = arguments.name;
    const std::string image = arguments.image.value_or(name + ".clean.png");
    requirePlain("--name", name);
    requirePlain("--image", image);
    const auto building = gr2to::test::generateBuilding(optionsFrom(arguments));
    gr2to::OutputTransaction files;
    files.write(folder / image, gr2to::encodePng8(building.grid));
    files.write(folder / (name + ".gt_labels.png"), gr2to::encodePng16(building.labels));
    files.write(folder / (name + ".yaml"), gr2to::test::mapServerYaml(building.grid, image));
    files.write(folder / (name + ".gt.json"), gr2to::test::annotationJson(building, name));
    files.commit();
    std::cout << (folder / name).string() << ": " << building.grid.width() << " x " << building.grid.height()
              << " cells, " << building.rooms.size() << " rooms, " << building.doors.size() << " doors\n";
}
}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Generates the occupancy grid of a building from a seed, with the exact truth about it.",
                 "gr2to-make-building");
    Arguments arguments;
    declare(app, arguments);
    try {
        app.parse(argc, argv);
        run(arguments);
        return kDone;
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? kDone : kBadUsage;
    } catch (const gr2to::InputError& e) {
        std::cerr << "gr2to-make-building: error: " << e.what() << '\n';
        return kBadUsage;
    } catch (const std::invalid_argument& e) {
        std::cerr << "gr2to-make-building: error: " << e.what() << '\n';
        return kBadUsage;
    } catch (const std::exception& e) {
        std::cerr << "gr2to-make-building: error: " << e.what() << '\n';
        return kFailed;
    }
}
