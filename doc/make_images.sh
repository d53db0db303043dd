#!/usr/bin/env bash
# Makes every picture in doc/images again, from the shipped sample, generated buildings and maps that others publish:
#
#   bash doc/make_images.sh [BUILD_FOLDER [ROSE_FOLDER [OCTREE_FOLDER]]]
#
# BUILD_FOLDER holds apps/gr2to/gr2to (default: build/release). ROSE_FOLDER holds the ROSE2 maps as NAME.clean.png (MIT
# licence), OCTREE_FOLDER OctoMap's sample geb079.bt; without them the pictures of these maps stay as they are. Needs
# mrpt-common, python3-pil and a build with gr2to-rawlog.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$(cd "${1:-$root/build/release}" && pwd)
rose=${2:-}
octrees=${3:-}
gr2to=$build/apps/gr2to/gr2to
make_building=$build/apps/gr2to-make-building/gr2to-make-building
images=$root/doc/images
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$images"

# overlay NAME INPUT [OPTION...]: $scratch/NAME.png
overlay() {
    local name=$1 input=$2
    shift 2
    "$gr2to" extract "$input" -o "$scratch/$name" --quiet "$@"
    mv "$scratch/$name/overlay.png" "$scratch/$name.png"
}

# scene NAME [OPTION...]: $scratch/scene-NAME.png, of what overlay made
scene() {
    local name=$1
    shift
    "$gr2to" render "$scratch/$name" --to png -o "$scratch/scene-$name.png" --scene-height 800 "$@" >/dev/null
}

# picture NAME WIDTH [--crop X0,Y0,X1,Y1] SOURCE...: doc/images/NAME.png, the sources side by side
picture() {
    local name=$1 width=$2
    shift 2
    /usr/bin/python3 "$root/doc/tools/compose.py" "$images/$name.png" "$width" "$@"
}

# layers [LAYER...]: the options that draw these layers and no others
layers() {
    local layer wanted=" $* " switch
    for layer in grid places ids voronoi critical_points doors walls connections legend scale_bar; do
        switch=no
        [[ $wanted != *" $layer "* ]] || switch=yes
        printf -- '--set overlay.%s=%s ' "$layer" $switch
    done
}
skeleton=$(layers grid voronoi critical_points legend scale_bar)
plan=$(layers grid places ids doors legend scale_bar)
outlines=$(layers grid places ids doors walls legend scale_bar)
bare=$(layers grid places ids doors)

sample=$root/share/sample/office
# shellcheck disable=SC2086 # the layers are words
overlay office "$sample.yaml" $bare
picture office-before-after 1200 "$sample.png" "$scratch/office.png"
scene office --scene-graph no --scene-elevation 60
picture scene-office 1200 --crop 0.16,0.1,0.88,0.96 "$scratch/scene-office.png"

"$make_building" -o "$scratch" --name floor --seed 5 --width 26 --height 14 >/dev/null
"$make_building" -o "$scratch" --name furnished --seed 5 --width 26 --height 14 --furniture 0.1 >/dev/null
# shellcheck disable=SC2086
{
    overlay skeleton "$scratch/floor.yaml" $skeleton
    overlay plan "$scratch/floor.yaml" $plan
    overlay outlines "$scratch/floor.yaml" $outlines
    overlay furnished-paper "$scratch/furnished.yaml" $plan --preset paper
    overlay furnished-default "$scratch/furnished.yaml" $plan
}
overlay everything "$scratch/floor.yaml"
picture floor-everything 1000 "$scratch/everything.png"
picture floor-skeleton-and-places 1200 "$scratch/skeleton.png" "$scratch/plan.png"
picture floor-walls 1000 "$scratch/outlines.png"
picture furnished-presets 1200 "$scratch/furnished-paper.png" "$scratch/furnished-default.png"

robot=$(dpkg -L mrpt-common | grep '/uwb_ro-localization_demo_map\.gridmap\.gz$')
# shellcheck disable=SC2086
{
    overlay robot-paper "$robot" --preset paper $(layers grid places ids voronoi legend)
    overlay robot-default "$robot" $(layers grid places ids voronoi legend)
}
picture robot-presets 1000 "$scratch/robot-paper.png" "$scratch/robot-default.png"

datasets=$(dirname "$robot")
views=$(layers grid places ids doors scale_bar)
large='--set overlay.text_size=44 --set overlay.door_width=9'  # the pictures are reduced
spacious='--cut-max-critical-line 15'                           # halls and squares have wide openings
# shellcheck disable=SC2086
{
    overlay lab "$datasets/localization_demo.simplemap.gz" $views
    overlay hall "$datasets/malaga-cs-fac-building.simplemap.gz" $views $large $spacious
    overlay loop "$datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog" $views $large $spacious
    overlay uwb "$datasets/uwb_ro-localization_demo.rawlog" $views $large
    overlay part "$datasets/localization_demo.rawlog" $views $large
    overlay campus "$datasets/2006-MalagaCampus.gridmap.gz" $views $spacious
}
picture mrpt-simplemaps 1200 "$scratch/lab.png" "$scratch/hall.png"
picture mrpt-rawlogs 1200 "$scratch/loop.png" "$scratch/uwb.png" "$scratch/part.png"
picture mrpt-campus 700 "$scratch/campus.png"

if [ -n "$rose" ]; then
    # shellcheck disable=SC2086
    overlay rose "$rose/rose_fr079_map10.clean.png" --resolution 0.05 $plan
    picture rose-office 1000 "$scratch/rose.png"
fi
if [ -n "$octrees" ]; then
    # shellcheck disable=SC2046 # the layers are words
    overlay octree "$octrees/geb079.bt" $(layers grid places ids doors connections legend scale_bar)
    picture octree-geb079 1400 "$scratch/octree.png"
    scene octree --octree "$octrees/geb079.bt" --scene-graph no
    picture scene-geb079 1400 --crop 0.02,0.12,0.96,0.84 "$scratch/scene-octree.png"
fi
ls -l "$images"
