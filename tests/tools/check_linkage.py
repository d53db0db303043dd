#!/usr/bin/python3
"""Fails when a program or library is linked, directly or not, with a window toolkit, or with something missing.

    check_linkage.py FILE...
    check_linkage.py --self-test

Standard library only.
"""
import re
import subprocess
import sys

WINDOWS = re.compile(r"^\s*lib(wx_|gtk|gdk-|Qt)\S*", re.IGNORECASE)


def complaints_about(name, listing):
    """What is wrong with the output of ldd for a file."""
    lines = listing.splitlines()
    complaints = [f"{name}: needs {line.split()[0]}, which is missing" for line in lines if "not found" in line]
    complaints += [f"{name}: links {line.split()[0]}" for line in lines if WINDOWS.match(line)]
    if not any("libc.so" in line for line in lines):
        complaints.append(f"{name}: ldd lists no C library; is it a dynamic program or library?")
    return complaints


def self_test():
    c_library = "\tlibc.so.6 => /lib/libc.so.6 (0x1)\n"
    cases = [
        (c_library, []),
        (c_library + "\tlibgdk_pixbuf-2.0.so.0 => /lib/libgdk_pixbuf-2.0.so.0 (0x1)\n", []),
        (c_library + "\tlibQt5Core.so.5 => /lib/libQt5Core.so.5 (0x1)\n", ["a: links libQt5Core.so.5"]),
        (c_library + "\tlibwx_gtk3u_core-3.2.so.0 => /x (0x1)\n", ["a: links libwx_gtk3u_core-3.2.so.0"]),
        (c_library + "\tlibgtk-3.so.0 => /x (0x1)\n", ["a: links libgtk-3.so.0"]),
        (c_library + "\tlibx.so => not found\n", ["a: needs libx.so, which is missing"]),
        ("\tstatically linked\n", ["a: ldd lists no C library; is it a dynamic program or library?"]),
    ]
    return [f"{listing!r}: found {complaints_about('a', listing)}" for listing, expected in cases
            if complaints_about("a", listing) != expected]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if sys.argv[1] == "--self-test":
        complaints = self_test()
    else:
        complaints = []
        for name in sys.argv[1:]:
            done = subprocess.run(["ldd", name], capture_output=True, text=True, check=False)
            complaints += complaints_about(name, done.stdout)
    for line in complaints:
        print(line)
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
