#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the standard errors that pcl_sedr states against the truth of random buildings: accuracy_grades.py FIRST LAST [options]

Buildings are made, scanned and modelled as by random_buildings.py. The error of a wall, floor or ceiling is its
distance from the true surface that faces the same way, the median of places all over it; what is more than 5 cm off is another
surface: a gross error, counted apart. Those of the edges of an opening are along and up its wall, by what was seen of them. Prints a line a kind: how many were
measured, their errors and standard errors (medians, mm), shares of errors within 1, 2 and 3 standard errors.
"""
import json

import numpy as np

import opening_grades
from buildings import grades, runs
from proving import meshes

FAR = 0.05     # metres: another surface
ALIKE = 0.95   # cosine of the angle between surfaces that face the same way
PLACES = np.array([0.15, 0.3, 0.5, 0.7, 0.85])  # shares of the length and height of a wall


def distances(mesh, places, normal):
    """From each place along the normal to the nearest triangle that faces the same way; NaN if none is near."""
    a, b, c = (mesh.corners[:, k] for k in range(3))
    across = np.cross(b - a, c - a)
    toward = across @ normal / np.maximum(np.linalg.norm(across, axis=1), 1e-12)
    is_alike = np.abs(toward) > ALIKE
    low, high = mesh.corners.min(1) - FAR, mesh.corners.max(1) + FAR
    found = np.full(len(places), np.nan)
    for k, p in enumerate(places):
        near = is_alike & (low <= p).all(1) & (p <= high).all(1)
        n = across[near]
        t = ((a[near] - p) * n).sum(1) / (n @ normal)
        at = p + t[:, None] * normal
        is_in = np.ones(len(n), bool)
        for u, v in ((a, b), (b, c), (c, a)):
            is_in &= (np.cross(v[near] - u[near], at - u[near]) * n).sum(1) >= 0
        t = t[is_in & (np.abs(t) < FAR)]
        if len(t):
            found[k] = t[np.abs(t).argmin()]
    return found


def middle_error(mesh, places, normal):
    """The median distance, if most places have one."""
    found = distances(mesh, places, normal)
    seen = found[~np.isnan(found)]
    return float(np.median(seen)) if len(seen) > len(places) / 2 else np.nan


def walls_of(room):
    """Kind, element, places on it and its normal."""
    for kind, loop in [("walls", room["boundary"])] + [("columns", c) for c in room["columns"]]:
        for e in loop:
            points = grades.loop_points([e, dict(e, type="segment", start=e["end"])])
            steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
            at = np.concatenate([[0], np.cumsum(steps)])
            if at[-1] < 1e-6:
                continue
            for k in (0.5,) if e["type"] == "segment" else (0.25, 0.5, 0.75):
                i = min(np.searchsorted(at, k * at[-1]) - 1, len(steps) - 1)
                way = (points[i + 1] - points[i]) / steps[i]
                yield kind if e["type"] == "segment" else "arcs", e, points, at, k, way


def places_on(room, e, points, at, k, way):
    """Places on a wall that walls_of() yields, and its normal."""
    plan_places = [[np.interp(s * at[-1], at, points[:, axis]) for axis in (0, 1)]
                   for s in (PLACES if e["type"] == "segment" else (k,))]
    left = np.array([-way[1], way[0]])
    tilt = np.radians(e.get("tilt", 0))
    foot = grades.z_at(room["floor"], *plan_places[len(plan_places) // 2])
    places = [[*(np.array(p) + left * np.tan(tilt) * s * room["height"]), foot + s * room["height"]] for p in plan_places for s in PLACES]
    return np.array(places), np.array([*(left * np.cos(tilt)), -np.sin(tilt)])


def surfaces(plan):
    """(kind, accuracy, places, normal) of all that was measured."""
    for room in plan["rooms"]:
        for kind, e, *place in walls_of(room):
            if "accuracy" in e:
                yield (kind, e["accuracy"], *places_on(room, e, *place))
        for kind, slab, loop in [("floors", room["floor"], room["boundary"]), ("ceilings", room["ceiling"], room["boundary"])] + \
                [("parts of floors", d["slab"], d["boundary"]) for d in room["floor_details"]] + \
                [("parts of ceilings", d["slab"], d["boundary"]) for d in room["details"] + room.get("facets", [])]:
            if "accuracy" not in slab or slab.get("type", "plane") != "plane":
                continue
            outline = grades.loop_points(loop)
            low, high = outline.min(0), outline.max(0)
            grid = np.stack(np.meshgrid(*(np.linspace(low[k], high[k], 9)[1:-1] for k in (0, 1))), -1).reshape(-1, 2)
            grid = grid[grades.within(outline, grid)]
            if len(grid):
                places = np.array([[x, y, grades.z_at(slab, x, y)] for x, y in grid])
                yield kind, slab["accuracy"], places, np.array(slab["plane"][:3])


def errors_of(folder, plan):
    """[kind, error, standard error, 95 % of deviations, normal, place] of all that was measured; error NaN: gross."""
    mesh = meshes.read_mesh(folder / "truth.ply")
    found = json.loads((folder / plan).read_text(encoding="utf-8"))
    origin = np.array(found.get("origin", [0, 0, 0]), float)
    rows = []
    for kind, accuracy, places, normal in surfaces(found):
        places = places + origin
        rows.append([kind, -middle_error(mesh, places, normal), accuracy["standard_error"], accuracy.get("deviation_95", np.nan), normal,
                     places.mean(0)])
    true = opening_grades.true_openings(folder)
    openings = opening_grades.found_openings(folder / plan)
    for i, j in opening_grades.pairs(true, openings):
        stated = openings[j]["edges"]
        if (true[i]["b"] - true[i]["a"]) @ (openings[j]["b"] - openings[j]["a"]) < 0:
            stated = [stated[1], stated[0], *stated[2:]]
        for kind, error, edge in zip(("jambs", "jambs", "sills", "heads"), opening_grades.edges(true[i], openings[j])[0], stated):
            if kind == "sills" and true[i]["kind"] != "window":
                continue
            rows.append([f"{kind}, {edge['seen']}", error, edge["error"], np.nan, np.zeros(3), np.zeros(3)])
    return rows


def without_datum(rows):
    """The errors without the motion of the whole plan, in x, y, z and about z, that fits them best: a scan has no other place."""
    use = [r for r in rows if r[0] in ("walls", "floors", "ceilings") and not np.isnan(r[1])]
    if len(use) < 6:
        return rows
    middle = np.mean([r[5] for r in use], axis=0)

    def row(r):
        n, p = r[4], r[5] - middle
        return np.array([n[0], n[1], n[2], p[0] * n[1] - p[1] * n[0]])
    design, errors = np.array([row(r) for r in use]), np.array([r[1] for r in use])
    weights = np.ones(len(use))
    for _ in range(20):  # robust: least absolute errors
        motion = np.linalg.lstsq(design * weights[:, None], errors * weights, rcond=None)[0]
        weights = 1 / np.sqrt(np.maximum(np.abs(errors - design @ motion), 1e-4))
    return [[r[0], r[1] - row(r) @ motion, *r[2:]] for r in rows]


def table(rows):
    lines = ["| kind | measured | gross errors | error, mm | standard error, mm | within 1 | 2 | 3 |", "|---|---|---|---|---|---|---|---|"]
    for kind in dict.fromkeys(r[0] for r in rows):
        mine = np.array([r[1:3] for r in rows if r[0] == kind], float)
        right = mine[~np.isnan(mine[:, 0])]
        z = np.abs(right[:, 0]) / right[:, 1]
        lines.append(f"| {kind} | {len(mine)} | {len(mine) - len(right)} | {1000 * np.median(np.abs(right[:, 0])):.2f} | "
                     f"{1000 * np.median(right[:, 1]):.2f} | " + " | ".join(f"{100 * np.mean(z <= k):.0f} %" for k in (1, 2, 3)) + " |")
    return "\n".join(lines)


def main():
    parser = runs.parser(__doc__, "buildings")
    parser.add_argument("--measured", action="store_true",
                        help="points with the errors of real scans, see random_buildings.py; what moves a whole plan is taken out")
    found = []

    def one_building(seed, folder, options):
        row = runs.building(seed, folder, options, options.measured)
        mine = errors_of(folder, "out/floorplan.json") if (folder / "out/floorplan.json").exists() else []
        found.extend(without_datum(mine) if options.measured else mine)
        return dict(row, surfaces=len(mine))

    runs.all_seeds(parser.parse_args(), [], one_building, lambda _: table(found))


if __name__ == "__main__":
    main()
