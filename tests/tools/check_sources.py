#!/usr/bin/python3
"""Holds the sources to the house rules that a compiler does not check.

    check_sources.py PROJECT_FOLDER      one line a breach; long functions are reported, all else fails
    check_sources.py --self-test         checks that every kind of breach is found in a made-up tree

Standard library only.
"""
import pathlib
import re
import sys
import tempfile

FOLDERS = ("apps", "bench", "doc", "libs", "share", "tests", "cmake", ".ci")
CODE = (".h", ".cpp")
TEXT = CODE + (".py", ".sh", ".txt", ".cmake", ".in", ".md", ".yaml", ".xsd", ".ini", "")
MOST_LINES = 300
MOST_LINES_OF_FUNCTION = 60

# Put together from halves, so that this file does not break its own rules.
MACHINE_PATH = re.compile("/(" + "work|root|home/[a-z]+" + ")/|/tmp" + "/")
TEMPORARY_TEMPLATE = re.compile("XXXXXX")  # of mkdtemp and mktemp
UNFINISHED = re.compile(r"\b(TO" + "DO|FIX" + "ME|XX" + r"X|HA" + r"CK)\b")
SWITCHED_OFF = re.compile(r"\bDISABLED" + "_|(EXPECT|ASSERT)_TRUE" + r"\(true\)")
DOCSTRING = re.compile(r"/\*\*|///")
OPENING = re.compile(r"^( *)\{$")
NOT_A_FUNCTION = re.compile(r"^ *(namespace|class|struct|enum|union|extern|template <)\b")


def long_functions(lines):
    """(line, length) of functions with a body of too many lines; the formatter puts their braces on own lines."""
    found = []
    for start, line in enumerate(lines):
        opening = OPENING.match(line)
        if not opening or start == 0 or NOT_A_FUNCTION.match(lines[start - 1]):
            continue
        closing = re.compile("^" + opening.group(1) + r"\}")
        end = next((i for i in range(start + 1, len(lines)) if closing.match(lines[i])), start)
        if end - start + 1 > MOST_LINES_OF_FUNCTION:
            found.append((start, end - start + 1))
    return found


def breaches_of_line(line):
    if MACHINE_PATH.search(line) and not TEMPORARY_TEMPLATE.search(line):
        yield "a path of one machine"
    if UNFINISHED.search(line):
        yield "unfinished"
    if SWITCHED_OFF.search(line):
        yield "a test that is switched off or cannot fail"


def check_file(path, name):
    """(breaches, remarks) of one file."""
    text = path.read_text(errors="replace")
    lines = text.splitlines()
    breaches = [f"{name}:{number}: {what}" for number, line in enumerate(lines, 1) for what in breaches_of_line(line)]
    remarks = []
    if path.suffix in CODE:
        if len(lines) > MOST_LINES:
            breaches.append(f"{name}: {len(lines)} lines, more than {MOST_LINES}: which thing in it has a name of its own?")
        remarks = [f"{name}:{start}: a function of {length} lines" for start, length in long_functions(lines)]
    if "/include/" in name and path.suffix == ".h" and not DOCSTRING.search(text):
        breaches.append(f"{name}: a public header without a docstring")
    return breaches, remarks


def check(root):
    """(breaches, remarks) of a project."""
    breaches, remarks, files = [], [], 0
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in TEXT or not path.is_file() or "__pycache__" in path.parts:
                continue
            files += 1
            new_breaches, new_remarks = check_file(path, str(path.relative_to(root)))
            breaches += new_breaches
            remarks += new_remarks
    if files == 0:
        breaches.append(f"{root}: holds no file to check")
    return breaches, remarks


FUNCTION = ["int f()", "{"] + ["    g();"] * (MOST_LINES_OF_FUNCTION - 2) + ["}"]
RIGHT = {
    "libs/a/include/a.h": "/** Says what. */\nint f();",
    "libs/a/a.cpp": "\n".join(FUNCTION),
    "tests/a.cpp": 'auto folder = mkdtemp("/tmp' + '/a-XXXXXX");\n' + "// nothing TO" + "DOne",
    "libs/a/b.cpp": "\n".join(["namespace a", "{"] + ["int x;"] * (MOST_LINES - 3) + ["}"]),
}
WRONG = {
    "libs/a/include/b.h": ("int f();", "libs/a/include/b.h: a public header without a docstring"),
    "tests/b.cpp": ('open("/wo' + 'rk/x");', "tests/b.cpp:1: a path of one machine"),
    "tests/c.cpp": ('\nopen("/tm' + 'p/x");', "tests/c.cpp:2: a path of one machine"),
    "apps/b.cpp": ("// FIX" + "ME later", "apps/b.cpp:1: unfinished"),
    "tests/d.cpp": ("TEST(A, DISABLED" + "_b)", "tests/d.cpp:1: a test that is switched off or cannot fail"),
    "tests/e.cpp": ("\n" * (MOST_LINES + 1), f"tests/e.cpp: {MOST_LINES + 1} lines, more than {MOST_LINES}"),
}


def findings_in(tree):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, content in tree.items():
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content)
        return check(root)


def self_test():
    breaches, remarks = findings_in(RIGHT)
    failures = [f"right tree: {line}" for line in breaches + remarks]
    if not findings_in({})[0]:
        failures.append("an empty project was not noticed")
    for name, (content, expected) in WRONG.items():
        found = findings_in({**RIGHT, name: content})[0]
        if len(found) != 1 or not found[0].startswith(expected):
            failures.append(f"{name}: expected '{expected}', found {found}")
    longer = "\n".join(FUNCTION[:2] + ["    g();"] + FUNCTION[2:])
    if findings_in({"libs/a.cpp": longer})[1] != [f"libs/a.cpp:1: a function of {MOST_LINES_OF_FUNCTION + 1} lines"]:
        failures.append("a function one line too long was not remarked")
    return failures


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if sys.argv[1] == "--self-test":
        breaches, remarks = self_test(), []
    else:
        breaches, remarks = check(pathlib.Path(sys.argv[1]).resolve())
    for line in remarks:
        print(f"remark: {line}")
    for line in breaches:
        print(line)
    sys.exit(1 if breaches else 0)


if __name__ == "__main__":
    main()
