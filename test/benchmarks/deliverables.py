#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Opens the drawings and models of any number of results in the programs of others.

    deliverables.py BIN FOLDER...

BIN is the folder of the programs, a FOLDER has floorplan.json as pcl_sedr leaves it. A row a result: errors and
repairs of ezdxf's audit, and pages, of the DXF; PDFs of which pdftoppm draws every page, not white; issues of Khronos' validator
and what three.js said of the GLB. A dash stands for what is not there: ezdxf, pdftoppm, or in NODE_PATH
gltf-validator and three. Exit code 1: some result failed.
"""

import glob
import json
import os
import shutil
import subprocess
import sys
import tempfile

GLB = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tools", "report", "glb_in_node.mjs")

MIN_DARK = 0.002  # of a page that is drawn


def run(*arguments):
    return subprocess.run(arguments, capture_output=True, text=True, check=True).stdout


def audit(folder):
    try:
        import ezdxf
    except ImportError:
        return "-", []
    audits = [ezdxf.readfile(path).audit() for path in sorted(glob.glob(folder + "/*.dxf"))]
    problems = [str(e.message) for a in audits for e in a.errors + a.fixes]
    return "%d / %d" % (len(problems), len(audits)), problems if audits else ["no DXF"]


def dark_share(path):
    """The share of pixels of a PGM that are not white."""
    with open(path, "rb") as file:
        content = file.read()
    magic, width, height, white, rest = content.split(maxsplit=4)
    assert magic == b"P5" and white == b"255"
    pixels = content[-int(width) * int(height):]
    return 1 - pixels.count(255) / len(pixels)


def pages(folder):
    if not shutil.which("pdftoppm"):
        return "-", []
    paths = sorted(glob.glob(folder + "/*.pdf"))
    drawn = 0
    for path in paths:
        run("pdftoppm", "-r", "30", "-gray", path, path[:-4])
        sheets = glob.glob(path[:-4] + "-*.pgm")
        drawn += bool(sheets) and all(dark_share(sheet) > MIN_DARK for sheet in sheets)
    return "%d / %d" % (drawn, len(paths)), [] if drawn == len(paths) > 0 else ["a PDF is not drawn"]


def glb(folder):
    try:
        found = json.loads(run("node", GLB, folder + "/model.glb"))
    except (OSError, subprocess.CalledProcessError) as problem:
        text = getattr(problem, "stderr", "") or str(problem)
        return ("-", []) if "MODULE_NOT_FOUND" in text or isinstance(problem, OSError) else ("failed", [text])
    issues = found["issues"]["messages"]
    return "%d / %d" % (len(issues), len(found["said"])), [str(m) for m in issues + found["said"]]


def checked(program, plan, folder, name, check):
    try:
        run(program, plan, folder + name)
        return check(folder)
    except (OSError, ValueError, AssertionError, subprocess.CalledProcessError) as problem:
        return "failed", [name[1:] + ": " + str(problem) + (getattr(problem, "stderr", "") or "")]


def main(bin_folder, folders):
    print("| result | DXF: errors / files | PDF: drawn / files | GLB: issues / messages |\n|" + "---|" * 4)
    failed = 0
    for result in folders:
        with tempfile.TemporaryDirectory() as folder:
            plan = os.path.join(result, "floorplan.json")
            texts, wrong = zip(*(checked(bin_folder + program, plan, folder, name, check) for program, name, check in (
                ("/pcl_floorplan_drawing", "/floorplan.dxf", audit), ("/pcl_floorplan_drawing", "/floorplan.pdf", pages),
                ("/pcl_floorplan_extrusion", "/model.glb", glb))))
        print("| %s | %s |" % (os.path.basename(os.path.abspath(result)), " | ".join(texts)), flush=True)
        wrong = sum(wrong, [])
        for text in wrong:
            print("    " + text, file=sys.stderr, flush=True)
        failed += bool(wrong)
    print("%d of %d results passed" % (len(folders) - failed, len(folders)))
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2:]))
