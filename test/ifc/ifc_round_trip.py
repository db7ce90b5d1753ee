#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How much of a building comes back when its model was scanned and reconstructed: spaces and walls of an
IFC file that SEDR wrote against the truth of the scan, as a table.

    ifc_round_trip.py MODEL.ifc TRUTH_DIR

TRUTH_DIR has truth_spaces.json: `rooms`, and `spaces` where rooms without a wall between them are parted. Such
spaces may be one room or several: of all ways to put them together the one counts that more of the model agrees
with. True walls are those of the rooms.
"""

import json
import math
import os
import sys
from statistics import median

import step_reader

CELL = 0.05  # metres, of the raster that plans are compared on
SAME_SPACE = 0.5  # share of two plans' union that both have
ON_FACE = 0.05  # metres between a true and a found face of a wall
THICKEST = 0.6  # metres, of a wall
STEP = 0.05  # metres between places along a wall


class Model:
    """The instances of a file, and what hangs on them."""

    def __init__(self, path):
        self.instances = step_reader.read(path)
        self.sets = {}
        for name, v in self.instances.values():
            if name == "IFCRELDEFINESBYPROPERTIES":
                for n in v[4]:
                    self.sets.setdefault(n, {}).update(self.values(v[5]))

    def of(self, kind):
        return [(n, v) for n, (name, v) in self.instances.items() if name == kind]

    def get(self, n):
        return self.instances[n]

    def values(self, n):
        name, v = self.get(n)
        parts = [self.get(p)[1] for p in v[5 if name == "IFCELEMENTQUANTITY" else 4]]
        return {p[0]: p[3] if name == "IFCELEMENTQUANTITY" else p[2].value for p in parts}

    def point(self, n):
        return self.get(n)[1][0]

    def frame(self, n):
        """Origin, x and y of an IfcLocalPlacement in plan, and its height."""
        parent, axes = self.get(n)[1]
        origin, _, along = self.get(axes)[1]
        p = self.point(origin)
        x = self.point(along)[:2] if along is not None else (1, 0)
        if parent is None:
            return p[:2], x, p[2]
        (a, b), (u, v), z = self.frame(parent)
        return ((a + u * p[0] - v * p[1], b + v * p[0] + u * p[1]), (u * x[0] - v * x[1], v * x[0] + u * x[1]),
                z + p[2])

    def placed(self, frame, point):
        (a, b), (u, v), _ = frame
        return a + u * point[0] - v * point[1], b + v * point[0] + u * point[1]

    def body(self, shape):
        for s in self.get(shape)[1][2]:
            values = self.get(s)[1]
            if values[1] == "Body":
                return values[3][0]
        return None

    def outlines(self, n, frame):
        """Loops in plan of a body: of a swept one its profile's, of triangles those that face down."""
        name, v = self.get(n)
        if name == "IFCEXTRUDEDAREASOLID":
            curve_name, curve = self.get(self.get(v[0])[1][2])
            points = [self.point(p) for p in curve[0]] if curve_name == "IFCPOLYLINE" else self.get(curve[0])[1][0]
            return [[self.placed(frame, p) for p in points]]
        points = self.get(v[0])[1][0]
        loops = []
        for triangle in v[3]:
            a, b, c = (points[i - 1] for i in triangle)
            if (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < -1e-9:
                loops.append([self.placed(frame, p) for p in (a, b, c)])
        return loops


def edges_of(loops):
    return [(a, b) for loop in loops for a, b in zip(loop, loop[1:] + loop[:1]) if a != b]


def cells_of(loops, union=False):
    """Cells of a raster whose middle is within loops: by even and odd, or within any of them."""
    if union:
        return set().union(*(cells_of([loop]) for loop in loops)) if loops else set()
    cells = set()
    ys = [p[1] for loop in loops for p in loop]
    for row in range(math.floor(min(ys) / CELL), math.ceil(max(ys) / CELL)):
        y = (row + 0.5) * CELL
        crossings = sorted(a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
                           for a, b in edges_of(loops) if (a[1] > y) != (b[1] > y))
        for low, high in zip(crossings[::2], crossings[1::2]):
            cells.update((column, row) for column in
                         range(math.ceil(low / CELL - 0.5), math.floor(high / CELL - 0.5) + 1))
    return cells


def true_space(room):
    loops = [loop for ring in room["plan"] for loop in [ring["exterior"], *ring["holes"]]]
    loops = [[tuple(p) for p in loop] for loop in loops]
    return {"name": room["name"], "cells": cells_of(loops), "loops": loops, "area": room["area"],
            "volume": room["volume"], "low": room["floor"], "high": room["ceiling"]}


def found_spaces(model):
    spaces = []
    for n, v in model.of("IFCSPACE"):
        frame = model.frame(v[5])
        body = model.body(v[6])
        loops = model.outlines(body, frame)
        values = model.sets[n]
        swept = model.get(body)[0] == "IFCEXTRUDEDAREASOLID"
        spaces.append({"name": v[2], "cells": cells_of(loops, union=not swept), "area": values["NetFloorArea"],
                       "volume": values["NetVolume"], "low": v[10], "high": v[10] + values["Height"]})
    return spaces


def share_heights(a, b):
    both = min(a["high"], b["high"]) - max(a["low"], b["low"])
    return both > 0.5 * min(a["high"] - a["low"], b["high"] - b["low"])


def matches(true, found):
    """Pairs that agree in plan, the best first, each space in one."""
    ranked = []
    for i, t in enumerate(true):
        for j, f in enumerate(found):
            if share_heights(t, f) and t["cells"] & f["cells"]:
                ranked.append((len(t["cells"] & f["cells"]) / len(t["cells"] | f["cells"]), i, j))
    pairs, taken = [], (set(), set())
    for share, i, j in sorted(ranked, reverse=True):
        if share >= SAME_SPACE and i not in taken[0] and j not in taken[1]:
            taken[0].add(i), taken[1].add(j)
            pairs.append((i, j, share))
    return pairs


def partitions(parts):
    """All ways to put things into groups."""
    if not parts:
        yield []
        return
    for groups in partitions(parts[1:]):
        yield [[parts[0]], *groups]
        for k, group in enumerate(groups):
            yield [*groups[:k], [parts[0], *group], *groups[k + 1:]]


def together(spaces):
    """Spaces without a wall between them as one."""
    return {"name": " + ".join(s["name"] for s in spaces), "cells": set().union(*(s["cells"] for s in spaces)),
            "area": sum(s["area"] for s in spaces), "volume": sum(s["volume"] for s in spaces),
            "low": min(s["low"] for s in spaces), "high": max(s["high"] for s in spaces)}


def scanned_rooms(truth):
    return [room for room in truth["rooms"] if room["scanned"] and not room["shaft"]]


def readings(truth, found):
    """The true spaces: each room as one, or in the parts that more of the model agrees with."""
    parts = {p["id"]: p for p in truth["spaces"]}
    spaces = []
    for room in scanned_rooms(truth):
        ways = [[true_space(room)]]
        pieces = [true_space(parts[k]) for k in room["space_ids"] if k in parts]
        if len(pieces) > 1:
            ways += [[together(group) for group in groups] for groups in partitions(pieces) if len(groups) > 1]
        spaces += max(ways, key=lambda way: sum(p[2] * len(way[p[0]]["cells"]) for p in matches(way, found)))
    return spaces


def faces_of(loops, frame, assumed):
    """The sides of a wall that rooms see: along the x of its placement; on it, if one side was not seen."""
    (a, b), (u, v), _ = frame
    faces = []
    for p, q in edges_of(loops):
        along = abs((q[0] - p[0]) * u + (q[1] - p[1]) * v)
        across = [(x - a) * -v + (y - b) * u for x, y in (p, q)]
        is_hidden = assumed and len(loops[0]) <= 5 and max(map(abs, across)) > 0.001
        if abs(across[1] - across[0]) < 0.5 * along and not is_hidden:
            faces.append((p, q))
    return faces


def found_walls(model):
    walls = []
    for n, v in model.of("IFCWALL"):
        frame = model.frame(v[5])
        values = model.sets[n]
        assumed = values["ThicknessAssumed"] == "T"
        walls.append({"name": v[2], "edges": faces_of(model.outlines(model.body(v[6]), frame), frame, assumed),
                      "low": frame[2], "high": frame[2] + values["Height"], "width": values["Width"],
                      "assumed": assumed})
    return [w for w in walls if w["edges"]]


def distance(p, edge):
    (ax, ay), (bx, by) = edge
    along = ((p[0] - ax) * (bx - ax) + (p[1] - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2)
    along = min(1, max(0, along))
    return math.hypot(p[0] - ax - along * (bx - ax), p[1] - ay - along * (by - ay))


def is_along(edge, out):
    """Whether a face runs along one whose way out is given, within 30 degrees."""
    (ax, ay), (bx, by) = edge
    return abs((bx - ax) * out[0] + (by - ay) * out[1]) <= 0.5 * math.dist((ax, ay), (bx, by))


def places_on(space):
    """Places along the walls of a space, and the way out of it."""
    for a, b in edges_of(space["loops"]):
        length = math.dist(a, b)
        count = int(length / STEP)
        for k in range(count):
            share = (k + 0.5) / count
            place = (a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]))
            out = ((b[1] - a[1]) / length, (a[0] - b[0]) / length)
            inside = (math.floor((place[0] + CELL * out[0]) / CELL), math.floor((place[1] + CELL * out[1]) / CELL))
            yield place, out if inside not in space["cells"] else (-out[0], -out[1])


def true_thickness(place, out, space, spaces):
    """To the face of another space behind the wall; None where none is near."""
    for k in range(1, int(THICKEST / 0.01)):
        p = (place[0] + 0.01 * k * out[0], place[1] + 0.01 * k * out[1])
        cell = (math.floor(p[0] / CELL), math.floor(p[1] / CELL))
        if any(cell in s["cells"] and s is not space and share_heights(s, space) for s in spaces):
            return min(distance(place, e) for s in spaces if s is not space and cell in s["cells"]
                       for e in edges_of(s["loops"]))
    return None


def compare_walls(spaces, walls):
    """Metres of true walls, of those with a wall in the model, and errors of thickness."""
    whole, met, errors, hit = 0, 0, [], set()
    for space in spaces:
        near = [w for w in walls if share_heights(w, space)]
        for place, out in places_on(space):
            whole += 1
            at = [w for w in near if any(is_along(e, out) and distance(place, e) <= ON_FACE for e in w["edges"])]
            if not at:
                continue
            met += 1
            hit.update(w["name"] for w in at)
            thickness = true_thickness(place, out, space, spaces)
            paired = [w for w in at if not w["assumed"]]
            if thickness is not None and paired:
                errors.append(min(abs(w["width"] - thickness) for w in paired))
    return {"metres": whole * STEP, "met": met * STEP, "errors": errors, "hit": hit}


def figures(path, folder):
    with open(os.path.join(folder, "truth_spaces.json")) as file:
        truth = json.load(file)
    model = Model(path)
    found, walls = found_spaces(model), found_walls(model)
    true = readings(truth, found)
    pairs = matches(true, found)
    shares = [p[2] for p in pairs]

    def error(key):
        return [abs(found[j][key] - true[i][key]) / true[i][key] for i, j, _ in pairs]

    compared = compare_walls([true_space(room) for room in scanned_rooms(truth)], walls)
    return {
        "spaces true / found / matched": "%d / %d / %d" % (len(true), len(found), len(pairs)),
        "plan in common, median": "%.3f" % median(shares) if shares else "-",
        "error of area, median / largest": "%.2f %% / %.2f %%" %
        (100 * median(error("area")), 100 * max(error("area"))) if pairs else "-",
        "error of volume, median / largest": "%.2f %% / %.2f %%" %
        (100 * median(error("volume")), 100 * max(error("volume"))) if pairs else "-",
        "walls of the model / with two faces": "%d / %d" % (len(walls), sum(not w["assumed"] for w in walls)),
        "walls of the model on a true face": "%d" % len(compared["hit"]),
        "true faces / with a wall within 5 cm": "%.1f m / %.1f m (%.0f %%)" %
        (compared["metres"], compared["met"], 100 * compared["met"] / compared["metres"]),
        "error of thickness, median": "%.1f cm" % (100 * median(compared["errors"])) if compared["errors"] else "-",
    }


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    for what, value in figures(*sys.argv[1:]).items():
        print("| %s | %s |" % (what, value))
