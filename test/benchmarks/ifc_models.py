#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the IFC files of any number of models: against the EXPRESS schema, and in web-ifc.

    ifc_models.py TOOL FOLDER...

TOOL is pcl_floorplan_ifc, a FOLDER has model.ifc, floorplan.json and solid.ply as pcl_sedr leaves them. A row a
model: errors of the schema check; what web-ifc said; elements that it shows nothing of; spaces, and the largest
difference of a space's volume in web-ifc from that of the solid; openings, those that are hosted and that cut, and
the largest difference of a cut from the volume that wall and opening have in common; the part of a wall or space that
stands in a space. SEDR_DATA names a folder with formats/IFC4_ADD2_TC1.exp; NODE_PATH one with web-ifc. Exit code 1: some
model failed.
"""

import os
import struct
import subprocess
import sys
import tempfile
from collections import defaultdict

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "ifc"))
import step_reader  # noqa: E402
import web_ifc  # noqa: E402
from express_schema import Check, Schema  # noqa: E402

SAME_VOLUME = 0.001  # share of a space's volume
SAME_CUT = 0.005  # share of what an opening should take
IN_SPACE = 0.005  # cubic metres: two fitted faces may cross by millimetres


def solid_volumes(path):
    """Of the rooms of a binary PLY as pcl_sedr writes it, by their numbers."""
    with open(path, "rb") as file:
        header, body = file.read().split(b"end_header\n", 1)
    lines = header.decode().splitlines()
    counts = {line.split()[1]: int(line.split()[2]) for line in lines if line.startswith("element ")}
    vertex = lines[[i for i, line in enumerate(lines) if line.startswith("element vertex")][0] + 1]
    row = "<3%s3B2I" % {"float": "f", "double": "d"}[vertex.split()[1]]
    size = struct.calcsize(row)
    points = [p[:3] for p in struct.iter_unpack(row, body[:size * counts["vertex"]])]
    volumes = defaultdict(float)
    for _, a, b, c, _, room, _, *_ in struct.iter_unpack("<B6i3B", body[size * counts["vertex"]:]):
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = points[a], points[b], points[c]
        volumes[room] += (ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx)) / 6
    return volumes


def check(tool, folder, schema):
    """A row of the table, and what is wrong."""
    path = os.path.join(folder, "model.ifc")
    instances = step_reader.read(path)
    wrong = list(Check(schema, instances).problems)
    errors = len(wrong)
    found = web_ifc.opened(path, with_triangles=True)
    products = found["products"]
    wrong += ["web-ifc: " + text for text in found["said"]]
    lost = web_ifc.lost(instances, products)
    wrong += [name + " is not shown" for name in lost]

    solids = solid_volumes(os.path.join(folder, "solid.ply"))
    off = {k: abs(products["IFCSPACE %d" % k]["volume"] / v - 1) for k, v in solids.items()}
    wrong += ["space %d: %.4f %% off the solid" % (k, 100 * v) for k, v in off.items() if v > SAME_VOLUME]
    spaces = [v[2] for name, v in instances.values() if name == "IFCSPACE"]
    wrong += ["space %s has no solid" % name for name in spaces if int(name) not in solids]

    openings = {n for n, (name, _) in instances.items() if name == "IFCOPENINGELEMENT"}
    hosted = {v[5] for name, v in instances.values() if name == "IFCRELVOIDSELEMENT"}
    wrong += ["opening #%d has no wall" % n for n in openings - hosted]
    with tempfile.TemporaryDirectory() as scratch:  # chords, that the cuts are known
        chords = os.path.join(scratch, "model.ifc")
        subprocess.run([tool, os.path.join(folder, "floorplan.json"), chords, "--ifc-arcs", "faceted"], check=True,
                       capture_output=True)
        cuts = web_ifc.cuts(chords, step_reader.read(chords), web_ifc.opened(chords)["products"])
    worst = 0
    for name, cut, expected in cuts:
        if (expected or cut) <= 0.0001:
            wrong.append("%s: an opening takes nothing" % name)
        elif expected is not None:
            worst = max(worst, abs(cut - expected) / expected)
            if abs(cut - expected) > SAME_CUT * expected + 1e-4:
                wrong.append("%s: openings take %.4f of %.4f m3" % (name, cut, expected))

    inside = web_ifc.within_spaces(products)
    wrong += ["%s stands in %s, %.4f m3 of it" % (name, space, v) for v, name, space in inside if v > IN_SPACE]
    row = [os.path.basename(os.path.dirname(os.path.abspath(path))), errors, len(found["said"]), len(lost), len(spaces),
           "%.4f %%" % (100 * max(off.values(), default=0)), "%d / %d" % (len(openings), len(openings & hosted)),
           "%.2f %%" % (100 * worst), "%.3f m3" % (inside[0][0] if inside else 0)]
    return row, wrong


def main(tool, folders):
    schema = Schema(os.path.join(os.environ.get("SEDR_DATA", ""), "formats", "IFC4_ADD2_TC1.exp"))
    print("| model | schema errors | messages | not shown | spaces | volumes off, at most | openings / hosted "
          "| cuts off, at most | a wall or space within a space |\n|" + "---|" * 9)
    failed = 0
    for folder in folders:
        try:
            row, wrong = check(tool, folder, schema)
        except (OSError, KeyError, ValueError, subprocess.CalledProcessError) as problem:
            row, wrong = [os.path.basename(folder), "-"], ["%s: %r" % (type(problem).__name__, problem)]
        print("| " + " | ".join(map(str, row)) + " |", flush=True)
        for text in wrong:
            print("    " + text, file=sys.stderr, flush=True)
        failed += bool(wrong)
    print("%d of %d models passed" % (len(folders) - failed, len(folders)))
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2:]))
