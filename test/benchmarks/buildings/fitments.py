# SPDX-License-Identifier: BSD-3-Clause
"""What parts the air of a room and no rooms: cubicles, leaves of doors and cupboards in corridors, all lower than the ceiling."""
import math

from . import geometry as g

THIN = 0.03  # metres, of a partition and of a leaf


def fit_out(rng, building):
    """Cubicles in some rooms, leaves and cupboards in corridors."""
    for room in building.rooms:
        if room.facets or room.bulges:
            continue
        if room.role == "room" and 6 < room.area < 45 and rng.random() < 0.5:
            cubicles(rng, room)
        if room.role in ("corridor", "open"):
            for _ in range(int(room.area / rng.uniform(8, 20))):
                cupboard(rng, room)
        if room.role in ("corridor", "room", "open"):
            leaves(rng, room)


def headroom(room):
    return room.lowest_ceiling() - room.floor


def stand(room, at, towards, width, height):
    """A thin upright plate from a place in a direction; True if it stands in the room."""
    yaw = math.atan2(towards[1], towards[0])
    middle = g.along(at, towards, width / 2)
    outline = g.turned_rectangle(middle, width, THIN, yaw)
    if not all(g.inside(room.outline, p) for p in outline) or any(g.meet(outline, c) for c in room.columns):
        return False
    room.furniture.append({"block": {"name": "partition", "at": [round(v, 4) for v in middle],
                                     "yaw": round(math.degrees(yaw), 3), "size": [round(width, 3), THIN, height]}})
    room.obstacles.append(outline)
    return True


def cubicles(rng, room):
    """A row of cubicles before a wall without doors, each with a leaf that is closed, ajar or open."""
    i = max(range(len(room.edges)), key=lambda k: g.frame(room.edges[k])[3] - (100 if room.used.get(k) else 0))
    a, u, n, size = g.frame(room.edges[i])
    inwards = (-n[0], -n[1])
    wide, deep = rng.uniform(0.85, 1.1), rng.uniform(1.2, 1.6)
    count = min(int((size - 0.1) / wide), rng.randint(2, 6))
    height = round(min(rng.uniform(1.8, 2.15), headroom(room) - rng.uniform(0.2, 0.6)), 2)
    first = 0.02 if rng.random() < 0.6 else rng.uniform(0.02, max(0.03, size - count * wide - 0.05))
    p = g.along(g.along(a, u, first), inwards, 0.02)
    q = g.along(p, u, count * wide)
    outline = [p, q, g.along(q, inwards, deep + 0.8), g.along(p, inwards, deep + 0.8)]
    if count < 2 or not all(g.inside(room.outline, c) for c in outline) or any(g.meet(outline, t) for t in room.taken):
        return
    room.taken.append(outline)
    for k in range(count + 1):
        stand(room, g.along(p, u, k * wide), inwards, deep, height)
    for k in range(count):
        front = g.along(g.along(p, u, k * wide + 0.02), inwards, deep)
        stand(room, front, u, 0.2, height)
        angle = rng.choice((0.0, 0.5, 1.2, 1.5))
        leaf = (math.cos(angle) * u[0] + math.sin(angle) * n[0], math.cos(angle) * u[1] + math.sin(angle) * n[1])
        stand(room, g.along(front, u, 0.22), leaf, wide - 0.28, height)


def leaves(rng, room):
    """Leaves of doors that stand open into a room, as high as a door."""
    for i, spans in sorted(room.used.items()):
        if i in room.bulges:
            continue
        a, u, n, _ = g.frame(room.edges[i])
        for start, end in spans:
            if not 0.7 < end - start < 1.3 or rng.random() < 0.5:
                continue
            angle = rng.choice((0.8, 1.2, 1.57, 1.57, 2.0))
            leaf = (math.cos(angle) * u[0] - math.sin(angle) * n[0], math.cos(angle) * u[1] - math.sin(angle) * n[1])
            hinge = g.along(g.along(a, u, start - 0.03), n, -0.04)
            stand(room, hinge, leaf, end - start - 0.05, round(min(2.05, headroom(room) - 0.1), 2))


def cupboard(rng, room):
    """A cupboard before a wall, up to just below the ceiling or not."""
    i = rng.randrange(len(room.edges))
    a, u, n, size = g.frame(room.edges[i])
    width, depth = round(rng.uniform(0.6, 2.5), 2), round(rng.uniform(0.35, 0.65), 2)
    if size < width + 0.2:
        return
    start = rng.uniform(0.05, size - width - 0.05)
    p = g.along(g.along(a, u, start), n, -0.02)
    q = g.along(p, u, width)
    outline = [p, q, g.along(q, n, -depth), g.along(p, n, -depth)]
    way = [g.along(q, n, -depth - 0.7), g.along(p, n, -depth - 0.7)]
    if not (room.is_free(i, start, start + width) and room.fits(outline, 0.015) and all(g.inside(room.outline, c) for c in way)):
        return
    height = round(headroom(room) - rng.choice((0.02, 0.1, 0.3, 0.6)), 2)
    room.furniture.append({"block": {"wall": i, "s": round(start + width / 2, 4), "size": [width, depth, height]}})
    room.taken.append(outline)
    room.obstacles.append(outline)
