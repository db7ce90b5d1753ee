#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Priors: the page, and the numbers that are not among them.

    priors.py ROOT            checks the three promises below
    priors.py ROOT --write    writes doc/priors.md

1. Every number of Priors has a line in the table of priors.cpp, in the same order, and
   its default is within its range.
2. A source of the library names each number and each common threshold of the stages:
   none is accepted and does nothing.
3. There are at most MOST_NUMBERS named numbers of sedr_segmentation outside the
   structure: what is believed of buildings or scanners belongs into it.
doc/priors.md is what the first makes.
"""
import collections
import os
import re
import sys

HEADER = "sedr_filters/include/pcl/sedr_filters/priors.h"
THRESHOLDS = "sedr_filters/include/pcl/sedr_filters/impl/stage_thresholds.h"
TABLE = "sedr_filters/src/base/priors.cpp"
PAGE = "doc/priors.md"
MOST_NUMBERS = 300  # lower it when there are fewer
MODULES = ("sedr_filters", "sedr_segmentation", "sedr_surface")
NUMBER = (r"(?:double|float|int|unsigned(?: int)?|std::u?int(?:8|16|32|64)_t|std::size_t|"
          r"std::ptrdiff_t|Eigen::Index|auto)")
CONSTANT = re.compile(r"^\s*(?:inline\s+|static\s+)*constexpr\s+(?:unsigned\s+)?" + NUMBER +
                      r"\s+(\w+)\s*(?:=|\{)")

TITLES = {
    "rooms": "Rooms and buildings", "walls": "Walls and what is in them",
    "slabs": "Ceilings and floors", "furniture": "Furniture", "scanner": "Scanners",
}


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def members(root):
    """Name, default and meaning of every number of Priors, in order."""
    body = read(root, HEADER).split("struct Priors : StageThresholds {", 1)[1].split("\n};", 1)[0]
    body = re.sub(r"\n\s+///<\s*", " ", body)
    return [(name, float(value), meaning.strip()) for name, value, meaning in
            re.findall(r"^  double (\w+) =\s*([^;]+);\s*///<\s*(.*)$", body, re.M)]


def table(root):
    """The lines of the table: name, group, unit, low, high, source."""
    text = re.sub(r"\s*\n\s*", " ", read(root, TABLE))
    text = re.sub(r'"\s+"', "", text)
    return [(name, group, unit, float(low), float(high), source)
            for name, member, group, unit, low, high, source in re.findall(
                r'\{"(\w+)", &Priors::(\w+), "(\w+)", "([^"]*)", ([-+.\de]+), ([-+.\de]+), '
                r'"([^"]*)"\}', text) if name == member]


def sources(root, module):
    for folder, _, files in os.walk(os.path.join(root, module)):
        for file in sorted(files):
            if file.endswith((".h", ".hpp", ".cpp")):
                yield os.path.relpath(os.path.join(folder, file), root)


def used_in(root):
    """The numbers that a source names."""
    return {name for module in MODULES for path in sources(root, module) if path not in (HEADER, THRESHOLDS, TABLE)
            for name in re.findall(r"[pP]riors(?:(?:_|\(\))?\.|::)(\w+)", read(root, path))}


def page(root):
    known = {line[0]: line for line in table(root)}
    text = """<!-- SPDX-License-Identifier: BSD-3-Clause -->
<!-- Written by test/contract/priors.py --write; a test compares it with the sources. -->
# Priors

What is believed of buildings, furniture and scanners before a scan is looked at: `pcl::sedr::Priors`
(`<pcl/sedr_filters/priors.h>`), set by `reconstruction.setPriors(priors)`, or on the command line:

```
pcl_sedr scan.pcd model --prior max_wall=0.9,min_headroom=2
```

`report.json` holds the values in use and their sources. A value out of its range is refused with the range.
"""
    group = None
    for name, value, meaning in members(root):
        line = known[name]
        if line[1] != group:
            group = line[1]
            text += "\n## " + TITLES[group] + "\n\n| name | default | meaning |\n|---|---|---|\n"
        text += "| `%s` | %g %s | %s |\n" % (name, value, line[2], meaning)
    return text


def counted(root):
    """How many named numbers each folder of sedr_segmentation has outside Priors."""
    counts = collections.Counter()
    for path in sources(root, "sedr_segmentation"):
        folder = re.search(r"/src/(\w+)/", path)
        for line in read(root, path).split("\n"):
            if CONSTANT.match(line):
                counts[folder.group(1) if folder else "include"] += 1
    return counts


def problems(root):
    found = []
    in_header = members(root)
    in_table = table(root)
    if [m[0] for m in in_header] != [t[0] for t in in_table]:
        different = set(m[0] for m in in_header) ^ set(t[0] for t in in_table)
        found.append("priors.h and the table of priors.cpp differ: " +
                     (", ".join(sorted(different)) or "in order"))
        return found
    used = used_in(root)
    for (name, value, _), line in zip(in_header, in_table):
        if not line[3] <= value <= line[4]:
            found.append("%s = %g is not from %g to %g" % (name, value, line[3], line[4]))
    for name in [m[0] for m in in_header] + re.findall(r"static constexpr double (\w+) =", read(root, THRESHOLDS)):
        if name not in used:
            found.append("no source names %s" % name)
    if read(root, PAGE) != page(root):
        found.append(PAGE + " is not what the sources say: run priors.py ROOT --write")
    count = sum(counted(root).values())
    if count > MOST_NUMBERS:
        found.append("%d named numbers in sedr_segmentation, %d are allowed: what is believed of buildings or "
                     "scanners belongs into Priors; most are in %s" % (
                         count, MOST_NUMBERS, ", ".join(f for f, _ in counted(root).most_common(3))))
    return found


if __name__ == "__main__":
    if sys.argv[2:] == ["--write"]:
        with open(os.path.join(sys.argv[1], PAGE), "w", encoding="utf-8") as file:
            file.write(page(sys.argv[1]))
    FOUND = problems(sys.argv[1])
    print("\n".join(FOUND) or "%d priors, %d named numbers beside them" %
          (len(members(sys.argv[1])), sum(counted(sys.argv[1]).values())))
    sys.exit(1 if FOUND else 0)
