#!/usr/bin/python3
"""Prints how well the places, doors and connections of sets of annotated maps are found, as a Markdown table of means.

    accuracy.py --gr2to build/release/apps/gr2to/gr2to [--preset paper] [--variants clean,furnitures] FOLDER...

Every figure is the mean over a set's maps of one that `gr2to compare` prints. Door scores are left out where the annotation
says that its doors were not checked.
"""
from statistics import fmean

from annotated import measure_set, parser_of, require_sets

FIGURES = (("recall", "bormann", "recall"), ("precision", "bormann", "precision"), ("matched IoU", "matched", "mean_iou"),
           ("matched MCC", "matched", "mcc"), ("door F1", "doors", "f1"), ("edge F1", "edges", "f1"))


def row(name, measurements):
    scores = [m["scores"] for m in measurements]
    graded = all(s["doors"]["reliable"] for s in scores)
    means = [f"{fmean(s[group][key] for s in scores):.3f}" if graded or group != "doors" else "-" for _, group, key in FIGURES]
    off_by = fmean(abs(s["matched"]["count_error"]) for s in scores)
    return f"| {name} | {len(scores)} | " + " | ".join(means) + f" | {off_by:.1f} |"


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--variants", default="clean,furnitures")
    arguments = parser.parse_args()
    require_sets(arguments.folders)
    print("| set | maps | " + " | ".join(name for name, _, _ in FIGURES) + " | rooms off by |\n|---|---|" + "---|" * (len(FIGURES) + 1))
    for folder in arguments.folders:
        for variant in arguments.variants.split(","):
            measurements = measure_set(arguments.gr2to, arguments.preset, folder, variant, arguments.jobs)
            if measurements:
                print(row(f"{folder.name} {variant}", measurements))


if __name__ == "__main__":
    main()
