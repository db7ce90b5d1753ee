#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs pcl_sedr on odd rooms and asks whether what is wrong is told: odd_scenes.py FIRST LAST [options]

For every seed from FIRST to LAST one room is made, or two, with one thing that is easily taken for another, see buildings/oddities.py.
The solid of pcl_sedr is compared with the truth. A scene is right if it has the rooms that were made, and at least 98 % of each is
within 5 cm of the other; else it is told if there is a doubt of what was not explained, not seen or guessed, or of a wall or opening
that is said to be less than half sure, in the room, in one that was invented or of the whole, or if nothing was written; else it is
wrong without a word. Needs numpy, scipy and shapely.
Exit code 0: all were graded, however well; 1: not all were.
"""
import json
import random
import re

from shapely.geometry import Point, Polygon

from buildings import oddities
from buildings import runs

KINDS = {"first": oddities.FIRST, "later": oddities.LATER, "newest": oddities.NEWEST}
MOST_OFF = 0.02     # share of a surface more than 5 cm from the other
RAYS = 900_000      # of all stations
BESIDE = 0.3        # metres from a room, where a doubt is still of it
DOUBTS = ("coverage", "no_plan", "left_out", "hidden", "open", "no_opening", "filled_in", "guessed_wall", "ceiling_apart", "ceiling_unseen", "part_unseen", "ceiling_off", "floor_off", "floor_unseen", "wall_off",
          "standing", "hanging", "crossing", "contradiction", "small_room", "narrow_room", "height", "unit", "up",
          "in_line", "raised_floor", "noise", "one_room", "two_rooms")


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
    return [Polygon([e["start"] for e in room["boundary"]]) for room in json.loads(path.read_text(encoding="utf-8"))["rooms"]]


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
    row.update({"rooms": len(json.loads((folder / "truth.json").read_text(encoding="utf-8"))["rooms"]), "rooms_found": 0, "off": "", "told": ""})
    if figures["exit"] == 0:
        _, _, text = runs.run([options.bin / "pcl_mesh_evaluation", folder / "out" / "solid.ply", "--truth", folder / "truth.ply", "--json", folder / "solid.json"], 600)
        if not (folder / "solid.json").exists():
            raise RuntimeError(f"seed {seed}: {text}")
        solid = json.loads((folder / "solid.json").read_text(encoding="utf-8"))
        row["off"] = round(1 - min(solid[k]["within_5cm"] for k in ("truth_to_mesh", "mesh_to_truth")), 4)
        row["rooms_found"] = len(json.loads((folder / "out" / "floorplan.json").read_text(encoding="utf-8"))["rooms"])
        report = json.loads((folder / "out" / "report.json").read_text(encoding="utf-8"))
        row["told"] = " ".join(sorted({k for d in report["doubts"] if is_within(d, folder) for k in kinds_of(d)}))
    is_right = row["exit"] == 0 and row["off"] <= MOST_OFF and row["rooms_found"] == row["rooms"]
    row["verdict"] = "right" if is_right else "told" if row["told"] or row["exit"] != 0 else "silent"
    row["all_right"] = int(row["verdict"] != "silent")
    row["message"] = message
    runs.keep(folder, row, options)
    return row


def summary(rows):
    def count(verdict, of):
        return sum(r["verdict"] == verdict for r in of)
    lines = [f"{len(rows)} scenes: {count('right', rows)} right, {count('told', rows)} wrong and told, {count('silent', rows)} wrong without a word; "
             f"right with a doubt: {sum(r['verdict'] == 'right' and bool(r['told']) for r in rows)}"]
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
