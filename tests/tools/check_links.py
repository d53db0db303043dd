#!/usr/bin/python3
"""Checks the documents of a project: relative links, pictures, headings and quoted code.

    check_links.py PROJECT_FOLDER     every .md file that is not below a build folder
    check_links.py --self-test        checks that every kind of breach is found in a made-up tree

A link must lead to a file or folder of the project and, after '#', to a heading of it. A code block that follows a
line <!-- quotes: FILE --> must stand in that file word for word, whatever its indentation. Standard library only.
"""
import pathlib
import re
import sys
import tempfile
import textwrap

LINK = re.compile(r"!?\[[^\]]*\]\(\s*<?([^)\s>]+)>?[^)]*\)|<img[^>]*\ssrc=\"([^\"]+)\"")
ELSEWHERE = re.compile(r"[a-z][a-z0-9+.-]*:", re.IGNORECASE)  # https:, mailto:
FENCE = re.compile(r"^\s*(```|~~~)")
QUOTES = re.compile(r"<!--\s*quotes:\s*(\S+)\s*-->")
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*$")
SKIPPED = re.compile(r"^(build(-.*)?|demo|\.git)$")


def anchor_of(heading):
    """The name that GitHub gives a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def parts_of(text):
    """(number, line) of the prose, and (number, quoted file, code) of the code blocks."""
    prose, blocks, code, quoted = [], [], None, None
    for number, line in enumerate(text.splitlines(), 1):
        if FENCE.match(line):
            if code is None:
                code, start = [], number
            else:
                blocks.append((start, quoted, "\n".join(code)))
                code = quoted = None
        elif code is not None:
            code.append(line)
        else:
            prose.append((number, line))
            match = QUOTES.search(line)
            quoted = match.group(1) if match else (quoted if not line.strip() else None)
    return prose, blocks


def anchors_in(path):
    found = [HEADING.match(line) for _, line in parts_of(path.read_text())[0]]
    return {anchor_of(match.group(1)) for match in found if match}


def complaint_about(path, target, root):
    """What is wrong with one link, None when nothing is."""
    if ELSEWHERE.match(target):
        return None
    name, _, anchor = target.partition("#")
    goal = (path.parent / name).resolve() if name else path
    if not goal.exists():
        return f"'{target}' leads nowhere"
    if root not in goal.parents and goal != root:
        return f"'{target}' leads out of the project"
    if anchor and goal.suffix == ".md" and anchor not in anchors_in(goal):
        return f"'{target}': there is no such heading"
    return None


def is_quoted(code, source):
    def plain(text):
        return "\n".join(line.strip() for line in textwrap.dedent(text).splitlines() if line.strip())
    return plain(code) != "" and plain(code) in plain(source)


def check_file(path, root):
    name = path.relative_to(root)
    prose, blocks = parts_of(path.read_text())
    for number, line in prose:
        for match in LINK.finditer(re.sub(r"`[^`]*`", "", line)):
            what = complaint_about(path, match.group(1) or match.group(2), root)
            if what:
                yield f"{name}:{number}: {what}"
    for number, quoted, code in blocks:
        if quoted and not (root / quoted).is_file():
            yield f"{name}:{number}: quotes '{quoted}', which does not exist"
        elif quoted and not is_quoted(code, (root / quoted).read_text()):
            yield f"{name}:{number}: the code does not stand in '{quoted}'"


def check(root):
    root = root.resolve()
    files = [p for p in sorted(root.rglob("*.md")) if not any(SKIPPED.match(part) for part in p.relative_to(root).parts)]
    complaints = [line for path in files for line in check_file(path, root)]
    return complaints if files else [f"{root}: holds no .md file"]


RIGHT = {
    "README.md": "# Top\n[a](doc/a.md), [b](doc/a.md#second-part-x), [c](https://nowhere.example), [top](#top)\n"
                 "`[not](a link)`\n```\n[neither](this)\n```\n![p](doc/p.png)\n",
    "doc/a.md": "## Second part: `x`\n<!-- quotes: doc/e.cpp -->\n```cpp\nint f()\n{\n```\n[up](../README.md)\n",
    "doc/p.png": "", "doc/e.cpp": "namespace a\n{\n    int f()\n    {\n",
    "build/x.md": "[broken](nowhere.md)",
}
WRONG = [
    ("README.md", "[a](doc/b.md)", "README.md:1: 'doc/b.md' leads nowhere"),
    ("README.md", "\n![p](q.png)", "README.md:2: 'q.png' leads nowhere"),
    ("README.md", "[a](doc/a.md#third)", "README.md:1: 'doc/a.md#third': there is no such heading"),
    ("README.md", "[a](..)", "README.md:1: '..' leads out of the project"),
    ("README.md", '<img width="5" src="q.png">', "README.md:1: 'q.png' leads nowhere"),
    ("doc/a.md", "<!-- quotes: doc/e.cpp -->\n```\nint g()\n```", "doc/a.md:2: the code does not stand in 'doc/e.cpp'"),
    ("doc/a.md", "<!-- quotes: e.cpp -->\n\n```\nint f()\n```", "doc/a.md:3: quotes 'e.cpp', which does not exist"),
]


def complaints_of(tree):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, content in tree.items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content)
        return check(root)


def self_test():
    failures = [f"right tree: {line}" for line in complaints_of(RIGHT)]
    if not complaints_of({}):
        failures.append("a project without documents was not noticed")
    for name, content, expected in WRONG:
        tree = {**RIGHT, "README.md": "# Top\n", "doc/a.md": "## Second part: `x`\n", name: content}
        found = complaints_of(tree)
        if found != [expected]:
            failures.append(f"{name}: expected '{expected}', found {found}")
    return failures


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    complaints = self_test() if sys.argv[1] == "--self-test" else check(pathlib.Path(sys.argv[1]))
    for line in complaints:
        print(line)
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
