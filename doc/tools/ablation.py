#!/usr/bin/python3
"""Prints what each ingredient of a preset adds: the accuracy on sets of annotated maps with one of them switched off at a time, as Markdown.

    ablation.py --gr2to build/release/apps/gr2to/gr2to [--preset default] [--every homes=3] FOLDER...

Each cell holds the means of matched IoU, matched MCC and door F1 over a set's maps, as `gr2to compare` prints them; door scores are left
out where the annotation says that its doors were not checked. Maps that the program fails on are counted and left out. Rows appear as
they are measured.
"""
import json
import sys
import tempfile
from statistics import fmean

from annotated import command_output, parser_of, require_sets

# Pictures and scans are not looked at: as small as they get.
QUICK = ("--overlay-min-side", "1", "--overlay-max-side", "100", "--simplemap-rays-per-cell", "0.1", "--simplemap-dense-range", "1")
CHANGES = (
    ("all as in the preset", ()),
    ("circles instead of cuts along walls", ("--cut-along-walls", "no")),
    ("no extensions of walls", ("--cut-max-extension", "0")),
    ("every extension up to 10 m", ("--cut-extension", "10", "--cut-extension-ratio", "0")),
    ("every extension up to 20 m", ("--cut-extension", "20")),
    ("places from 1.5 m2 and 1 m of width on", ("--cut-min-area", "1.5", "--cut-min-radius", "0.5")),
    ("no critical lines", ("--cut-max-critical-line", "0")),
    ("no filter for things that stand free", ("--filter-max-blob-area", "0")),
    ("pieces of wall of 0.7 m stay wherever they stand", ("--filter-min-wall", "0.7")),
    ("pieces in line with walls are as good as others", ("--filter-min-aligned-wall", "1")),
    ("pieces that stand alone may be as thick as those in line", ("--filter-max-lone-thickness", "0.7")),
    ("thick things count as walls", ("--filter-max-wall-thickness", "10", "--filter-max-lone-thickness", "10")),
    ("places without passages of at least 1.5 m2", ("--cut-min-lone-area", "1.5")),
    ("clearance not measured to unknown cells", ("--distance-unknown-is-obstacle", "no")),
    ("no mouths of corridors", ("--cut-mouth-openness", "0")),
    ("walls in any direction", ("--wall-max-angle", "45")),
    ("walls of at least 1 m only", ("--wall-min-length", "1")),
    ("evidence 0.5 more is asked for", ("--cut-min-evidence", "0.5")),
    ("evidence 0.5 less is asked for", ("--cut-min-evidence", "-0.5")),
)


def maps_of(folder, every):
    """Images of a set, by variant: lists of the annotation and the image."""
    truths = sorted(folder.glob("*.gt.json"))[::every]
    images = {variant: [(path, path.with_name(path.name[:-len("gt.json")] + f"{variant}.png")) for path in truths]
              for variant in ("clean", "furnitures")}
    return {variant: [pair for pair in pairs if pair[1].exists()] for variant, pairs in images.items()}


def scores_of(gr2to, preset, options, truth, image):
    """None when the program fails."""
    resolution = json.loads(truth.read_text())["resolution_m"]
    with tempfile.TemporaryDirectory() as folder:
        try:
            command_output([gr2to, "extract", image, "--resolution", resolution, "--preset", preset, "-o", folder, "--json", *QUICK, *options])
        except RuntimeError as error:
            print(f"{image.name} {' '.join(options)}: {error}", file=sys.stderr)
            return None
        return command_output([gr2to, "compare", folder, truth, "--grid", image, "--resolution", resolution, "--json"])


def cell(results):
    scores = [result for result in results if result]
    failed = f" ({len(results) - len(scores)} failed)" if len(scores) < len(results) else ""
    if not scores:
        return "all failed"
    iou, mcc = (fmean(s["matched"][key] for s in scores) for key in ("mean_iou", "mcc"))
    graded = all(s["doors"]["reliable"] for s in scores)
    return f"{iou:.3f} {mcc:.3f} " + (f"{fmean(s['doors']['f1'] for s in scores):.3f}" if graded else "-") + failed


def main():
    parser = parser_of(__doc__)
    parser.set_defaults(preset="default")
    parser.add_argument("--every", action="append", default=[], metavar="SET=N", help="only every N-th map of a set")
    parser.add_argument("--only", action="append", metavar="TEXT", help="only rows whose name holds this")
    arguments = parser.parse_args()
    require_sets(arguments.folders)
    steps = dict(item.split("=") for item in arguments.every)
    sets = {f"{folder.name} {variant}": maps for folder in arguments.folders
            for variant, maps in maps_of(folder, int(steps.get(folder.name, 1))).items() if maps}
    print("| changed | " + " | ".join(f"{name} ({len(maps)})" for name, maps in sets.items()) + " |\n|---|" + "---|" * len(sets))
    for name, options in CHANGES:
        if arguments.only and not any(text in name for text in arguments.only):
            continue
        cells = [cell([scores_of(arguments.gr2to, arguments.preset, options, *pair) for pair in maps]) for maps in sets.values()]
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
