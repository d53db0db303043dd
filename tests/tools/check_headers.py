#!/usr/bin/python3
"""Compiles every installed public header on its own, with the flags of a program that uses the library.

    check_headers.py INCLUDE_FOLDER COMPILE_COMMANDS     the second is the user's compile_commands.json

Standard library only.
"""
import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import sys


def flags_of(commands_file):
    """Compiler and flags of the first command, without its input and output."""
    words = shlex.split(json.loads(pathlib.Path(commands_file).read_text())[0]["command"])
    flags = []
    skip = False
    for word in words:
        if skip:
            skip = False
        elif word in ("-o", "-c"):
            skip = True
        else:
            flags.append(word)
    return flags


def complaint_about(header, flags, folder):
    """The compiler's first lines when the header does not compile alone, else None."""
    done = subprocess.run(flags + ["-fsyntax-only", "-x", "c++", "-"], input=f"#include <{header}>\n",
                          capture_output=True, text=True, cwd=folder, check=False)
    return None if done.returncode == 0 else f"{header}:\n" + "\n".join(done.stderr.splitlines()[:8])


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    flags = flags_of(sys.argv[2])
    headers = sorted(str(p.relative_to(folder)) for p in folder.rglob("*.h"))
    if not headers:
        sys.exit(f"{folder} holds no header")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        complaints = list(filter(None, pool.map(lambda h: complaint_about(h, flags, folder), headers)))
    print("\n".join(complaints) if complaints else f"{len(headers)} headers compile alone")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
