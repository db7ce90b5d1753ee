# SPDX-License-Identifier: BSD-3-Clause
"""Furniture that stands clear of doors, stairs and each other, and where a surveyor puts the scanner."""
import math

from . import geometry as g


def furnish(rng, room):
    """Things before the walls, tables with chairs, lamps."""
    low = lowest_over(room)
    tall = low > 2.0
    many = min(14, int(room.area / rng.uniform(3.5, 9)))
    if room.role in ("corridor", "stairs"):
        many = min(many, 2)
    for _ in range(many):
        before_wall(rng, room, tall, low)
    if room.role in ("corridor", "stairs", "closet"):
        return
    for _ in range(min(30, int(room.area / rng.uniform(9, 25)) + 1)):
        table(rng, room)
    if room.role == "open" and rng.random() < 0.6:
        for _ in range(rng.randint(2, 10)):
            screen(rng, room)
    if not room.facets and not room.ribs and not room.details and low > 2.4 and rng.random() < 0.3:
        lamp(rng, room)


def lowest_over(room):
    if room.facets:
        return min(room.ceiling_at(p) for p in room.inner_corners()) - room.floor
    return room.lowest_ceiling() - room.floor


def before_wall(rng, room, tall, low):
    """A wardrobe, a shelf or a low cupboard with its back to a wall, sometimes a row of them."""
    i = rng.randrange(len(room.edges))
    if i in room.bulges:
        return
    a, u, n, size = g.frame(room.edges[i])
    kind = rng.random()
    if kind < 0.35 and tall:
        name, spans = "block", ((0.6, 1.6), (0.4, 0.62), (1.8, min(2.3, low - 0.1)))
    elif kind < 0.6 and tall:
        name, spans = "shelf", ((0.7, 1.1), (0.25, 0.4), (1.4, min(2.1, low - 0.1)))
    else:
        name, spans = "block", ((0.6, 2.0), (0.4, 0.9), (0.4, min(1.1, low - 0.2)))
    width, depth, height = (round(rng.uniform(*span), 2) for span in spans)
    count = rng.randint(2, 5) if rng.random() < 0.25 and width < 1.2 else 1
    whole = count * width
    if size < whole + 0.3:
        return
    start = rng.uniform(0.1, size - whole - 0.1)
    gap = 0.02
    p = g.along(g.along(a, u, start), n, -gap)
    q = g.along(p, u, whole)
    outline = [p, q, g.along(q, n, -depth), g.along(p, n, -depth)]
    if height > 0.9 and not room.is_free(i, start, start + whole) or not room.fits(outline, 0.015):
        return
    thing = {"wall": i, "s": round(start + width / 2, 4), "size": [width, depth, height]}
    if count > 1:
        thing["row"] = {"count": count, "gap": 0.0}
    room.furniture.append({name: thing})
    room.taken.append(outline)


def spot_in(rng, room, width, depth, yaw, margin, tries=8):
    x0, y0, x1, y1 = g.bounds(room.outline)
    for _ in range(tries):
        p = (round(rng.uniform(x0, x1), 3), round(rng.uniform(y0, y1), 3))
        outline = g.turned_rectangle(p, width, depth, yaw)
        if room.fits(outline, margin):
            return p, outline
    return None


def table(rng, room):
    width, depth = round(rng.uniform(0.7, 1.8), 2), round(rng.uniform(0.6, 0.9), 2)
    yaw = rng.choice((0, 0, 90, 90, rng.randint(0, 90)))
    spot = spot_in(rng, room, width + 0.1, depth + 1.3, math.radians(yaw), 0.1)
    if not spot:
        return
    p, outline = spot
    things = [{"table": {"at": [0, 0], "size": [width, depth, 0.74]}}]
    if rng.random() < 0.7:
        things.append({"chair": {"at": [0, round(depth / 2 + 0.35, 3)]}})
    room.furniture.append({"group": {"places": [[p[0], p[1], yaw]], "objects": things}})
    room.taken.append(outline)


def screen(rng, room):
    """A partition that does not reach the ceiling: it parts no rooms."""
    width, height = round(rng.uniform(1.2, 3.2), 2), round(rng.uniform(1.2, 1.7), 2)
    yaw = rng.choice((0, 90))
    spot = spot_in(rng, room, width + 0.6, 0.7, math.radians(yaw), 0.2)
    if spot:
        room.furniture.append({"block": {"name": "screen", "at": list(spot[0]), "yaw": yaw,
                                         "size": [width, 0.06, height]}})
        room.taken.append(spot[1])


def lamp(rng, room):
    spot = spot_in(rng, room, 0.6, 0.6, 0.0, 0.3)
    if spot and not any(g.inside(v["outline"], c) for v in room.voids for c in spot[1]):
        room.furniture.append({"lamp": {"at": list(spot[0]), "drop": round(rng.uniform(0.3, 0.7), 2), "radius": 0.2}})


def stations(rng, room):
    """Places from which nearly all of a room is seen: more in large and winding rooms."""
    loops = room.loops()
    probes, places = grid(room, rng)
    if not places:
        return []
    reach = 6.0
    seen_from = {p: {k for k, q in enumerate(probes) if g.length(g.sub(p, q)) < reach and g.sees(p, q, loops)}
                 for p in places}
    chosen, seen = [], set()
    while len(seen) < 0.98 * len(probes) and len(chosen) < 14:
        best = max(places, key=lambda p: len(seen_from[p] - seen) + 0.02 * min(2.0, g.wall_distance(room.outline, p)))
        if not seen_from[best] - seen:
            break
        chosen.append(best)
        seen |= seen_from[best]
    if room.area > 60 and len(chosen) < 2 + room.area / 120:
        chosen.append(rng.choice(places))
    return [with_height(rng, room, p) for p in dict.fromkeys(chosen)]


def with_height(rng, room, p):
    top = room.ceiling_at(p) - room.floor
    return (round(p[0], 3), round(p[1], 3), round(room.floor + min(rng.uniform(1.35, 1.75), 0.7 * top), 3))


def grid(room, rng):
    """Probes all over the floor, and the places among them where a tripod can stand."""
    x0, y0, x1, y1 = g.bounds(room.outline)
    step = max(0.35, math.sqrt(room.area) / 12)
    probes, places = [], []
    nx, ny = max(1, int((x1 - x0) / step)), max(1, int((y1 - y0) / step))
    for i in range(nx):
        for j in range(ny):
            p = (x0 + (i + rng.uniform(0.3, 0.7)) * (x1 - x0) / nx, y0 + (j + rng.uniform(0.3, 0.7)) * (y1 - y0) / ny)
            if not g.inside(room.outline, p) or any(g.inside(c, p) for c in room.columns):
                continue
            probes.append(p)
            if room.is_open(p) and room.is_clear(p) and room.ceiling_at(p) - room.floor > 1.5:
                places.append(p)
    if len(places) > 40:
        places = rng.sample(places, 40)
    return probes, places
