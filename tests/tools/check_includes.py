#!/usr/bin/python3
"""Walks the #include lines of libs/gr2to and fails on an arrow that the layers do not allow.

    check_includes.py LIBRARY_FOLDER     checks LIBRARY_FOLDER/{include/gr2to,src}
    check_includes.py --self-test        checks that every kind of wrong arrow is found in a made-up tree

Standard library only.
"""
import pathlib
import re
import sys
import tempfile

# What each folder may include besides itself: other folders of the library, and other libraries by the first
# part of the name in angle brackets. The C++ standard library is open to all.
FOLDERS = {
    "base": (set(), {"mrpt/config", "posix"}),
    "grid": ({"base"}, {"Eigen"}),
    "topology": ({"grid", "base"}, {"Eigen", "mrpt/math", "mrpt/graphs"}),
    "stages": ({"topology", "grid", "base"}, {"Eigen", "mrpt/maps", "mrpt/config", "octomap"}),
    "refine": ({"topology", "grid", "base"}, {"Eigen", "ceres"}),
    "pipeline": ({"stages", "refine", "topology", "grid", "base"}, {"Eigen", "mrpt/maps", "mrpt/config"}),
    # The archive's reader takes XML files as well, so that callers need not know which of the two they hold.
    "mrpt": ({"pipeline", "io", "view", "topology", "grid", "base"}, {"Eigen", "mrpt", "zlib.h", "octomap"}),
    "io": ({"topology", "grid", "base"},
           {"Eigen", "mrpt", "pugixml.hpp", "png.h", "zlib.h", "yaml-cpp", "nlohmann", "posix", "octomap"}),
    "view": ({"topology", "grid", "base"}, {"Eigen", "cairo.h", "cairo-svg.h", "mrpt/img", "mrpt/opengl", "mrpt/math"}),
    "compare": ({"topology", "grid", "base"}, {"Eigen", "nlohmann"}),
}
POSIX = re.compile(r"(sys/.*|unistd|fcntl|dirent|poll|pthread)\.h$|sys/")
STANDARD = re.compile(r"[a-z_0-9]+$")  # <vector>, <cstdint>: a name without a slash or an ending
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def library_of(name):
    """The library that an include in angle brackets belongs to; None for the standard library."""
    if STANDARD.match(name):
        return None
    if POSIX.match(name):
        return "posix"
    parts = name.split("/")
    return "/".join(parts[:2]) if parts[0] == "mrpt" else parts[0]


class Library:
    """The sources of one library and the folders ("rooms") that they lie in."""

    def __init__(self, root):
        self.public = root / "include" / "gr2to"
        self.private = root / "src"

    def files(self):
        found = [p for top in (self.public, self.private) for p in top.rglob("*") if p.suffix in (".h", ".cpp")]
        return sorted(found)

    def is_public(self, path):
        return self.public in path.parents

    def folder(self, path):
        """First folder below include/gr2to or src; empty for a file that lies in none."""
        top = self.public if self.is_public(path) else self.private
        parts = path.relative_to(top).parts
        return parts[0] if len(parts) > 1 else ""

    def resolve(self, path, name):
        """The file of the library that a quoted include means; None when there is none."""
        for candidate in (path.parent / name, self.public.parent / name, self.private / name):
            if candidate.is_file():
                return candidate.resolve()
        return None


def complaint_about(library, path, quoted, name):
    """What is wrong with one include, None when nothing is."""
    folder = library.folder(path)
    if folder not in FOLDERS:
        return f"'{folder}' is no folder of the layers' table"
    folders, libraries = FOLDERS[folder]
    if not quoted:
        other = library_of(name)
        if other is None or other in libraries or other.split("/")[0] in libraries:
            return None
        return f"{folder}/ may not see <{name}>"
    target = library.resolve(path, name)
    if target is None:
        return f'"{name}" is no file of the library'
    if library.is_public(path) and not library.is_public(target):
        return f'a public header includes the private "{name}"'
    to = library.folder(target)
    if to != folder:
        return None if to in folders else f"{folder}/ may not include {to}/"
    if folder == "stages" and library.is_public(target) and target.stem != path.stem:
        return f"stages do not include one another: {target.stem}"
    return None


def check(root):
    """All wrong arrows of a library, as lines `file:line: what`."""
    library = Library(root.resolve())
    complaints = []
    files = library.files()
    if not files:
        complaints.append(f"{root}: holds no source file")
    for path in files:
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            what = complaint_about(library, path, match.group(1) == '"', match.group(2))
            if what:
                complaints.append(f"{path.relative_to(library.public.parent.parent)}:{number}: {what}")
    return complaints


RIGHT = {
    "include/gr2to/base/errors.h": "#include <stdexcept>",
    "include/gr2to/grid/Grid.h": '#include <Eigen/Core>\n#include "gr2to/base/errors.h"',
    "include/gr2to/topology/Map.h": '#include <mrpt/math/TPoint2D.h>\n#include "gr2to/grid/Grid.h"',
    "include/gr2to/stages/Doors.h": '#include "gr2to/grid/Grid.h"',
    "include/gr2to/stages/Places.h": '#include "gr2to/topology/Map.h"',
    "include/gr2to/pipeline/All.h": '#include "gr2to/stages/Doors.h"',
    "include/gr2to/io/Xml.h": '#include "gr2to/topology/Map.h"',
    "src/stages/Doors.cpp": '#include "gr2to/stages/Doors.h"\n#include "stages/helper.h"',
    "src/stages/helper.h": "#include <vector>",
    "src/refine/Refine.cpp": "  #  include <ceres/ceres.h>",
    "src/base/files.cpp": "#include <unistd.h>\n#include <sys/stat.h>",
    "src/io/Xml.cpp": '#include <pugixml.hpp>\n#include "helper.h"',
    "src/io/helper.h": "",
}
# Each line is put behind the right content of its file, alone, and has to be found.
WRONG = [
    ("include/gr2to/grid/Grid.h", '#include "gr2to/topology/Map.h"', "grid/ may not include topology/"),
    ("include/gr2to/grid/Grid.h", "#include <mrpt/math/TPoint2D.h>", "grid/ may not see <mrpt/math/TPoint2D.h>"),
    ("include/gr2to/base/errors.h", '#include "gr2to/grid/Grid.h"', "base/ may not include grid/"),
    ("include/gr2to/base/errors.h", "#include <Eigen/Core>", "base/ may not see <Eigen/Core>"),
    ("include/gr2to/topology/Map.h", "#include <mrpt/maps/CMetricMap.h>",
     "topology/ may not see <mrpt/maps/CMetricMap.h>"),
    ("include/gr2to/topology/Map.h", '#include "gr2to/io/Xml.h"', "topology/ may not include io/"),
    ("src/stages/Doors.cpp", '#include "gr2to/stages/Places.h"', "stages do not include one another: Places"),
    ("include/gr2to/stages/Places.h", '#include "gr2to/stages/Doors.h"', "stages do not include one another: Doors"),
    ("src/stages/Doors.cpp", '#include "gr2to/pipeline/All.h"', "stages/ may not include pipeline/"),
    ("src/stages/Doors.cpp", "#include <ceres/ceres.h>", "stages/ may not see <ceres/ceres.h>"),
    ("src/stages/Doors.cpp", '#include "../io/helper.h"', "stages/ may not include io/"),
    ("src/refine/Refine.cpp", '#include "gr2to/pipeline/All.h"', "refine/ may not include pipeline/"),
    ("include/gr2to/io/Xml.h", '#include "io/helper.h"', 'a public header includes the private "io/helper.h"'),
    ("src/io/Xml.cpp", '#include "nowhere.h"', '"nowhere.h" is no file of the library'),
    ("src/io/Xml.cpp", "#include <cairo.h>", "io/ may not see <cairo.h>"),
    ("src/attic/Old.cpp", "#include <vector>", "'attic' is no folder of the layers' table"),
]


def complaints_of(tree):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, content in tree.items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content + "\n")
        return check(root)


def self_test():
    failures = [f"right tree: {c}" for c in complaints_of(RIGHT)]
    if not complaints_of({}):
        failures.append("an empty library was not noticed")
    for name, line, expected in WRONG:
        content = RIGHT.get(name, "")
        found = complaints_of({**RIGHT, name: f"{content}\n{line}"})
        number = len(content.splitlines() or [""]) + 1
        if found != [f"{name}:{number}: {expected}"]:
            failures.append(f"{name} with {line}: expected '{expected}', found {found}")
    return failures


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    failures = self_test() if sys.argv[1] == "--self-test" else check(pathlib.Path(sys.argv[1]))
    for line in failures:
        print(line)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
