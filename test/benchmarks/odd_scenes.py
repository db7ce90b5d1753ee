#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs pcl_sedr on odd rooms and asks whether what is wrong is told: odd_scenes.py FIRST LAST [options]

For every seed from FIRST to LAST one room is made, or two, with one thing that is easily taken for another, see buildings/oddities.py.
The solid of pcl_sedr is compared with the truth. A scene is right if it has the rooms that were made, at least 98 % of each is
within 5 cm of the other, and openings of the truth that are no panes and lead to another room, or have a leaf, were found, those on the
floor not as windows; else it is told if what is wrong is doubted where it is, and with at least half of its area or length, or an opening
that is said to be less than half sure is there, or the whole room is doubted, or nothing was written; else it is wrong without a word.
Column `named` has what doubts there are in that room or an invented one, wherever and however large.
Needs numpy, scipy and shapely.
Exit code 0: all were graded, however well; 1: not all were.
"""
import json
import random
import re

import numpy as np
from scipy.spatial import cKDTree
from shapely.geometry import Point, Polygon, box
from shapely.ops import unary_union

import opening_grades
from buildings import oddities
from buildings import runs
from proving import meshes

KINDS = {"first": oddities.FIRST, "later": oddities.LATER, "newest": oddities.NEWEST, "latest": oddities.LATEST}
MOST_OFF = 0.02     # share of a surface more than 5 cm from the other
RAYS = 900_000      # of all stations
BESIDE = 0.3        # metres from a room, where a doubt is still of it
TOLD = 0.5          # share of what is wrong, of its area or its length
FINE, TILE = 0.03, 0.1  # metres: spacing of samples of meshes, and tiles of what is wrong
LEVEL = ("left_out", "ceiling_apart", "ceiling_unseen", "part_unseen", "ceiling_off", "floor_off", "floor_unseen", "hanging", "raised_floor")
AREAS = LEVEL + ("hidden", "no_opening", "wall_off", "standing", "contradiction")  # square metres of them are a doubt's first value
LENGTHS = ("open", "guessed_wall", "in_line")                                      # metres
WHOLE = ("coverage", "no_plan", "filled_in", "crossing", "small_room", "narrow_room", "height", "unit", "up", "noise", "one_room", "two_rooms")
DOUBTS = AREAS + LENGTHS + WHOLE


def build(seed, kinds=oddities.FIRST):
    """The scene file of a seed as a dictionary."""
    rng = random.Random(f"odd {seed}")
    oddity = kinds[seed % len(kinds)]
    scene = oddities.Scene(rng)
    oddity(scene)
    scene.furnish()
    stations = [[round(v, 3) for v in s] for s in scene.stations]
    return {"format": "sedr-scene", "version": 1, "name": f"{oddity.__name__}_{seed}", "summary": oddity.__doc__ or oddity.__name__,
            "rooms": [scene.room] + scene.more,
            "outside": [{"block": {"name": "ground", "at": [5, 2], "floor": -2.6, "size": [80, 80, 0.2]}},
                        {"block": {"name": "facade", "at": [4, -16], "floor": -0.4, "size": [40, 1, 8]}}],
            "scanners": [{"stations": stations, "rays": RAYS // len(stations), "noise": 0.005}],
            "placement": {"yaw": rng.randrange(90), "shift": [round(rng.uniform(-9, 9), 2), round(rng.uniform(-9, 9), 2), 0]}}


def polygons(path):
    return [Polygon([e["start"] for e in room["boundary"]]).buffer(0) for room in json.loads(path.read_text(encoding="utf-8"))["rooms"]]


def wrong_place(folder):
    """Where in plan solid and truth are more than 5 cm from each other: squares of a tile."""
    points = [meshes.samples(meshes.read_mesh(path), FINE) for path in (folder / "truth.ply", folder / "out" / "solid.ply")]
    off = [a[cKDTree(b).query(a, distance_upper_bound=0.05 + FINE)[0] > 0.05 + FINE / 2] for a, b in (points, points[::-1])]
    tiles = {tuple(t) for t in np.floor(np.concatenate(off)[:, :2] / TILE).astype(int)}
    return unary_union([box(TILE * x, TILE * y, TILE * (x + 1), TILE * (y + 1)) for x, y in tiles])


def length_of(place):
    """The longer side of the smallest rectangle around the largest part of a place."""
    parts = list(getattr(place, "geoms", [place]))
    a, b, c = (Point(p) for p in max(parts, key=lambda part: part.area).minimum_rotated_rectangle.exterior.coords[:3])
    return max(a.distance(b), b.distance(c))


def lost_openings(folder):
    """True openings to other rooms and with leaves that were not found, or as windows though they stand on the floor."""
    true = [o for o in opening_grades.true_openings(folder) if not o["glazed"] and (min(o["rooms"]) > 0 or o.get("leaf"))]
    found = opening_grades.found_openings(folder / "out" / "floorplan.json")
    mate = dict(opening_grades.pairs(true, found))
    return [o for k, o in enumerate(true) if k not in mate or (o["kind"] == "door" and found[mate[k]]["kind"] == "window")]


def unsure_places(folder, report, sure):
    """The middles of walls and openings that are said to be less sure."""
    plan = json.loads((folder / "out" / "floorplan.json").read_text(encoding="utf-8"))
    lines = {f"{room['id']}.{k + 1}": e for room in plan["rooms"] for k, e in enumerate(room["boundary"])}
    lines.update(zip((o["number"] for o in report["openings"]), plan.get("openings", [])))
    unsure = [lines[row[0]] for table in report["certainty"].values() for row in table["rows"] if row[4] < sure]
    return [Point((np.array(e["start"]) + e["end"]) / 2) for e in unsure]


def told_by(folder, report, wrong):
    """Kinds of warnings that tell of what is wrong: `wrong` square metres at wrong_place(), or openings that were lost."""
    place = wrong_place(folder)
    rooms = {room["id"]: room["height"] for room in report["rooms"]}
    sums, kinds = {"area": 0, "level": 0, "length": 0}, set()
    for told in report["warnings"]:
        kind, value = told["kind"], (told["values"] or [0])[0]
        if kind in WHOLE:
            kinds.add(kind)
        if kind not in AREAS + LENGTHS:
            continue
        value *= told["values"][1] if kind == "no_opening" else 1  # width and height
        at = Point(told["at"]) if told["at"] else None
        if wrong > 0 and (at is None or place.distance(at) < BESIDE):
            height = rooms.get(told["room"], 2.5)
            sums["area"] += value * (height if kind in LENGTHS else 1)
            sums["level"] += value if kind in LEVEL else 0
            sums["length"] += value / (1 if kind in LENGTHS else height)
            kinds.add(kind)
    if sums["area"] < TOLD * wrong and sums["level"] < TOLD * place.area and sums["length"] < TOLD * length_of(place):
        kinds -= set(AREAS + LENGTHS)
    kinds |= {"unsure" for at in unsure_places(folder, report, 0.5) if wrong > 0 and place.distance(at) < BESIDE}
    doubted = [Point(told["at"]) for told in report["warnings"] + report["doubts"] if told["at"]] + unsure_places(folder, report, 0.9)
    for opening in lost_openings(folder):
        if all(at.distance(Point((opening["a"] + opening["b"]) / 2)) > opening["width"] / 2 + BESIDE for at in doubted):
            return set()
        kinds.add("opening")
    return kinds


def is_within(doubt, folder):
    """Whether a doubt is of the whole, or of a place in the rooms that were made, or in one that was found where there is none."""
    true = polygons(folder / "truth.json")
    invented = [p for p in polygons(folder / "out" / "floorplan.json") if all(p.intersection(t).area < p.area / 2 for t in true)]
    return not doubt["at"] or any(p.distance(Point(doubt["at"])) < BESIDE for p in true + invented)


def kinds_of(doubt):
    """Kinds of a doubt that count; "unsure" for what is said to be wrong rather than right."""
    sure = re.search(r", (\d+) % sure", doubt["text"])
    return [k for k in doubt["kinds"] if k in DOUBTS] + (["unsure"] if sure and int(sure[1]) < 50 else [])


def one_scene(seed, folder, options):
    row = runs.scan(build(seed, KINDS[options.kinds]), seed, folder, options)
    figures, message = runs.model(folder, options)
    row.update(figures)
    row.update({"rooms": len(json.loads((folder / "truth.json").read_text(encoding="utf-8"))["rooms"]), "rooms_found": 0, "off": "", "lost": "", "named": "", "told": ""})
    if figures["exit"] == 0:
        runs.output_of([options.bin / "pcl_mesh_evaluation", folder / "out" / "solid.ply", "--truth", folder / "truth.ply", "--json", folder / "solid.json"])
        solid = json.loads((folder / "solid.json").read_text(encoding="utf-8"))
        share = {k: 1 - solid[k]["within_5cm"] for k in ("truth_to_mesh", "mesh_to_truth")}
        row["off"] = round(max(share.values()), 4)
        row["rooms_found"] = len(json.loads((folder / "out" / "floorplan.json").read_text(encoding="utf-8"))["rooms"])
        report = json.loads((folder / "out" / "report.json").read_text(encoding="utf-8"))
        row["named"] = " ".join(sorted({k for d in report["doubts"] if is_within(d, folder) for k in kinds_of(d)}))
        row["lost"] = len(lost_openings(folder))
        wrong = max(share["truth_to_mesh"] * solid["truth"]["area"], share["mesh_to_truth"] * solid["mesh"]["area"])
        is_off = row["off"] > MOST_OFF or row["rooms_found"] != row["rooms"]
        row["told"] = " ".join(sorted(told_by(folder, report, wrong if is_off else 0)))
    is_right = row["exit"] == 0 and row["off"] <= MOST_OFF and row["rooms_found"] == row["rooms"] and not row["lost"]
    row["verdict"] = "right" if is_right else "told" if row["told"] or row["exit"] != 0 else "silent"
    row["all_right"] = int(row["verdict"] != "silent")
    row["message"] = message
    runs.keep(folder, row, options)
    return row


def summary(rows):
    def count(verdict, of):
        return sum(r["verdict"] == verdict for r in of)
    lines = [f"{len(rows)} scenes: {count('right', rows)} right, {count('told', rows)} wrong and told, {count('silent', rows)} wrong without a word; "
             f"right with a doubt: {sum(r['verdict'] == 'right' and bool(r['named']) for r in rows)}"]
    for kind in sorted({r["kind"] for r in rows}):
        of = [r for r in rows if r["kind"] == kind]
        lines.append(f"{kind}: {count('right', of)} right, {count('told', of)} told, {count('silent', of)} silent of {len(of)}")
    return "\n".join(lines)


def main():
    options = runs.parser(__doc__, "scenes")
    options.add_argument("--kinds", choices=KINDS, default="first", help="which kinds: the first 32, or those that were added later, or last")
    runs.all_seeds(options.parse_args(), ["pcl_mesh_evaluation"], one_scene, summary)


if __name__ == "__main__":
    main()
