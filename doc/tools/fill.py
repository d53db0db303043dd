#!/usr/bin/python3
"""Puts standard input between the lines <!-- NAME:begin --> and <!-- NAME:end --> of a document.

    accuracy.py ... | fill.py doc/benchmarks.md accuracy-paper
"""
import pathlib
import sys


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    path, name = pathlib.Path(sys.argv[1]), sys.argv[2]
    begin, end = f"<!-- {name}:begin -->\n", f"<!-- {name}:end -->"
    text, content = path.read_text(), sys.stdin.read().strip()
    if text.count(begin) != 1 or text.count(end) != 1 or not content:
        sys.exit(f"'{path}' needs the marks of '{name}' once, and standard input a text to put between them")
    head, rest = text.split(begin)
    path.write_text(head + begin + content + "\n" + end + rest.split(end)[1])


if __name__ == "__main__":
    main()
