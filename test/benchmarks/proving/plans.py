# SPDX-License-Identifier: BSD-3-Clause
"""Found and true rooms side by side: floorplan.json and report.json of pcl_sedr, truth.json of the simulator."""
import math

import numpy as np
from shapely.geometry import LineString

from buildings import grades

SAME_PLACE = 1e-6    # metres; tolerance of equal curves in a scene
SHARP_CORNER = 0.17  # sine of the turning angle, about 10 degrees
ARC_REACH = 0.1      # metres from an arc to the plan's element
MIN_OVERLAP = 0.5    # share of the union of two matched rooms


def keep_larger(row, column, error):
    row[column] = float(np.maximum(row.get(column, 0), error))  # NaN stays


def keep_error(row, column, found, true):
    keep_larger(row, column, abs(found - true) / true if true else math.nan)


def pairs(plan, truth):
    """Found and true rooms, one to one in order of decreasing overlap in plan, with overlap and union as measured there."""
    founds = [(room, grades.polygon(room["boundary"], room["columns"])) for room in plan["rooms"]]
    trues = [(room, grades.polygon(room["boundary"], room["columns"])) for room in truth["rooms"]]
    candidates = sorted(((f.intersection(t).area, i, k) for i, (_, f) in enumerate(founds) for k, (_, t) in enumerate(trues)),
                        key=lambda c: -c[0])
    result, used = [], set()
    for overlap, i, k in candidates:
        if overlap > 0 and not used & {("found", i), ("true", k)}:
            used |= {("found", i), ("true", k)}
            result.append((founds[i][0], trues[k][0], overlap, founds[i][1].union(trues[k][1]).area))
    return result


def is_arc(element):
    return element["type"] == "arc"


def line_of(element):
    return LineString(grades.loop_points([element, dict(element, type="segment", start=element["end"])]))


def direction(element, end):
    """The unit vector along an element at its "start" or "end"."""
    if not is_arc(element):
        way = np.subtract(element["end"], element["start"])
    else:
        x, y = np.subtract(element[end], element["centre"])
        way = np.array([-y, x]) if element.get("counter_clockwise", True) else np.array([y, -x])
    return way / np.linalg.norm(way)


def turn(a, b):
    """Sine of the turning angle from one element to the next."""
    (ax, ay), (bx, by) = direction(a, "end"), direction(b, "start")
    return ax * by - ay * bx


def continues(a, b):
    if is_arc(a) != is_arc(b) or abs(turn(a, b)) > SAME_PLACE:
        return False
    return not is_arc(a) or (a.get("counter_clockwise") == b.get("counter_clockwise") and abs(a["radius"] - b["radius"]) < SAME_PLACE)


def curves(loop):
    """True lines and arcs: each one or more consecutive elements on one curve."""
    result = []
    for element in loop:
        if result and continues(result[-1][-1], element):
            result[-1].append(element)
        else:
            result.append([element])
    if len(result) > 1 and continues(result[-1][-1], result[0][0]):
        result[-1] += result.pop(0)
    return result


def corners_among(count):
    return 0 if count == 1 else count  # a loop of one curve is a circle


def compare_loops(found, true, row):
    """Adds what the walls and columns of one pair of rooms show."""
    elements = [e for loop in (found["boundary"], *found["columns"]) for e in loop]
    corners = 0
    for loop in (true["boundary"], *true["columns"]):
        parts = curves(loop)
        corners += corners_among(len(parts))
        for before, part in zip([parts[-1], *parts[:-1]], parts):
            if abs(turn(before[-1], part[0])) > SHARP_CORNER:
                keep_larger(row, "corner_distance_max", min(math.dist(e["start"], part[0]["start"]) for e in elements))
            if is_arc(part[0]):
                row["arcs_true"] += 1
                radius, at = part[0]["radius"], line_of(part[0]).interpolate(0.5, normalized=True)
                near = [abs(e["radius"] - radius) / radius for e in elements if is_arc(e) and line_of(e).distance(at) < ARC_REACH]
                keep_larger(row, "radius_error", min([1, *near]))
    corners_found = sum(corners_among(len(loop)) for loop in (found["boundary"], *found["columns"]))
    row["corners_true"] += corners
    row["corners_found"] += corners_found
    row["rooms_with_other_corners"] += corners != corners_found
    row["arcs_found"] += sum(map(is_arc, elements))


def compare_rooms(plan, report, truth, row):
    """Adds the figures of the plan to a row; returns the ids of the paired rooms, found and true."""
    found_pairs = pairs(plan, truth)
    row.update(rooms_true=len(truth["rooms"]), rooms_found=len(plan["rooms"]), rooms_matched=0)
    if found_pairs:
        row.update(dict.fromkeys(("corners_true", "corners_found", "rooms_with_other_corners", "arcs_true", "arcs_found"), 0))
    meshes = {room["id"]: room["mesh"] for room in report["rooms"]}
    for found, true, overlap, union in found_pairs:
        row["rooms_matched"] += overlap >= MIN_OVERLAP * union
        for name in ("area", "volume", "perimeter"):
            keep_error(row, f"{name}_error", found[name], true[name])
        keep_error(row, "height_error", found["volume"] / found["area"], true["volume"] / true["area"])
        if meshes.get(found["id"]):
            keep_error(row, "mesh_volume_error", meshes[found["id"]]["volume"], true["volume"])
        compare_loops(found, true, row)
    return [(found["id"], true["id"]) for found, true, _, _ in found_pairs]
