#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Grades the openings of plans against the truth of simulated scans: opening_grades.py FOLDER... [--plan out/floorplan.json]

A folder is one of pcl_simulate_indoor_scan with the result of pcl_sedr below it. An opening is found if one of the plan's
overlaps it by half (intersection over union of width and height) within half a metre of the middle of its wall. Prints a
line an opening that is wrong with --list, and the sums: precision, recall and F1 of doors, windows and niches (with their backs
within 5 cm), of openings whatever their kind, how many have the wrong kind, errors of jambs, heads and sills, and leaves whose
hinge and side are right.
"""
import argparse
import json
import pathlib

import numpy as np
from scipy.optimize import linear_sum_assignment

from buildings import grades

FAR = 0.5    # metres from the middle of the wall
MATCH = 0.5  # intersection over union


def true_openings(folder):
    """Openings of truth.json, on the middle lines of their walls."""
    found = []
    for o in json.loads((folder / "truth.json").read_text(encoding="utf-8"))["openings"]:
        a, b = np.array(o["start"]), np.array(o["end"])
        way = (b - a) / np.linalg.norm(b - a)
        off = o["depth"] / 2 * np.array([way[1], -way[0]])  # the room is to the left
        found.append(dict(o, a=a + off, b=b + off))
    return found


def found_openings(path):
    """Openings of a plan, in the frame of the scan."""
    plan = json.loads(path.read_text(encoding="utf-8"))
    x, y, z = plan.get("origin", [0, 0, 0])
    return [dict(o, a=o["start"] + np.array([x, y]), b=o["end"] + np.array([x, y]), bottom=o["bottom"] + z, top=o["top"] + z)
            for o in plan.get("openings", [])]


def true_niches(folder):
    """Niches of scene.json, placed as the scan; without it none."""
    rooms, turn, shift = grades.placed_scene(folder)
    found = []
    for room in rooms:
        outline = [np.array(p["at"] if isinstance(p, dict) else p) for p in room["outline"] if room.get("niches")]
        for n in room.get("niches", []):
            p, q = outline[n["wall"]], outline[(n["wall"] + 1) % len(outline)]
            u = (q - p) / np.linalg.norm(q - p)
            a, b = (turn @ (p + n[k] * u) + shift[:2] for k in ("from", "to"))
            found.append(dict(n, kind="niche", a=a, b=b, bottom=n["sill"] + shift[2], top=n["head"] + shift[2]))
    return found


def found_niches(path):
    """Niches of a plan, along their walls."""
    found = []
    for room in json.loads(path.read_text(encoding="utf-8"))["rooms"]:
        for n in room["niches"]:
            corners = [np.array(e["start"]) for e in n["boundary"]]
            bottom, top = (grades.z_at(n[k], *(sum(corners) / 4)) for k in ("bottom", "top"))
            found.append({"kind": "niche", "a": corners[0], "b": corners[3], "bottom": bottom, "top": top,
                          "depth": np.linalg.norm(corners[1] - corners[0])})
    return found


def edges(true, found):
    """Errors of both jambs, sill and head, outwards, and the distance across the wall."""
    way = (true["b"] - true["a"]) / np.linalg.norm(true["b"] - true["a"])
    s = sorted(float((found[k] - true["a"]) @ way) for k in "ab")
    middle = (found["a"] + found["b"] - true["a"] - true["b"]) / 2
    length = np.linalg.norm(true["b"] - true["a"])
    return np.array([-s[0], s[1] - length, true["bottom"] - found["bottom"], found["top"] - true["top"]]), \
        abs(middle[0] * way[1] - middle[1] * way[0]), s


def overlap(true, found):
    _, across, s = edges(true, found)
    if across > FAR:
        return 0
    length = np.linalg.norm(true["b"] - true["a"])
    common = max(0, min(s[1], length) - max(s[0], 0)) * max(0, min(true["top"], found["top"]) - max(true["bottom"], found["bottom"]))
    areas = length * (true["top"] - true["bottom"]) + (s[1] - s[0]) * (found["top"] - found["bottom"])
    return common / (areas - common)


def pairs(true, found):
    table = np.array([[overlap(t, f) for f in found] for t in true]).reshape(len(true), len(found))
    return [(i, j) for i, j in zip(*linear_sum_assignment(-table)) if table[i, j] >= MATCH]


def leaf_is_right(true, found):
    """Whether hinge and side of a leaf are those of the truth; None if it has none that stands open."""
    leaf = true.get("leaf")
    if not leaf or leaf["state"] == "closed":
        return None
    if found["hinge"] == "unknown":
        return False
    # The truth runs along the wall of the room it swings into; that room is to the left.
    same = (true["b"] - true["a"]) @ (found["b"] - found["a"]) > 0
    if "both" in (found["hinge"], leaf["hinge"]):
        return found["hinge"] == leaf["hinge"] and (found["swing"] == found["rooms"][0]) == same
    return (found["hinge"] == leaf["hinge"]) == same and (found["swing"] == found["rooms"][0]) == same


def grade(folder, plan, is_listed):
    """Counts and errors of one folder."""
    true, found = true_openings(folder), found_openings(plan) if plan else []
    sums = {"errors": [], "confused": 0, "leaves": 0, "leaves_right": 0, "leaves_told": 0}
    matched = pairs(true, found)
    for i, j in matched:
        sums["errors"] += list(np.abs(edges(true[i], found[j])[0]))
        sums["confused"] += found[j]["kind"] not in (true[i]["kind"], "unknown")
        right = leaf_is_right(true[i], found[j])
        if right is not None:
            sums["leaves"] += 1
            sums["leaves_right"] += right
            sums["leaves_told"] += found[j]["hinge"] != "unknown"
    for kind in ("door", "window", "any"):
        t = [k for k, o in enumerate(true) if kind in ("any", o["kind"])]
        f = [k for k, o in enumerate(found) if kind in ("any", o["kind"])]
        right = pairs([true[k] for k in t], [found[k] for k in f])
        sums[kind] = np.array([len(right), len(f), len(t)])
    niches, backs = true_niches(folder), found_niches(plan) if plan else []
    right = [(i, j) for i, j in pairs(niches, backs) if abs(niches[i]["depth"] - backs[j]["depth"]) < 0.05]
    sums["niche"] = np.array([len(right), len(backs), len(niches)])
    sums["niches_open"] = len(pairs(niches, found))
    if is_listed:
        mate = dict(matched)
        for k, t in enumerate(true):
            f = found[mate[k]] if k in mate else None
            if f is None or f["kind"] != t["kind"] or np.abs(edges(t, f)[0]).max() > 0.05:
                print(folder.name, "missed" if f is None else "found as " + f["kind"], t["kind"], np.round((t["a"] + t["b"]) / 2, 2),
                      f"{t['width']:.2f} x {t['top'] - t['bottom']:.2f} sill {t['bottom']:.2f} shut {t['shut']}",
                      "" if f is None else np.round(edges(t, f)[0], 3))
        for k, f in enumerate(found):
            if k not in mate.values():
                print(folder.name, "extra", f["kind"], np.round((f["a"] + f["b"]) / 2, 2), f"{f['width']:.2f} x {f['height']:.2f} from z {f['bottom']:.2f}", f["rooms"])
    return sums


def columns(sums):
    """Columns of a table: true, found and right openings of each kind, errors of edges in cm, leaves."""
    row = {f"{kind}s_{what}": int(n) for kind in ("door", "window", "niche") for what, n in zip(("right", "found", "true"), sums[kind])}
    row.update({f"openings_{what}": int(n) for what, n in zip(("right", "found", "true"), sums["any"])})
    errors = 100 * np.array(sums["errors"] or [0])
    row.update({f"edges_{name}_cm": round(float(e), 2) for name, e in (("median", np.median(errors)), ("95", np.percentile(errors, 95)))})
    row["wrong_kind"] = sums["confused"]
    row["niches_open"] = sums["niches_open"]
    row.update({k: int(sums[k]) for k in ("leaves", "leaves_told", "leaves_right")})
    return row


def summary(rows):
    """Lines on all rows. Errors of edges are means over rows, weighted by their openings."""
    def total(key):
        return sum(r[key] for r in rows)
    lines = []
    for kind in ("doors", "windows", "niches", "openings"):
        right, found, true = (total(f"{kind}_{what}") for what in ("right", "found", "true"))
        lines.append(f"{kind}: {true} true, {found} found, {right} right: precision {right / max(found, 1):.3f}, "
                     f"recall {right / max(true, 1):.3f}, F1 {2 * right / max(found + true, 1):.3f}")
    many = max(total("openings_right"), 1)
    median, most = (sum(r[f"edges_{k}_cm"] * r["openings_right"] for r in rows) / many for k in ("median", "95"))
    lines.append(f"edges: median {median:.1f} cm, 95 % within {most:.1f} cm; {total('wrong_kind')} of the wrong kind, "
                 f"{total('niches_open')} niches are openings")
    lines.append(f"open leaves: {total('leaves')} true, {total('leaves_told')} told, {total('leaves_right')} right")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--plan", default="out/floorplan.json", help="below each folder")
    parser.add_argument("--list", action="store_true", help="openings that are wrong")
    options = parser.parse_args()
    of_folders = [grade(f, f / options.plan, options.list) for f in options.folders]
    pooled = {k: sum((g[k] for g in of_folders[1:]), of_folders[0][k]) for k in of_folders[0]}
    print("\n".join(summary([columns(pooled)])))


if __name__ == "__main__":
    main()
