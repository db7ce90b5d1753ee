#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that no two types have the same qualified name: the linker would take either.

Usage: names.py SOURCE_DIR. Types of unnamed namespaces and within types are their own.
"""
import collections
import pathlib
import re
import sys

TYPE = r"(?:struct|enum class|class|enum) (\w+)(?![\w<:]).*(?:\{|[^;]$)"


def types_of(text):
    """Returns the qualified names of types that a file defines in named namespaces."""
    inside, names = [], []
    for line in text.splitlines():
        if opened := re.match(r"namespace ?([\w:]*) \{", line):
            inside.append(opened[1])
        elif line.startswith("} // namespace"):
            inside.pop()
        elif defined := re.match(TYPE, line):
            if inside and all(inside):
                names.append("::".join([*inside, defined[1]]))
    return names


def main(root):
    files = collections.defaultdict(list)
    for module in ("sedr_filters", "sedr_segmentation", "sedr_surface", "tools"):
        for path in sorted((root / module).rglob("*.[hc]*")):
            if path.suffix in (".h", ".hpp", ".cpp"):
                for name in types_of(path.read_text()):
                    files[name].append(str(path.relative_to(root)))
    twice = {name: where for name, where in files.items() if len(where) > 1}
    for name, where in sorted(twice.items()):
        print(f"{name} is defined in {' and '.join(where)}")
    if not files:
        print("no types were found")
    return 1 if twice or not files else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
