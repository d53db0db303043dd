#!/usr/bin/python3
"""Sends a robot from the first place of a map to each other one by `go_to_word`, and to a place by a word.

    drive_everywhere.py GO_TO_WORD GRID TOPOMAP

Fails when a place that wide enough doorways lead to cannot be driven to, or a place that they do not lead to can.
Standard library only.
"""
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

RADIUS_M = 0.25


def reachable(root, start):
    """Ids of the places that a robot of this radius gets to, with the space that the planner needs and what rounding takes."""
    width = 2 * math.sqrt(2) * RADIUS_M + (1 + math.sqrt(2)) * float(root.get("resolution"))
    ways = [(c.get("from"), c.get("to")) for c in root.iter("connection")
            if float(c.find("doorway/size").get("length")) >= width]
    reached, queue = {start}, [start]
    for here in queue:
        for a, b in ways:
            for there in ((b,) if a == here else (a,) if b == here else ()):
                if there not in reached:
                    reached.add(there)
                    queue.append(there)
    return reached


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    program, grid, topomap = sys.argv[1:]
    tree = ElementTree.parse(topomap)
    places = {p.get("id"): p for p in tree.getroot().iter("place")}
    start = min(places, key=int)
    expected = reachable(tree.getroot(), start)
    if len(expected) < 3:
        sys.exit(f"only {len(expected)} places can be reached: the map shows nothing")
    named = max(expected, key=int)
    ElementTree.SubElement(places[named].find("words"), "word").text = "Sam's office"
    center = places[start].find("center")
    with tempfile.TemporaryDirectory() as folder:
        tree.write(pathlib.Path(folder) / "topomap.xml")
        shutil.copy(pathlib.Path(topomap).parent / "places.png", folder)
        for word in sorted(places, key=int) + ["Sam's office", "nowhere"]:
            done = subprocess.run([program, grid, folder + "/topomap.xml", center.get("x"), center.get("y"), word, str(RADIUS_M)],
                                  capture_output=True, text=True, check=False)
            arrives = word in expected or word == "Sam's office"
            if (done.returncode == 0) != arrives:
                sys.exit(f"to '{word}', which {'can' if arrives else 'cannot'} be reached:\n{done.stdout}{done.stderr}")
    print(f"{len(expected)} of {len(places)} places reached")


if __name__ == "__main__":
    main()
