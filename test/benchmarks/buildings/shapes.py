# SPDX-License-Identifier: BSD-3-Clause
"""Walls that are not parallel to the others: chamfered corners, slanting partitions, curved facades."""
import math

from . import geometry as g
from .walls import outer_stretches, walls_between


def chamfer(rng, room):
    """Cuts a corner of a room off at 45 degrees."""
    k = rng.randrange(len(room.outline))
    p, before, after = room.outline[k], room.outline[k - 1], room.outline[(k + 1) % len(room.outline)]
    cut = round(rng.uniform(0.4, 1.2), 3)
    shortest = min(g.length(g.sub(p, before)), g.length(g.sub(after, p)))
    if g.cross(g.sub(p, before), g.sub(after, p)) <= 0 or shortest < cut + 1.8:
        return
    _, u, _, n = g.frame((before, p))
    _, v, _, _ = g.frame((p, after))
    corners = [g.along(before, u, n - cut), g.along(p, v, cut)]
    room.outline[k:k + 1] = [(round(x, 4), round(y, 4)) for x, y in corners]


def slant_partition(rng, a, b):
    """Turns the wall between two rectangular rooms that share a whole side by up to 45 degrees."""
    if not (g.is_rectangle(a.outline) and g.is_rectangle(b.outline)) or a.bulges or b.bulges:
        return False
    for i, k, low, high, depth in walls_between(a, b):
        p, u, n, size = g.frame(a.edges[i])
        other = g.frame(b.edges[k])[3]
        if low > 1e-6 or high < size - 1e-6 or abs(other - size) > 1e-6:
            continue
        far = min(abs(g.dot(g.sub(q, p), n)) for q in a.outline if abs(g.dot(g.sub(q, p), n)) > 1e-6)
        far_b = min(abs(g.dot(g.sub(q, p), n)) - depth for q in b.outline if abs(g.dot(g.sub(q, p), n)) > depth + 1e-6)
        reach = min(size / 2, far - 2.2, far_b - 2.2)
        if reach < 0.5:
            return False
        shift = rng.choice((-1, 1)) * (reach if rng.random() < 0.3 else rng.uniform(0.4, reach))
        widen = depth * (math.hypot(1.0, 2 * shift / size) - 1) / 2  # keeps the wall as thick as it was
        for room, edge, side in ((a, i, -1), (b, k, 1)):
            for t, q in ((edge, room.outline[edge]), ((edge + 1) % 4, room.outline[(edge + 1) % 4])):
                s = g.dot(g.sub(q, p), u)
                move = shift * (2 * s / size - 1) + side * widen
                x, y = g.along(q, n, move)
                room.outline[t] = (round(x, 9), round(y, 9))
        return True
    return False


def curve_facade(rng, room, rooms):
    """Lets a free outer wall swell outwards or inwards by an arc."""
    free = []
    for i, start, end in outer_stretches(room, rooms, 3.0):
        if start < 1e-6 and abs(end - g.frame(room.edges[i])[3]) < 1e-6 and end > 3.0 and i not in room.used:
            free.append((i, end))
    if not free:
        return
    i, size = rng.choice(free)
    rise = rng.uniform(0.08, 0.2) * size
    if rng.random() < 0.3:
        rise = -min(rise, 0.8)
        x0, y0, x1, y1 = g.bounds(room.outline)
        if min(x1 - x0, y1 - y0) < 4:
            return
    room.bulges[i] = round(max(-1.5, min(rise, 1.5)) / (size / 2), 6)
    room.used.setdefault(i, []).append((0.0, size))
    if rise < 0:
        room.keep_clear(i, 0.0, size, 0.1 - rise)
