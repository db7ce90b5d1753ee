#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks how sure pcl_sedr says that walls and openings are right: certainty_grades.py FIRST LAST [options]

Buildings are made, scanned and modelled as by random_buildings.py, odd seeds with the errors of real scans (--measured there);
--scans names folders with a scan and the truth of an IFC model in their place. A wall is right if the median of places all over it is within 5 cm of a true surface that faces the
same way, an opening if a true one of its kind overlaps it by half and all of its edges are within 5 cm (sills of windows
only). Prints, of those said to be so sure, how many are right; then the shares of the area of walls within 1, 3 and 5 cm.
--fit prints the weights that suit these buildings best, those of certainty.cpp are of seeds 70000 to 70042 (of openings 133000 to 133023)
and four scans of IFC models; the odds of walls were then scaled to 18 more, 96100 to 96117.
"""
import json
import pathlib
import tempfile

import numpy as np
from scipy.optimize import minimize

import accuracy_grades
import opening_grades
from buildings import runs
from proving import meshes

STEPS = (0.01, 0.03, 0.05)  # metres
BINS = (0, 0.5, 0.7, 0.9, 0.97, 1)
RIDGE = 0.5


def wall_errors(plan, mesh):
    """How far each wall is off, by its number; infinite if there is none."""
    errors = {}
    for room in plan["rooms"]:
        for k, e in enumerate(room["boundary"]):
            offs = []
            for wall in accuracy_grades.walls_of({"boundary": [e], "columns": []}):
                places, normal = accuracy_grades.places_on(room, *wall[1:])
                offs.append(abs(accuracy_grades.middle_error(mesh, places + plan.get("origin", np.zeros(3)), normal)))
            errors[f"{room['id']}.{k + 1}"] = np.inf if not offs or np.isnan(offs).any() else max(offs)
    return errors


def opening_errors(true, path):
    """How far the edges of each opening are off, by its number; infinite if there is none of its kind."""
    found = opening_grades.found_openings(path)
    errors = [np.inf] * len(found)
    for i, j in opening_grades.pairs(true, found):
        if true[i]["kind"] == found[j]["kind"]:
            errors[j] = np.abs(opening_grades.edges(true[i], found[j])[0])[[0, 1, 2, 3] if true[i]["kind"] == "window" else [0, 1, 3]].max()
    return errors


def ifc_openings(folder):
    """Openings of truth_openings.json, as opening_grades.true_openings() has them."""
    found = []
    for o in json.loads((folder / "truth_openings.json").read_text(encoding="utf-8"))["openings"]:
        middle, way = np.array(o["centre"][:2]), np.array(o["direction"]) * o["width"] / 2
        found.append(dict(o, a=middle - way, b=middle + way, top=o["bottom"] + o["height"]))
    return found


def graded(folder, mesh, true):
    """(said, error, area, signs) of the walls and of the openings of folder/out, and the names of signs."""
    report = json.loads((folder / "out/report.json").read_text(encoding="utf-8"))
    plan = json.loads((folder / "out/floorplan.json").read_text(encoding="utf-8"))
    found = {}
    for kind, errors in (("walls", wall_errors(plan, mesh)), ("openings", None)):
        table = report["certainty"][kind]
        errors = errors or dict(zip((o["number"] for o in report["openings"]), opening_errors(true, folder / "out/floorplan.json")))
        found[kind] = table["columns"][5:], [(row[2:5], errors[row[0]], row[1], row[5:]) for row in table["rows"]]
    return found


def table(kind, rows):
    said, errors, area = (np.array([r[k] for r in rows]) for k in (0, 1, 2))
    right = errors[:, None] <= STEPS
    lines = [f"| {kind}: said to be right | number | mean of said | right |", "|---|---|---|---|"]
    for low, high in zip(BINS, BINS[1:]):
        mine = (said[:, 2] >= low) & (said[:, 2] < high)
        if mine.any():
            lines.append(f"| {100 * low:.0f} to {100 * high:.0f} % | {mine.sum()} | {100 * said[mine, 2].mean():.1f} % | {100 * right[mine, 2].mean():.1f} % |")
    shares = (np.average(what, axis=0, weights=area) for what in (said, right))
    lines += [f"of the area of {kind} within 1, 3, 5 cm: said " + "; in truth ".join(", ".join(f"{100 * s:.1f} %" for s in share) for share in shares)]
    return "\n".join(lines)


def fitted(names, rows):
    """Weights of an ordered logistic model of errors, beside the standard errors that are stated."""
    signs = np.array([r[3] for r in rows], float)
    step = np.searchsorted(STEPS, [r[1] for r in rows])

    def unpacked(p):
        return np.cumsum([p[0], *np.exp(p[1:3])]), p[3:]

    def cost(p):
        steps, weights = unpacked(p)
        within = 1 / (1 + np.exp(-steps - (signs @ weights)[:, None]))
        shares = np.diff(within, axis=1, prepend=0, append=1)
        return -np.log(shares[np.arange(len(step)), step] + 1e-12).sum() + RIDGE * (weights ** 2).sum()
    steps, weights = unpacked(minimize(cost, np.array([0, -2, -2] + [0] * len(names), float), method="BFGS").x)
    return "{" + ", ".join(f"{s:.2f}" for s in steps) + "}, {" + ", ".join(f'{{"{n}", {w:.2f}}}' for n, w in zip(names, weights)) + "}"


def main():
    parser = runs.parser(__doc__, "buildings")
    parser.add_argument("--fit", action="store_true", help="print weights")
    parser.add_argument("--scans", type=pathlib.Path, nargs="*", help="folders with scan.pcd, truth_spaces.ply and truth_openings.json")
    options = parser.parse_args()
    found = {"walls": ([], []), "openings": ([], [])}

    def take(folder, mesh, true):
        if (folder / "out/report.json").exists():
            for kind, (names, rows) in graded(folder, mesh, true).items():
                found[kind] = names, found[kind][1] + rows

    def one_building(seed, folder, options):
        row = runs.building(seed, folder, options, seed % 2)
        take(folder, meshes.read_mesh(folder / "truth.ply"), opening_grades.true_openings(folder))
        return row

    def summary(_):
        return "\n".join((f"{kind}: {fitted(names, rows)}\n" if options.fit else "") + table(kind, rows) for kind, (names, rows) in found.items())

    if options.scans:
        for scan in options.scans:
            with tempfile.TemporaryDirectory(dir=options.folder) as folder:
                folder = pathlib.Path(folder)
                (folder / "scan.pcd").symlink_to(scan.resolve() / "scan.pcd")
                runs.model(folder, options)
                take(folder, meshes.read_mesh(scan / "truth_spaces.ply"), ifc_openings(scan))
        print(summary(None))
    else:
        runs.all_seeds(options, [], one_building, summary)


if __name__ == "__main__":
    main()
