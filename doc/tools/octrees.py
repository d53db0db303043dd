#!/usr/bin/python3
"""Prints how the places found in synthetic octrees compare with those found in the clean plans that they were made from.

    octrees.py --gr2to build/release/apps/gr2to/gr2to [--preset default] OCTREE_FOLDER PLAN_FOLDER

OCTREE_FOLDER holds synthetic_NAME.bt and synthetic_NAME.3d.json, PLAN_FOLDER the annotated NAME.clean.png. Both maps are scored by
`gr2to compare` against the plan's annotation, in the frame of the plan's image (origin at its bottom-left corner), on the cells
that are free in both. Fails when a matched IoU differs by more than --tolerance. Needs python3-numpy and python3-pil.
"""
import argparse
import json
import pathlib
import sys
import tempfile

import numpy
from annotated import command_output
from PIL import Image

FREE_GREY = 250


def placed(places, grid, shape):
    """An image of places moved to where its grid lies in the frame of a plan; cells outside of the plan are cut off."""
    left = round(grid["origin"]["x_m"] / grid["resolution_m"])
    bottom = round(grid["origin"]["y_m"] / grid["resolution_m"])
    moved = numpy.zeros(shape, numpy.uint16)
    for row in range(shape[0]):
        source = places.shape[0] - shape[0] + row + bottom
        if 0 <= source < places.shape[0]:
            first, last = max(0, left), min(shape[1], left + places.shape[1])
            moved[row, first:last] = places[source, first - left:last - left]
    return moved


def scores_of(gr2to, preset, octree, plan_folder, folder):
    """Scores of the octree and of the plan."""
    truth = json.loads(octree.with_suffix(".3d.json").read_text())
    name, resolution = truth["map"], truth["resolution_m"]
    plan, annotation = plan_folder / f"{name}.clean.png", plan_folder / f"{name}.gt.json"
    found = command_output([gr2to, "extract", octree, "--preset", preset, "-o", folder / "octree", "--json"])
    command_output([gr2to, "extract", plan, "--resolution", resolution, "--preset", preset, "-o", folder / "plan", "--json"])
    clean = numpy.asarray(Image.open(plan).convert("L"))
    places = placed(numpy.asarray(Image.open(folder / "octree" / "places.png")), found["grid"], clean.shape)
    Image.fromarray(places).save(folder / "octree.png")
    both = numpy.where((clean >= FREE_GREY) & (places > 0), 255, 0).astype(numpy.uint8)
    Image.fromarray(both).save(folder / "both.png")
    compare = [annotation, "--grid", folder / "both.png", "--resolution", resolution, "--json"]
    return (name, command_output([gr2to, "compare", folder / "octree" / "topomap.xml", "--places", folder / "octree.png", *compare]),
            command_output([gr2to, "compare", folder / "plan", *compare]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("octrees", type=pathlib.Path)
    parser.add_argument("plans", type=pathlib.Path)
    parser.add_argument("--gr2to", required=True, help="the program")
    parser.add_argument("--preset", default="default")
    parser.add_argument("--tolerance", type=float, default=0.02)
    arguments = parser.parse_args()
    octrees = sorted(arguments.octrees.glob("synthetic_*.bt"))
    if not octrees:
        sys.exit(f"'{arguments.octrees}' holds no synthetic_NAME.bt; name a folder that does")
    print("| map | IoU octree | IoU plan | difference | door F1 octree | door F1 plan |\n|---|---|---|---|---|---|")
    worst = 0
    for octree in octrees:
        with tempfile.TemporaryDirectory() as folder:
            name, three, two = scores_of(arguments.gr2to, arguments.preset, octree, arguments.plans, pathlib.Path(folder))
        iou = [scores["matched"]["mean_iou"] for scores in (three, two)]
        worst = max(worst, abs(iou[0] - iou[1]))
        print(f"| {name} | {iou[0]:.3f} | {iou[1]:.3f} | {iou[0] - iou[1]:+.3f} | {three['doors']['f1']:.3f} | {two['doors']['f1']:.3f} |")
    if worst > arguments.tolerance:
        sys.exit(f"the largest difference is {worst:.3f}, more than {arguments.tolerance}")


if __name__ == "__main__":
    main()
