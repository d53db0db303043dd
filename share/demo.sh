#!/usr/bin/env bash
# From a fresh Debian 12 to two buildings taken apart into places, doors and walls:
#
#   bash share/demo.sh
#
# Installs what is missing, builds Gr2To and runs it on a real robot's grid and on the shipped sample.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/demo
output=$root/demo
trap 'echo "demo.sh: failed at line $LINENO; see the messages above" >&2' ERR

bash "$root/share/install-dependencies.sh" build demo

# The preset names its folder after itself; a folder of its own leaves a developer's build as it is.
(cd "$root" && cmake --preset release -B "$build" -DGR2TO_BUILD_TESTS=OFF -DGR2TO_BUILD_BENCHMARKS=OFF \
    -DGR2TO_WARNINGS_AS_ERRORS=OFF >/dev/null)
cmake --build "$build"
gr2to=$build/apps/gr2to/gr2to

real_map=$(dpkg -L mrpt-common | grep '/uwb_ro-localization_demo_map\.gridmap\.gz$') || {
    echo "demo.sh: package mrpt-common holds no uwb_ro-localization_demo_map.gridmap.gz; reinstall the package" >&2
    exit 1
}

declare -A inputs=([robot]=$real_map [office]=$root/share/sample/office.yaml)
for name in robot office; do
    printf '\n== %s: %s\n' "$name" "${inputs[$name]}"
    "$gr2to" extract "${inputs[$name]}" -o "$output/$name"
    for file in topomap.xml places.png overlay.png overlay.svg; do
        [ -s "$output/$name/$file" ] || {
            echo "demo.sh: gr2to wrote no $output/$name/$file" >&2
            exit 1
        }
    done
done

cat <<END

Open these pictures:
  $output/robot/overlay.png    a room with doorways, mapped by a robot (MRPT's demonstration data)
  $output/office/overlay.png   the generated office floor of share/sample/
Beside them lie overlay.svg (the same, to zoom into), topomap.xml (the map) and places.png (the place of every cell).
To go on:  $gr2to extract --help
END
