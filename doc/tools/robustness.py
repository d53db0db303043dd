#!/usr/bin/python3
"""Measures how places and doors are found in maps that are turned, resampled, noisy, broken or partial; prints tables, draws plots.

    robustness.py --gr2to build/release/apps/gr2to/gr2to --make-building build/release/apps/gr2to-make-building/gr2to-make-building
                  [--plots doc/images/robustness.png] [--save FILE] [--load FILE] [--every ipa=3 ...] [FOLDER...]

Generated buildings are measured always, with and without furniture. FOLDERs are sets of annotated maps, of which --every SET=N takes
every N-th. A set that holds rose_fr079_map2 to map15 is measured as a series of partial maps as well. --save keeps the figures as
JSON, and --load prints and draws them again. Needs python3-numpy, python3-scipy and python3-pil.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import zlib
from statistics import fmean

import numpy
from annotated import command_output
from PIL import Image, ImageDraw, ImageFont
from scipy.ndimage import distance_transform_edt
from scipy.optimize import linear_sum_assignment

FREE, UNKNOWN, OCCUPIED = 254, 205, 0
USUAL_RESOLUTION = 0.05
LEVELS = {"rotation": tuple(range(0, 50, 5)),                           # degrees
          "resolution": (0.025, 0.03, 0.04, 0.05, 0.065, 0.08, 0.1),    # metres
          "noise": (0, 0.01, 0.02, 0.03),                               # share of the known cells
          "gaps": (0, 0.1, 0.2, 0.3)}                                   # metres
USUAL = {"rotation": 0, "resolution": USUAL_RESOLUTION, "noise": 0, "gaps": 0}
GOAL = {"rotation": (0, 45), "resolution": (0.03, 0.08)}                # where matched IoU is to drop by at most ALLOWED_DROP
ALLOWED_DROP = 0.03
GAP_EVERY_M = 3
SERIES = range(2, 16)
# Pictures and scans are not looked at: as small as they get.
QUICK = ("--overlay-min-side", "1", "--overlay-max-side", "100", "--simplemap-rays-per-cell", "0.1", "--simplemap-dense-range", "1")


class AnnotatedMap:
    """A grid, the room of each of its cells and the truth about its doors."""

    def __init__(self, name, grid, rooms, truth):
        self.name, self.grid, self.rooms, self.truth = name, grid, rooms, truth
        self.resolution = truth["resolution_m"]

    @classmethod
    def read(cls, truth_path, variant):
        name = truth_path.name[:-len(".gt.json")]
        return cls(name, numpy.asarray(Image.open(truth_path.with_name(f"{name}.{variant}.png")).convert("L")),
                   numpy.asarray(Image.open(truth_path.with_name(f"{name}.gt_labels.png"))).astype(numpy.int32),
                   json.loads(truth_path.read_text()))

    def seed(self):
        return zlib.crc32(self.name.encode())

    def write(self, folder):
        """The path of the annotation."""
        Image.fromarray(self.grid.astype(numpy.uint8)).save(folder / f"{self.name}.clean.png")
        Image.fromarray(self.rooms.astype(numpy.uint16)).save(folder / f"{self.name}.gt_labels.png")
        path = folder / f"{self.name}.gt.json"
        path.write_text(json.dumps(self.truth))
        return path

    def with_grid(self, grid, rooms=None):
        return AnnotatedMap(self.name, grid, self.rooms if rooms is None else rooms, self.truth)


def resampled(source, angle_deg, resolution):
    """The map turned counter-clockwise on cells of another size.

    A new cell is occupied when old occupied cells cover a third of the area that an old cell has in it, so that thin walls keep
    together; else it is free or unknown, whichever covers more. Its room is the one nearest to its centre.
    """
    scale = source.resolution / resolution
    samples = 4 if scale < 1 else 3
    turn = numpy.deg2rad(angle_deg)
    cos, sin = numpy.cos(turn), numpy.sin(turn)
    height, width = source.grid.shape
    new_width = int(numpy.ceil(round((abs(cos) * width + abs(sin) * height) * scale, 6)))
    new_height = int(numpy.ceil(round((abs(sin) * width + abs(cos) * height) * scale, 6)))
    old_centre, new_centre = ((width - 1) / 2, (height - 1) / 2), ((new_width - 1) / 2, (new_height - 1) / 2)
    rows, columns = numpy.indices((new_height, new_width), numpy.float32)
    occupied, free = (numpy.zeros((new_height, new_width), numpy.int16) for _ in range(2))
    rooms = numpy.zeros((new_height, new_width), numpy.int32)
    steps = (numpy.arange(samples) + 0.5) / samples - 0.5
    for dx, dy in sorted(((x, y) for x in steps for y in steps), key=lambda step: numpy.hypot(*step)):
        x, y = (columns + dx - new_centre[0]) / scale, (rows + dy - new_centre[1]) / scale
        old_x = numpy.floor(cos * x - sin * y + old_centre[0] + 0.5).astype(int)
        old_y = numpy.floor(sin * x + cos * y + old_centre[1] + 0.5).astype(int)
        inside = (old_x >= 0) & (old_x < width) & (old_y >= 0) & (old_y < height)
        old_x, old_y = old_x.clip(0, width - 1), old_y.clip(0, height - 1)
        cells = numpy.where(inside, source.grid[old_y, old_x], UNKNOWN)
        occupied += cells == OCCUPIED
        free += cells == FREE
        rooms = numpy.where((rooms == 0) & inside, source.rooms[old_y, old_x], rooms)
    grid = numpy.where(2 * free >= samples ** 2 - occupied, FREE, UNKNOWN)
    grid[occupied >= samples ** 2 / 3 * min(1, scale) - 1e-9] = OCCUPIED
    rooms[grid != FREE] = 0

    def moved(point):
        x, y = point[0] - old_centre[0], point[1] - old_centre[1]
        return [(cos * x + sin * y) * scale + new_centre[0], (cos * y - sin * x) * scale + new_centre[1]]

    truth = dict(source.truth, resolution_m=resolution, size_px=[new_width, new_height])
    truth["interfaces"] = [dict(door, mid_px=moved(door["mid_px"]), **({"end_px": [moved(p) for p in door["end_px"]]} if "end_px" in door else {}))
                           for door in source.truth["interfaces"]]
    return AnnotatedMap(source.name, grid, rooms, truth)


def noisy(source, share):
    """Every known cell flips between free and occupied with this probability."""
    flips = numpy.random.default_rng(source.seed()).random(source.grid.shape) < share
    known = source.grid != UNKNOWN
    return source.with_grid(numpy.where(flips & known, numpy.where(source.grid == FREE, OCCUPIED, FREE), source.grid))


def broken(source, gap_m):
    """A gap of this width through walls between two rooms, every GAP_EVERY_M metres, half a metre and more away from doors."""
    if not gap_m:
        return source
    distance, nearest = distance_transform_edt(source.rooms == 0, return_indices=True)
    room = source.rooms[nearest[0], nearest[1]]
    pairs = []                                                          # cells side by side that are nearest to different rooms
    for dy, dx in ((0, 1), (1, 0)):
        first, second = room[:room.shape[0] - dy, :room.shape[1] - dx], room[dy:, dx:]
        pairs += [((y, x), (y + dy, x + dx)) for y, x in numpy.argwhere(first != second)]
    walls = [(a, b) for a, b in pairs if source.grid[a] == OCCUPIED and source.grid[b] == OCCUPIED
             and distance[a] + distance[b] < 0.5 / source.resolution]
    openings = numpy.ones(source.grid.shape, bool)
    for a, b in pairs:
        if source.grid[a] == FREE and source.grid[b] == FREE:
            openings[a] = False
    from_opening = distance_transform_edt(openings) if not openings.all() else numpy.full(openings.shape, numpy.inf)
    walls = [pair for pair in walls if from_opening[pair[0]] > 0.5 / source.resolution]
    numpy.random.default_rng(source.seed()).shuffle(walls)
    grid, rooms, chosen = source.grid.copy(), source.rooms.copy(), []
    for a, b in walls:
        a, b = tuple(a), tuple(b)
        if any(numpy.hypot(a[0] - y, a[1] - x) < GAP_EVERY_M / source.resolution for y, x in chosen):
            continue
        chosen.append(a)
        start, end = (nearest[:, cell[0], cell[1]].astype(float) for cell in (a, b))
        length = numpy.hypot(*(end - start))
        along = (end - start) / length
        reach = int(numpy.ceil(length + gap_m / source.resolution))
        top, left = max(0, a[0] - reach), max(0, a[1] - reach)
        y, x = numpy.indices(grid[top:a[0] + reach, left:a[1] + reach].shape)
        y, x = y + top - start[0], x + left - start[1]
        through, across = y * along[0] + x * along[1], x * along[0] - y * along[1]
        half = gap_m / source.resolution / 2
        hit = (through >= 0) & (through <= length) & (across >= -half) & (across < half)
        window = (slice(top, top + hit.shape[0]), slice(left, left + hit.shape[1]))
        hit &= grid[window] != FREE
        grid[window][hit] = FREE
        rooms[window][hit] = room[window][hit]
    return source.with_grid(grid, rooms)


def changed(source, kind, level):
    if kind == "rotation":
        return resampled(source, level, source.resolution)
    if kind == "resolution":
        return resampled(source, 0, level)
    return noisy(source, level) if kind == "noise" else broken(source, level)


class Building:
    """A generated building, which is turned and resampled by making it anew."""

    def __init__(self, program, seed, furniture):
        self.program, self.seed, self.furniture = program, seed, furniture

    def made(self, rotation=0, resolution=USUAL_RESOLUTION):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([self.program, "-o", folder, "--name", f"seed{self.seed}", "--seed", str(self.seed), "--furniture", str(self.furniture),
                            "--rotation", str(rotation), "--resolution", str(resolution)], check=True, capture_output=True)
            return AnnotatedMap.read(pathlib.Path(folder) / f"seed{self.seed}.gt.json", "clean")

    def changed(self, kind, level):
        return self.made(**{kind: level}) if kind in ("rotation", "resolution") else changed(self.made(), kind, level)


class StoredMap:
    def __init__(self, path, variant):
        self.path, self.variant = path, variant

    def changed(self, kind, level):
        return changed(AnnotatedMap.read(self.path, self.variant), kind, level)


def scores_of(gr2to, preset, annotated):
    with tempfile.TemporaryDirectory() as folder:
        truth = annotated.write(pathlib.Path(folder))
        image = truth.with_name(f"{annotated.name}.clean.png")
        options = ["--resolution", annotated.resolution, "--json"]
        command_output([gr2to, "extract", image, "--preset", preset, "-o", folder, *QUICK, *options])
        scores = command_output([gr2to, "compare", folder, truth, "--grid", image, *options])
    return scores["matched"]["mean_iou"], scores["doors"]["f1"] if scores["doors"]["reliable"] else None


def means_of(gr2to, preset, maps):
    scores = [scores_of(gr2to, preset, one) for one in maps]
    doors = [f1 for _, f1 in scores if f1 is not None]
    return fmean(iou for iou, _ in scores), fmean(doors) if doors else None


def measure_set(gr2to, preset, maps, name):
    """For each change and level the means of matched IoU and door F1."""
    result, unchanged = {}, means_of(gr2to, preset, (one.changed("gaps", 0) for one in maps))
    for kind, levels in LEVELS.items():
        result[kind] = [unchanged if level == USUAL[kind] else means_of(gr2to, preset, (one.changed(kind, level) for one in maps))
                        for level in levels]
        print(f"{name}, {preset}: {kind} done", file=sys.stderr, flush=True)
    return result


def places_of(gr2to, preset, grid, resolution):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "grid.png"
        Image.fromarray(grid.astype(numpy.uint8)).save(path)
        command_output([gr2to, "extract", path, "--resolution", resolution, "--preset", preset, "-o", folder, "--json", *QUICK])
        return numpy.asarray(Image.open(pathlib.Path(folder) / "places.png")).astype(numpy.int64)


def agreement(first, second, cells):
    """Share of cells that lie in places paired for the largest sum; cells in a place of one map only disagree."""
    a, b = first[cells], second[cells]
    table = numpy.bincount(a * (b.max() + 1) + b, minlength=(a.max() + 1) * (b.max() + 1)).reshape(a.max() + 1, b.max() + 1)
    rows, columns = linear_sum_assignment(-table[1:, 1:])
    return table[1:, 1:][rows, columns].sum() / max(1, table.sum() - table[0, 0])


def compare_series(grids, partitions, resolution):
    """Of each map and the one before: agreement on all cells free in both, and on those without a changed cell within a metre."""
    result = []
    for k in range(1, len(grids)):
        free = (grids[k - 1] == FREE) & (grids[k] == FREE)
        far = free & (distance_transform_edt(grids[k - 1] == grids[k]) > 1 / resolution)
        result.append([agreement(partitions[k - 1], partitions[k], cells) for cells in (free, far)])
    return result


def measure_series(arguments):
    """Agreement by series."""
    result = {}
    for folder in arguments.folders:
        paths = [folder / f"rose_fr079_map{k}.gt.json" for k in SERIES]
        if all(path.exists() for path in paths):
            maps = [AnnotatedMap.read(path, "clean") for path in paths]
            grids = [m.grid for m in maps]
            for preset in ("default", "paper"):
                partitions = [places_of(arguments.gr2to, preset, m.grid, m.resolution) for m in maps]
                result[f"rose, {preset}"] = compare_series(grids, partitions, maps[0].resolution)
            result["rose, annotation"] = compare_series(grids, [m.rooms for m in maps], maps[0].resolution)
    for preset in ("default", "paper"):
        runs = []
        for seed in arguments.seeds:
            whole = Building(arguments.make_building, seed, 0).made()
            columns = numpy.arange(whole.grid.shape[1])
            grids = [numpy.where(columns < whole.grid.shape[1] * k / SERIES[-1], whole.grid, UNKNOWN) for k in SERIES]
            runs.append(compare_series(grids, [places_of(arguments.gr2to, preset, grid, whole.resolution) for grid in grids], whole.resolution))
        result[f"generated, {preset}"] = numpy.mean(runs, axis=0).tolist()
    print("series done", file=sys.stderr, flush=True)
    return result


def measure_all(arguments):
    steps = dict(item.split("=") for item in arguments.every)
    sets = {"generated": [Building(arguments.make_building, seed, 0) for seed in arguments.seeds],
            "generated furnished": [Building(arguments.make_building, seed, 0.1) for seed in arguments.seeds]}
    for folder in arguments.folders:
        paths = sorted(folder.glob("*.gt.json"))[::int(steps.get(folder.name, 1))]
        for variant, name in (("clean", folder.name), ("furnitures", f"{folder.name} furnished")):
            maps = [StoredMap(path, variant) for path in paths if path.with_name(path.name[:-len("gt.json")] + f"{variant}.png").exists()]
            if maps:
                sets[name] = maps
    series = measure_series(arguments)
    curves = {name: {"maps": len(maps), **measure_set(arguments.gr2to, "default", maps, name)} for name, maps in sets.items()}
    curves["generated, paper"] = {"maps": len(sets["generated"]), **measure_set(arguments.gr2to, "paper", sets["generated"], "generated")}
    return {"curves": curves, "series": series}


def print_tables(figures):
    units = {"rotation": lambda v: f"{v}°", "resolution": lambda v: f"{v} m", "noise": lambda v: f"{100 * v:g} %", "gaps": lambda v: f"{v} m"}
    for kind, levels in LEVELS.items():
        low, high = GOAL.get(kind, (min(levels), max(levels)))
        span = f"{units[kind](low)} to {units[kind](high)}"
        for column, title in enumerate(("matched IoU", "door F1")):
            print(f"\n{kind.capitalize()}, {title}:\n\n| set | maps | " + " | ".join(map(units[kind], levels)) + f" | largest drop, {span} |")
            print("|---|---|" + "---|" * (len(levels) + 1))
            for name, curve in figures["curves"].items():
                values = [pair[column] for pair in curve[kind]]
                if values[0] is not None:
                    drop = values[levels.index(USUAL[kind])] - min(v for v, level in zip(values, levels) if low <= level <= high)
                    print(f"| {name} | {curve['maps']} | " + " | ".join(f"{v:.3f}" for v in values) + f" | {drop:.3f} |")
    print("\nPartial maps, share of cells free in both that agree with the map before:\n")
    print("| series | cells | " + " | ".join(str(k) for k in SERIES[1:]) + " | mean |\n|---|---|" + "---|" * len(SERIES))
    for name, pairs in figures["series"].items():
        for column, cells in enumerate(("all", "nothing changed within 1 m")):
            values = [pair[column] for pair in pairs]
            print(f"| {name} | {cells} | " + " | ".join(f"{v:.3f}" for v in values) + f" | {fmean(values):.3f} |")


# Colours of Okabe and Ito, which colour-blind people tell apart; furnished sets are dashed.
STYLES = {"generated": ("#0072B2", False, "generated"), "generated furnished": ("#0072B2", True, "generated, furnished"),
          "ipa": ("#D55E00", False, "ipa clean"), "ipa furnished": ("#D55E00", True, "ipa furnitures"),
          "homes": ("#009E73", False, "homes clean"), "homes furnished": ("#009E73", True, "homes furnitures"),
          "rose": ("#CC79A7", False, "rose, robots' maps"), "generated, paper": ("#777777", False, "generated, paper")}
SERIES_STYLES = {"generated, default": ("#0072B2", False, "generated"), "rose, default": ("#CC79A7", False, "rose"),
                 "rose, annotation": ("#000000", True, "rose, people"), "rose, paper": ("#777777", False, "rose, paper")}
WIDTH, PANEL, HEIGHT, OVERSAMPLING = 1600, 800, 1560, 2
LEAST_DRAWN = 0.5


class Sheet:
    """A picture that is drawn larger and reduced at the end, so that lines are smooth. Lengths are pixels of the result."""

    def __init__(self, width, height):
        self.image = Image.new("RGB", (width * OVERSAMPLING, height * OVERSAMPLING), "white")
        self.pen = ImageDraw.Draw(self.image)

    def line(self, points, colour, width=1, dash=0):
        points = [numpy.array(p, float) * OVERSAMPLING for p in points]
        width = round(width * OVERSAMPLING)
        if not dash:
            self.pen.line([tuple(p) for p in points], colour, width, "curve")
            return
        period, position = 2 * dash * OVERSAMPLING, 0
        for start, end in zip(points, points[1:]):
            length = numpy.hypot(*(end - start))
            done = 0
            while done < length:
                step = min(length - done, period / 2 - position % (period / 2))
                if position % period < period / 2:
                    self.pen.line([tuple(start + (end - start) * t / length) for t in (done, done + step)], colour, width)
                done, position = done + step, position + step + 1e-6

    def dot(self, point, colour, hollow, radius=6):
        x, y = (v * OVERSAMPLING for v in point)
        r = radius * OVERSAMPLING
        self.pen.ellipse((x - r, y - r, x + r, y + r), "white" if hollow else colour, colour, 2 * OVERSAMPLING)

    def text(self, point, words, size=25, anchor="mm", colour="#222222", bold=False):
        font = ImageFont.truetype("DejaVuSans-Bold.ttf" if bold else "DejaVuSans.ttf", size * OVERSAMPLING)
        self.pen.text(tuple(v * OVERSAMPLING for v in point), words, colour, font, anchor)

    def save(self, path):
        small = self.image.resize((self.image.width // OVERSAMPLING, self.image.height // OVERSAMPLING), Image.LANCZOS)
        small.quantize(128, dither=Image.Dither.NONE).save(path, optimize=True)


class Panel:
    """Axes on a sheet."""

    def __init__(self, sheet, left, top, title, label, ticks, bottom_value):
        self.sheet, self.bottom_value = sheet, bottom_value
        self.box = (left + 95, top + 62, left + PANEL - 30, top + 410)
        self.first, self.last = ticks[0][0], ticks[-1][0]
        x0, y0, x1, y1 = self.box
        sheet.text((x0, top + 30), title, 28, "lm", bold=True)
        for tenth in range(round(bottom_value * 10), 11):
            y = self.at(self.first, tenth / 10)[1]
            sheet.line([(x0, y), (x1, y)], "#DDDDDD")
            sheet.text((x0 - 14, y), f"{tenth / 10:.1f}", anchor="rm")
        for value, words in ticks:
            x = self.at(value, 1)[0]
            sheet.line([(x, y1), (x, y1 + 8)], "#555555", 2)
            sheet.text((x, y1 + 26), words)
        sheet.line([(x0, y0), (x0, y1), (x1, y1)], "#555555", 2)
        sheet.text(((x0 + x1) / 2, y1 + 62), label)

    def at(self, x, y):
        x0, y0, x1, y1 = self.box
        inset = 14
        return (x0 + inset + (x - self.first) / (self.last - self.first) * (x1 - x0 - 2 * inset),
                y1 - (y - self.bottom_value) / (1 - self.bottom_value) * (y1 - y0 - 10))

    def curve(self, xs, ys, style):
        points = [self.at(x, max(y, self.bottom_value)) for x, y in zip(xs, ys)]
        self.sheet.line(points, style[0], 4, 12 if style[1] else 0)
        for point, y in zip(points, ys):
            self.sheet.dot(point, style[0], style[1])
            if y < self.bottom_value:                                   # below the axis: the figure instead of the height
                self.sheet.text((min(point[0], self.box[2] - 20), point[1] - 22), f"{y:.2f}", 20, colour=style[0])


def legend(sheet, left, top, styles, title):
    sheet.text((left, top), title, 25, "lm", bold=True)
    for row, style in enumerate(styles):
        y = top + 40 + 38 * row
        sheet.line([(left, y), (left + 80, y)], style[0], 4, 12 if style[1] else 0)
        sheet.dot((left + 40, y), style[0], style[1])
        sheet.text((left + 100, y), style[2], 25, "lm")


def draw(figures, path):
    sheet = Sheet(WIDTH, HEIGHT)
    axes = (("rotation", "Turned maps: matched IoU", "degrees", [(v, str(v)) for v in LEVELS["rotation"]]),
            ("resolution", "Cells of other sizes: matched IoU", "side of a cell, cm", [(v, f"{100 * v:g}") for v in LEVELS["resolution"]]),
            ("noise", "Salt-and-pepper noise: matched IoU", "cells flipped, %", [(v, f"{100 * v:g}") for v in LEVELS["noise"]]),
            ("gaps", "Broken walls: matched IoU", "gaps this wide every 3 m, m", [(v, f"{v:g}") for v in LEVELS["gaps"]]))
    for index, (kind, title, label, ticks) in enumerate(axes):
        panel = Panel(sheet, index % 2 * PANEL, index // 2 * 520, title, label, ticks, LEAST_DRAWN)
        for name, style in STYLES.items():
            if name in figures["curves"]:
                panel.curve(LEVELS[kind], [pair[0] for pair in figures["curves"][name][kind]], style)
    panel = Panel(sheet, 0, 1040, "Partial maps: cells that keep their place", "map of the series", [(k, str(k)) for k in SERIES[1:]], LEAST_DRAWN)
    shown = [name for name in SERIES_STYLES if name in figures["series"]]
    for name in shown:
        panel.curve(SERIES[1:], [pair[0] for pair in figures["series"][name]], SERIES_STYLES[name])
    legend(sheet, PANEL + 95, 1070, [style for name, style in STYLES.items() if name in figures["curves"]], "Matched IoU")
    legend(sheet, PANEL + 485, 1070, [SERIES_STYLES[name] for name in shown], "Partial maps")
    sheet.save(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="*", type=pathlib.Path, help="folders of annotated maps, one set each")
    parser.add_argument("--gr2to", help="the program")
    parser.add_argument("--make-building", help="the generator of buildings")
    parser.add_argument("--seeds", type=lambda text: [int(seed) for seed in text.split(",")], default=[1, 2, 3])
    parser.add_argument("--every", action="append", default=[], metavar="SET=N", help="only every N-th map of a set")
    parser.add_argument("--plots", type=pathlib.Path, help="a PNG to draw")
    parser.add_argument("--save", type=pathlib.Path, help="keep the figures in this file")
    parser.add_argument("--load", type=pathlib.Path, help="take the figures from this file")
    arguments = parser.parse_args()
    if not arguments.load and not (arguments.gr2to and arguments.make_building):
        sys.exit("give --gr2to and --make-building, or --load")
    figures = json.loads(arguments.load.read_text()) if arguments.load else measure_all(arguments)
    if arguments.save:
        arguments.save.write_text(json.dumps(figures))
    print_tables(figures)
    if arguments.plots:
        draw(figures, arguments.plots)


if __name__ == "__main__":
    main()
