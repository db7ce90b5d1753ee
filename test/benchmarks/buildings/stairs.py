# SPDX-License-Identifier: BSD-3-Clause
"""Flights of stairs between rooms above each other."""
import math

from . import geometry as g

GOING = 0.26
WIDTH = 0.95
HEADROOM = 2.1


def flight(height):
    """Steps, rise and length in plan of a flight over a height; the landing is a rise above the last step."""
    risers = math.ceil(height / 0.185)
    return risers - 1, height / risers, (risers - 1) * GOING


def room_for(height):
    """Length and width that two flights side by side need, without landings."""
    return flight(height)[2], 2 * WIDTH + 0.5


def add(lower, upper, lane):
    """A flight from a room to the one above, along its longer side; lane 0 or 1. False if there is no room for it."""
    height = upper.floor - lower.floor
    steps, rise, run = flight(height)
    box = overlap(g.bounds(lower.outline), g.bounds(upper.outline))
    axis = 1 if box[3] - box[1] >= box[2] - box[0] else 0
    low, high = box[axis], box[axis + 2]
    side_low, side_high = box[1 - axis], box[3 - axis]
    if high - low < run + 1.5 or side_high - side_low < 2 * WIDTH + 0.3:
        return False
    start = low + max(0.9, (high - low - run) / 2)
    across = side_low + 0.12 + WIDTH / 2 if lane == 0 else side_high - 0.12 - WIDTH / 2
    forward = lane == 0
    foot = start if forward else start + run
    way = 1 if forward else -1
    # The hole begins where a head would touch the slab.
    first = max(0, int((lower.ceiling - lower.floor - HEADROOM) / rise) - 1)
    a, b = sorted((foot + way * first * GOING, foot + way * (run + 0.02)))
    half = WIDTH / 2 + 0.06
    hole = rect(axis, a, b, across - half, across + half)
    whole = rect(axis, start - 0.75, start + run + 0.75, across - half, across + half)
    body = rect(axis, start, start + run, across - half, across + half)
    for room, outline in ((lower, body), (upper, hole)):
        if not all(g.inside(room.outline, p) for p in outline) or any(g.meet(outline, t) for t in room.taken):
            return False
    at = (foot, across) if axis == 0 else (across, foot)
    yaw = {(0, 1): -90, (0, -1): 90, (1, 1): 0, (1, -1): 180}[(axis, way)]
    lower.furniture.append({"stairs": {"at": [round(v, 4) for v in at], "yaw": yaw, "width": WIDTH, "rise": rise,
                                       "going": GOING, "steps": steps}})
    loop = [[round(x, 4), round(y, 4)] for x, y in hole]
    lower.voids.append({"loop": loop, "leads_to": upper.name, "outline": [tuple(p) for p in loop]})
    upper.floor_voids.append([tuple(p) for p in loop])
    lower.taken.append(whole)
    lower.obstacles.append(body)
    upper.obstacles.append([tuple(p) for p in loop])
    before, behind = (0.1, 0.75) if forward else (0.75, 0.1)  # where the flight arrives there is a landing
    upper.taken.append(rect(axis, a - before, b + behind, across - half, across + half))
    balustrade(upper, axis, a, b, across, half, forward)
    return True


def add_well(rng, lower, upper):
    """A hole in the slab between two large rooms with a balustrade around it; False if there is no place."""
    box = overlap(g.bounds(lower.outline), g.bounds(upper.outline))
    wide, deep = rng.uniform(2.0, 4.5), rng.uniform(2.0, 4.5)
    if box[2] - box[0] < wide + 4 or box[3] - box[1] < deep + 4:
        return False
    for _ in range(20):
        x, y = rng.uniform(box[0] + 1.2, box[2] - wide - 1.2), rng.uniform(box[1] + 1.2, box[3] - deep - 1.2)
        hole = [(round(p, 3), round(q, 3)) for p, q in g.rectangle(x, y, x + wide, y + deep)]
        if not (lower.fits(hole, 1.2) and upper.fits(hole, 1.2)):
            continue
        lower.voids.append({"loop": [list(p) for p in hole], "leads_to": upper.name, "outline": hole})
        upper.floor_voids.append(hole)
        upper.taken.append(g.rectangle(x - 0.3, y - 0.3, x + wide + 0.3, y + deep + 0.3))
        upper.obstacles.append(hole)
        for at, size in (((x + wide / 2, y - 0.05), (wide, 0.04)), ((x + wide / 2, y + deep + 0.05), (wide, 0.04)),
                         ((x - 0.05, y + deep / 2), (0.04, deep)), ((x + wide + 0.05, y + deep / 2), (0.04, deep))):
            upper.furniture.append({"block": {"name": "balustrade", "at": [round(v, 4) for v in at],
                                              "size": [round(size[0], 4), round(size[1], 4), 1.0]}})
        return True
    return False


def balustrade(room, axis, a, b, across, half, forward):
    """Panels along the sides of the hole, open where the flight arrives."""
    inner = across + half + 0.03 if across < middle_of(room, axis) else across - half - 0.03
    panels = [((a + b) / 2, inner, b - a, 0.04)]
    end = a - 0.03 if forward else b + 0.03
    panels.append((end, across, 0.04, 2 * half))
    for s, t, size_s, size_t in panels:
        at, size = ((s, t), (size_s, size_t)) if axis == 0 else ((t, s), (size_t, size_s))
        outline = g.turned_rectangle(at, size[0], size[1], 0.0)
        if all(g.inside(room.outline, p) for p in outline):
            room.furniture.append({"block": {"name": "balustrade", "at": [round(v, 4) for v in at],
                                             "size": [round(size[0], 4), round(size[1], 4), 0.95]}})


def middle_of(room, axis):
    box = g.bounds(room.outline)
    return (box[1 - axis] + box[3 - axis]) / 2


def overlap(a, b):
    return max(a[0], b[0]), max(a[1], b[1]), min(a[2], b[2]), min(a[3], b[3])


def rect(axis, a, b, c, d):
    return g.rectangle(a, c, b, d) if axis == 0 else g.rectangle(c, a, d, b)
