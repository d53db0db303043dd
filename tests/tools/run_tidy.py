#!/usr/bin/python3
"""Runs clang-tidy on every source of a build folder, again only on what changed since it was last found clean.

    run_tidy.py PROJECT_FOLDER BUILD_FOLDER     BUILD_FOLDER has been built by Ninja

A source is remembered as clean under a hash of its compiler command, of everything that it includes, of the
settings and of clang-tidy's version. Standard library only.
"""
import concurrent.futures
import functools
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

FOLDERS = ("apps", "bench", "libs", "tests")


@functools.lru_cache(maxsize=None)
def digest_of_file(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()


def includes_by_output(build):
    """For each object file of the build the files that it was made from, as Ninja noted them."""
    listing = subprocess.run(["ninja", "-C", str(build), "-t", "deps"], capture_output=True, text=True, check=True).stdout
    includes = {}
    for block in listing.split("\n\n"):
        head, *files = block.splitlines() or [""]
        if "(VALID)" in head:
            includes[head.split(":")[0]] = [str(build / line.strip()) for line in files]
    return includes


def key_of(command, files, settings):
    """Hash of all that the verdict on a source depends on; None when that is not known or a file is gone."""
    if not files:
        return None
    try:
        parts = [command, settings] + [digest_of_file(path) for path in files]
    except OSError:
        return None
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def without_precompiled_headers(build, cache):
    """A compilation database like the build's, in a folder of its own, without g++'s precompiled headers, which clang cannot read."""
    text = (build / "compile_commands.json").read_text()
    database = cache / "commands"
    database.mkdir(exist_ok=True)
    text = re.sub(r" -Winvalid-pch| -include [^ ]*cmake_pch\.hxx| -fpch-preprocess", "", text)
    (database / "compile_commands.json").write_text(text)
    return database, json.loads(text)


def check(database, cache, source, key):
    """(source, output of a failed check or None); a clean source is remembered."""
    if key and (cache / key).exists():
        return source, None
    done = subprocess.run(["clang-tidy", "-quiet", "-p", str(database), source], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return source, done.stdout + (done.stderr if not done.stdout else "")
    if key:
        (cache / key).touch()
    return source, None


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    project, build = (pathlib.Path(a).resolve() for a in sys.argv[1:])
    cache = build / "tidy-cache"
    cache.mkdir(exist_ok=True)
    version = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
    settings = "".join([version] + [p.read_text() for p in sorted(project.rglob(".clang-tidy")) if build not in p.parents])
    includes = includes_by_output(build)
    own = re.compile(re.escape(str(project)) + "/(" + "|".join(FOLDERS) + ")/")
    database, commands = without_precompiled_headers(build, cache)
    work = []
    for entry in commands:
        if own.match(entry["file"]):
            output = re.search(r" -o (\S+)", entry["command"]).group(1)
            work.append((entry["file"], key_of(entry["command"], includes.get(output), settings)))
    if not work:
        sys.exit(f"{build}: its compile_commands.json names no source of the project")
    known = sum(1 for _, key in work if key and (cache / key).exists())
    print(f"{len(work)} sources, {known} of them clean when last checked", flush=True)
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for source, output in pool.map(lambda w: check(database, cache, *w), work):
            if output is not None:
                failed += 1
                print(f"{os.path.relpath(source, project)}:\n{output}", flush=True)
    print(f"{failed} sources with findings")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
