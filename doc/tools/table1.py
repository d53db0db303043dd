#!/usr/bin/python3
"""Prints a table like the paper's Table 1 for sets of annotated maps, as Markdown.

    table1.py --gr2to build/release/apps/gr2to/gr2to [--preset paper] [--sum homes] FOLDER...

Annotated rooms, corridors and doors stand beside those that `gr2to extract` finds. Corridors are followed by the circles
that they were merged from, doors by those missed and those wrong, as in the paper. A set named after --sum gets one row
that sums up its maps. What a set's annotation does not tell (corridors, or doors that were checked) is left out.
"""
import sys

from annotated import measure_set, parser_of, require_sets

COLUMNS = ("rooms", "corridors", "doors", "found_rooms", "found_corridors", "merged", "found_doors", "missed", "wrong")


def counts_of(measurement):
    truth, found, scores = measurement["truth"], measurement["found"], measurement["scores"]
    corridors = sum(room.get("is_corridor", False) for room in truth["rooms"])
    circles = next(stage for stage in found["stages"] if stage["stage"] == "place construction")["counts"]["circles"]
    doors = scores["doors"]
    hits = round(doors["recall"] * doors["n_gt"])
    return {"rooms": len(truth["rooms"]) - corridors, "corridors": corridors, "doors": doors["n_gt"],
            "found_rooms": found["rooms"], "found_corridors": found["corridors"], "merged": circles - found["rooms"],
            "found_doors": doors["n_pred"], "missed": doors["n_gt"] - hits, "wrong": doors["n_pred"] - hits}


def row(name, counts, graded, corridors_known):
    corridors = counts["corridors"] if corridors_known else "-"
    doors = f"{counts['found_doors']} ({counts['missed']}, {counts['wrong']})" if graded else f"{counts['found_doors']} (-)"
    return (f"| {name} | {counts['rooms']} | {counts['found_rooms']} | {corridors} | "
            f"{counts['found_corridors']} ({counts['merged']}) | {counts['doors'] if graded else '-'} | {doors} |")


def rows_of(folder, variant, arguments):
    measurements = measure_set(arguments.gr2to, arguments.preset, folder, variant, arguments.jobs)
    if not measurements:
        return []
    corridors_known = any("is_corridor" in room for m in measurements for room in m["truth"]["rooms"])
    graded = all(m["scores"]["doors"]["reliable"] for m in measurements)
    counts = [counts_of(m) for m in measurements]
    total = {key: sum(c[key] for c in counts) for key in COLUMNS}
    lines = [] if folder.name in arguments.sum else [row(m["name"], c, graded, corridors_known) for m, c in zip(measurements, counts)]
    return lines + [row(f"**{folder.name} {variant}, {len(counts)} maps**", total, graded, corridors_known)]


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--sum", action="append", default=[], metavar="SET", help="a set that gets one row")
    parser.add_argument("--variant", default="clean", help="which images of the maps")
    arguments = parser.parse_args()
    require_sets(arguments.folders)
    print("| map | rooms | found | corridors | found (merged) | doors | found (missed, wrong) |\n|---|---|---|---|---|---|---|")
    for folder in arguments.folders:
        print("\n".join(rows_of(folder, arguments.variant, arguments)))
    sys.exit(0)


if __name__ == "__main__":
    main()
