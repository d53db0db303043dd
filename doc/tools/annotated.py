"""Runs gr2to over a set of annotated maps, NAME.<variant>.png with NAME.gt.json and NAME.gt_labels.png. Standard library only."""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor


def command_output(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{command[0]} {command[1]}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def measure(gr2to, preset, truth_path, variant):
    """What `extract` found and what `compare` says about it; None when the set has no such variant of the map."""
    name = truth_path.name[:-len(".gt.json")]
    image = truth_path.with_name(f"{name}.{variant}.png")
    if not image.exists():
        return None
    truth = json.loads(truth_path.read_text())
    resolution = truth["resolution_m"]
    with tempfile.TemporaryDirectory() as folder:
        found = command_output([gr2to, "extract", image, "--resolution", resolution, "--preset", preset, "-o", folder, "--json"])
        scores = command_output([gr2to, "compare", folder, truth_path, "--grid", image, "--resolution", resolution, "--json"])
    return {"name": name, "truth": truth, "found": found, "scores": scores}


def measure_set(gr2to, preset, folder, variant, jobs=1):
    """One measurement a map, in the order of the names."""
    truths = sorted(folder.glob("*.gt.json"))
    with ThreadPoolExecutor(jobs) as pool:
        results = list(pool.map(lambda path: measure(gr2to, preset, path, variant), truths))
    return [result for result in results if result]


def parser_of(description):
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path, help="folders of annotated maps, one set each")
    parser.add_argument("--gr2to", required=True, help="the program")
    parser.add_argument("--preset", default="paper")
    parser.add_argument("--jobs", type=int, default=1, help="maps at a time")
    return parser


def require_sets(folders):
    for folder in folders:
        if not any(folder.glob("*.gt.json")):
            sys.exit(f"'{folder}' holds no annotated map (NAME.gt.json); name a folder that does")
