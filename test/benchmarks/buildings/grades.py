# SPDX-License-Identifier: BSD-3-Clause
"""Grades floorplan.json against the simulator's truth.json. Metres and square metres."""
import json
import math
import os

import numpy as np
from scipy.optimize import linear_sum_assignment
from shapely.geometry import Polygon
from shapely.ops import unary_union

from proving import pcd

CHORD = 0.05        # metres along an arc
CELL = 0.25         # metres, of the plan cells that count as seen or not
LEAST_SEEN = (0.5, 0.8)  # shares of the cells of its floor and of its ceiling that must be seen for a room to count
FLOOR_OFF = 0.05    # metres from which a floor is at a wrong height
SMALLEST = 1.5      # square metres of a room that counts, true or found
RIGHT = 0.7         # intersection over union of a room that is right
STEPS = (0.5, 0.7, 0.9)


def loop_points(elements):
    """Corners of a loop of segments and arcs."""
    points = []
    for e in elements:
        start, end = np.array(e["start"], float), np.array(e["end"], float)
        points.append(start)
        if e.get("type") != "arc":
            continue
        centre = np.array(e["centre"], float)
        first = math.atan2(*(start - centre)[::-1])
        last = math.atan2(*(end - centre)[::-1])
        sweep = (last - first) % (2 * math.pi)
        if not e.get("counter_clockwise", True):
            sweep -= 2 * math.pi
        if np.linalg.norm(end - start) < 1e-9:
            sweep = math.copysign(2 * math.pi, sweep if sweep else 1)
        radius = float(e["radius"])
        count = max(1, int(abs(sweep) * radius / CHORD))
        for k in range(1, count):
            angle = first + sweep * k / count
            points.append(centre + radius * np.array([math.cos(angle), math.sin(angle)]))
    return np.array(points)


def polygon(boundary, holes=()):
    points = loop_points(boundary)
    if len(points) < 3:
        return Polygon()
    shape = Polygon(points).buffer(0)
    for hole in holes:
        shape = shape.difference(polygon(hole))
    return shape


class Place:
    """A room, true or found: its plan, its heights and what it is called."""

    def __init__(self, name, plan, low, high, **more):
        self.name, self.plan, self.low, self.high = name, plan, low, high
        self.area = plan.area
        self.storey = more.get("storey", 1)
        self.seen = more.get("seen", (1.0, 1.0))
        self.ignored = more.get("ignored", Polygon())  # where its plan is anybody's: voids
        self.ids = more.get("ids", [])

    def counts(self):
        return self.area >= SMALLEST and all(s >= least for s, least in zip(self.seen, LEAST_SEEN))


def true_places(truth, points):
    places = []
    for room in truth["rooms"]:
        plan = polygon(room["boundary"], room["columns"])
        ignored = unary_union([polygon(v) for v in room["voids"] + room["floor_voids"]] or [Polygon()])
        places.append(Place(room["name"], plan, room["floor"], room["floor"] + room["height"],
                            storey=room["storey"], ids=[room["id"]], seen=(seen_share(room, points, 2, "floor_voids"), seen_share(room, points, 1, "voids")),
                            ignored=ignored))
    return places


def z_at(slab, x, y):
    a, b, c, d = slab["plane"]
    return -(a * x + b * y + d) / c


def found_places(plan):
    places = []
    for room in plan.get("rooms", []):
        shape = polygon(room["boundary"], room.get("columns", []))
        if not shape.is_empty:
            low, high = (z_at(room[side], *shape.representative_point().coords[0]) for side in ("floor", "ceiling"))
            places.append(Place(str(room.get("id")), shape, low, high))
    return places


def within(loop, points):
    """Which of the points are inside a loop of corners."""
    x, y = points[:, 0], points[:, 1]
    odd = np.zeros(len(points), bool)
    for a, b in zip(loop, np.roll(loop, -1, axis=0)):
        if a[1] == b[1]:
            continue
        odd ^= ((a[1] > y) != (b[1] > y)) & (x < a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1]))
    return odd


def seen_share(room, points, label, holes):
    """Share of a room's plan cells in which its floor (label 2) or ceiling (1) was seen, details of it included."""
    loop = loop_points(room["boundary"])
    low = loop.min(0)
    count = np.ceil((loop.max(0) - low) / CELL).astype(int)
    grid = np.stack(np.meshgrid(*[np.arange(n) for n in count], indexing="ij"), -1).reshape(-1, 2)
    centres = low + (grid + 0.5) * CELL
    is_inside = within(loop, centres)
    for hole in room["columns"] + room[holes]:
        is_inside &= ~within(loop_points(hole), centres)
    mine = points[points["room"] == room["id"]]
    is_high = mine["z"] > room["floor"] + 0.5 * room["height"]
    mine = mine[(mine["label"] == label) | ((mine["label"] == 4) & (is_high if label == 1 else ~is_high))]
    cells = ((np.stack([mine["x"], mine["y"]], -1) - low) / CELL).astype(int)
    cells = cells[((cells >= 0) & (cells < count)).all(1)]
    seen = np.zeros(count, bool)
    seen[cells[:, 0], cells[:, 1]] = True
    return float(seen.reshape(-1)[is_inside].mean()) if is_inside.any() else 0.0


def share_height(a, b):
    common = min(a.high, b.high) - max(a.low, b.low)
    return common > 0.5 * min(a.high - a.low, b.high - b.low)


def overlap(a, b):
    return a.plan.intersection(b.plan).area if share_height(a, b) and a.plan.intersects(b.plan) else 0.0


def iou(true, found):
    if not share_height(true, found) or not true.plan.intersects(found.plan):
        return 0.0
    t, f = true.plan.difference(true.ignored), found.plan.difference(true.ignored)
    union = t.union(f).area
    return t.intersection(f).area / union if union > 0 else 0.0


def read_openings(places, links, found):
    """Joins rooms between which no lintel hangs, where the found rooms do so: one room and two are both right."""
    for link in links:
        if link["kind"] != "passage" or link["lintel"] > 0.05 or link["shut"]:
            continue
        a, b = (next(p for p in places if k in p.ids) for k in link["rooms"])
        if a is b:
            continue
        for f in found:
            if min(overlap(a, f) / a.area, overlap(b, f) / b.area) > 0.5:
                both = unary_union([a.plan, b.plan]).buffer(0.25, join_style=2).buffer(-0.25, join_style=2)
                joined = Place(f"{a.name} + {b.name}", both, min(a.low, b.low), max(a.high, b.high), storey=a.storey, seen=tuple(map(min, a.seen, b.seen)),
                               ids=a.ids + b.ids, ignored=a.ignored.union(b.ignored))
                places = [p for p in places if p is not a and p is not b] + [joined]
                break
    return places


def what_became(true, wanted, found, best):
    """right, missed, merged, split or shape."""
    if best >= RIGHT:
        return "right"
    over = [(overlap(true, f), f) for f in found]
    over = sorted((o for o in over if o[0] > 0.1 * min(true.area, o[1].area)), key=lambda o: -o[0])
    if sum(o[0] for o in over) < 0.2 * true.area:
        return "missed"
    if sum(overlap(t, over[0][1]) > 0.3 * min(t.area, over[0][1].area) for t in wanted) > 1:
        return "merged"
    if sum(o[0] > 0.15 * true.area for o in over) > 1:
        return "split"
    return "shape"


def placed_scene(folder):
    """Rooms of scene.json, if there is one, and the turn and shift by which they were placed."""
    path = os.path.join(folder, "scene.json")
    scene = load(path) if os.path.exists(path) else {"rooms": []}
    place = {"yaw": 0, "shift": [0, 0, 0], **scene.get("placement", {})}
    return scene["rooms"], turned(place["yaw"]), np.array(place["shift"], float)


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def true_flights(folder):
    """The flights of a scene as floorplan.json lists them, as they were placed."""
    rooms, turn, shift = placed_scene(folder)
    flights = []
    for room in rooms:
        for stairs in (f["stairs"] for f in room.get("furniture", []) if "stairs" in f):
            along = np.arange(stairs["steps"] + 1) * stairs["going"]
            ends = np.stack([np.stack([np.full_like(along, side * stairs["width"] / 2), along], -1) for side in (-1, 1)], 1)
            risers = (ends @ turned(stairs["yaw"]).T + np.array(stairs["at"], float)) @ turn.T + shift[:2]
            bottom = room.get("floor", 0.0) + shift[2]
            flights.append({"risers": risers, "bottom": bottom, "top": bottom + stairs["rise"] * len(along), "steps": len(along)})
    return flights


def turned(degrees):
    a = math.radians(degrees)
    return np.array([[math.cos(a), -math.sin(a)], [math.sin(a), math.cos(a)]])


def flight_polygon(flight):
    risers = np.array(flight["risers"], float)
    return Polygon(np.concatenate([risers[:, 1], risers[::-1, 0]])).buffer(0)


def pair_flights(true, found):
    """Where each true flight is among those found (that it shares over half of its plan or theirs and of its height with), or None."""
    pairs = []
    for t in true:
        plan = flight_polygon(t)
        shares = [0.0]
        for f in found:
            other = flight_polygon(f)
            common = min(t["top"], f["top"]) - max(t["bottom"], f["bottom"])
            shares.append(plan.intersection(other).area / min(plan.area, other.area) if common > 0.5 * (t["top"] - t["bottom"]) else 0.0)
        pairs.append(int(np.argmax(shares)) - 1 if max(shares) > 0.5 else None)
    return pairs


def found_flights(plan):
    return [f for s in plan.get("stairs", []) for f in s.get("flights", [])]


def grade_stairs(true, plan):
    """Flights: how many there are, are found, with as many steps, and invented."""
    found = found_flights(plan)
    pairs = pair_flights(true, found)
    exact = sum(k is not None and found[k]["steps"] == t["steps"] for t, k in zip(true, pairs))
    return {"stairs": len(true), "stairs_found": len(true) - pairs.count(None), "stairs_exact": exact,
            "stairs_invented": len(set(range(len(found))) - set(pairs))}


def grade(folder, output, every_room=False):
    """All figures of a building, and the places that a picture shows.

    folder holds truth.json and scan.pcd, output floorplan.json; without that nothing was found. every_room: a scanner stood in
    each of them, so all count, even where tilted walls leave too little ceiling above the floor.
    """
    truth = load(os.path.join(folder, "truth.json"))
    path = os.path.join(output, "floorplan.json")
    plan = load(path) if os.path.exists(path) else {}
    found = found_places(plan)
    places = read_openings(true_places(truth, pcd.read(os.path.join(folder, "scan.pcd"))), truth["links"], found)
    wanted = [p for p in places if every_room or p.counts()]
    rest = [p for p in places if p not in wanted]
    table = np.array([[iou(t, f) for f in found] for t in wanted]).reshape(len(wanted), len(found))
    pairs = [(i, k) for i, k in zip(*linear_sum_assignment(-table)) if table[i, k] > 0]
    of_true, of_found = {i: k for i, k in pairs}, {k: table[i, k] for i, k in pairs}
    best = [table[i, of_true[i]] if i in of_true else 0.0 for i in range(len(wanted))]
    fates = [what_became(t, wanted, found, b) for t, b in zip(wanted, best)]
    extra = [f for k, f in enumerate(found) if of_found.get(k, 0.0) < 0.5 and f.area > SMALLEST and
             sum(overlap(r, f) for r in rest) <= 0.5 * f.area]
    errors = [abs(found[k].area - wanted[i].area) / wanted[i].area for i, k in pairs if table[i, k] >= 0.5]
    figures = {"rooms": len(wanted), "rooms_not_counted": len(rest), "rooms_found": len(found)}
    for step in STEPS:
        figures[f"matched_{step}"] = sum(b >= step for b in best)
    for fate in ("missed", "merged", "split", "shape"):
        figures[fate] = fates.count(fate)
    figures["extra"] = len(extra)
    figures["area_error_median"] = round(float(np.median(errors)), 4) if errors else ""
    figures["area_error_max"] = round(max(errors), 4) if errors else ""
    figures["floors_off"] = sum(table[i, k] >= 0.5 and abs(found[k].low - wanted[i].low) > FLOOR_OFF for i, k in pairs)
    figures["storeys"] = len({p.storey for p in wanted})
    figures["storeys_found"] = len(plan.get("storeys", [None] if found else []))
    if os.path.exists(os.path.join(folder, "scene.json")):
        figures.update(grade_stairs(true_flights(folder), plan))
    has_storeys = figures["storeys"] == figures["storeys_found"]
    figures["all_right"] = int(all(f == "right" for f in fates) and not extra and has_storeys)
    return figures, {"wanted": wanted, "rest": rest, "found": found, "extra": extra, "fates": fates, "best": best}
