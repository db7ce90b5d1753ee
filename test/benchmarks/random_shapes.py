#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs pcl_sedr on random rooms of any shape and grades their solids: random_shapes.py FIRST LAST [options]

For every seed from FIRST to LAST one room is made, or two, whose plan, ceiling and walls may slope, curve and tilt. It is
scanned with a centimetre of noise, modelled by pcl_sedr --no-mesh and compared with the truth. A scene is all right if the rooms
are right as random_buildings.py has it, the solid is closed, and in both directions it is 0.05 cm from the truth on average at
most, and at least 98 % of it within a centimetre. Needs numpy, scipy and shapely, for pictures matplotlib.
Exit code 0: all were graded, however well; 1: not all were.
"""
import json

from buildings import runs
from buildings.shaped import build

runs.require("numpy", "scipy", "shapely")
from buildings import grades, pictures  # noqa: E402
from proving import pcd  # noqa: E402

MOST_MEAN = 0.0005   # metres
LEAST_NEAR = 0.98    # share within a centimetre


def distances(folder, options):
    """Columns of the solid against the truth: the worse of both directions."""
    row = {"closed": 0, "mean_cm": "", "near": "", "max_cm": "", "triangles": ""}
    if not (folder / "out" / "solid.ply").exists():
        return row
    runs.output_of([options.bin / "pcl_mesh_evaluation", folder / "out" / "solid.ply", "--truth", folder / "truth.ply",
                    "--json", folder / "solid.json"])
    figures = json.loads((folder / "solid.json").read_text(encoding="utf-8"))
    both = [figures["truth_to_mesh"], figures["mesh_to_truth"]]
    return {"closed": int(figures["mesh"]["closed"]), "mean_cm": round(100 * max(b["mean"] for b in both), 4),
            "near": round(min(b["within_1cm"] for b in both), 4), "max_cm": round(100 * max(b["max"] for b in both), 2),
            "triangles": figures["mesh"]["triangles"]}


def one_scene(seed, folder, options):
    row = runs.scan(build(seed), seed, folder, options)
    figures, message = runs.model(folder, options)
    row.update(figures)
    rooms, graded = grades.grade(folder, folder / "out", every_room=True)
    row.update({"rooms": rooms["rooms"], "rooms_found": rooms["rooms_found"], "rooms_right": rooms["all_right"]})
    row.update(distances(folder, options))
    row["all_right"] = int(bool(row["rooms_right"] and row["closed"] and row["mean_cm"] <= 100 * MOST_MEAN and row["near"] >= LEAST_NEAR))
    row["message"] = message
    kept = runs.keep(folder, row, options)
    if kept:
        shown = ("rooms", "rooms_found", "closed", "mean_cm", "near", "max_cm")
        title = f"{row['kind']} {seed}: " + ", ".join(f"{k} {row[k]}" for k in shown)
        pictures.draw(kept / "rooms.png", title, graded, pcd.read(folder / "scan.pcd"))
    return row


def summary(rows):
    found = sorted(r["mean_cm"] for r in rows if r["mean_cm"] != "")
    right = sum(r["all_right"] for r in rows)
    lines = [f"{len(rows)} scenes, all right {right} ({100 * right / len(rows):.0f} %)",
             f"rooms right {sum(r['rooms_right'] for r in rows)}, closed {sum(r['closed'] for r in rows)}, "
             f"mean {sum(r['mean_cm'] != '' and r['mean_cm'] <= 100 * MOST_MEAN for r in rows)}, "
             f"within 1 cm {sum(r['near'] != '' and r['near'] >= LEAST_NEAR for r in rows)}"]
    if found:
        lines.append(f"mean distance, cm: median {found[len(found) // 2]:.4f}, worst {found[-1]:.3f}")
    return "\n".join(lines)


def main():
    runs.all_seeds(runs.parser(__doc__, "scenes").parse_args(), ["pcl_mesh_evaluation"], one_scene, summary)


if __name__ == "__main__":
    main()
