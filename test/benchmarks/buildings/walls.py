# SPDX-License-Identifier: BSD-3-Clause
"""Doors, passages, galleries and windows in the walls between rooms and to the outside."""
import math
import random

from . import geometry as g

MARGIN = 0.15        # metres from a door to the next corner
THICKEST = 0.8       # metres of wall that an opening goes through
DOOR_ROLES = ("corridor", "stairs", "open", "hall")


def walls_between(a, b):
    """(edge of a, edge of b, start, end along a's edge, thickness) of the straight walls that two rooms share."""
    found = []
    for i, e in enumerate(a.edges):
        p, u, n, size = g.frame(e)
        for k, f in enumerate(b.edges):
            q, v, _, _ = g.frame(f)
            depth = g.dot(g.sub(q, p), n)
            if i in a.bulges or k in b.bulges or g.dot(u, v) > -1 + 1e-9 or not 0.03 < depth < THICKEST:
                continue
            ends = sorted(g.dot(g.sub(x, p), u) for x in f)
            low, high = max(0.0, ends[0]), min(size, ends[1])
            if high - low > 0.3:
                found.append((i, k, low, high, round(depth, 6)))
    return found


def along_other(a, b, i, k, start, end):
    """The same stretch as metres along b's edge."""
    p, u, _, _ = g.frame(a.edges[i])
    q, v, _, _ = g.frame(b.edges[k])
    return sorted(g.dot(g.sub(g.along(p, u, s), q), v) for s in (start, end))


def place(rng, a, b, width, margin=MARGIN, least=0.0):
    """(edge of a, edge of b, start, end, thickness) of a free stretch of wall of that width; None if there is none.

    The ceilings on both sides are at the height `least` or higher."""
    walls = walls_between(a, b)
    rng.shuffle(walls)
    for i, k, low, high, depth in walls:
        if high - low < width + 2 * margin:
            continue
        for _ in range(12):
            start = round(rng.uniform(low + margin, high - margin - width), 3)
            other = along_other(a, b, i, k, start, start + width)
            if a.is_free(i, start - 0.12, start + width + 0.12) and b.is_free(k, other[0] - 0.12, other[1] + 0.12) and \
                    min(a.top_along(i, start, start + width), b.top_along(k, *other)) >= least:
                return i, k, start, round(start + width, 3), depth
    return None


def reserve(a, b, spot, depth_a, depth_b):
    i, k, start, end, _ = spot
    other = along_other(a, b, i, k, start, end)
    a.use(i, start, end)
    b.use(k, *other)
    if depth_a:
        a.keep_clear(i, start, end, depth_a)
    if depth_b:
        b.keep_clear(k, *other, depth_b)


def add_door(rng, a, b, style, passages):
    """A door or passage between two rooms; True if there was a place for it."""
    if abs(a.floor - b.floor) > 0.3:
        return add_raised_door(rng, *sorted((a, b), key=lambda r: r.floor))
    sill = max(a.floor, b.floor)
    top = min(a.lowest_ceiling(), b.lowest_ceiling())
    wide = rng.uniform(1.4, 4.0)
    is_large = min(a.area, b.area) > 7 and "closet" not in (a.role, b.role) and a.area + b.area > 25
    if is_large and rng.random() < passages and top - sill > 2.4:
        spot = place(rng, a, b, round(wide, 2), 0.3)
        if spot:
            reserve(a, b, spot, 1.0, 1.0)
            head = min(top - rng.uniform(0.2, 0.6), sill + 3.0)
            if rng.random() < 0.15 and not (a.facets or b.facets) and abs(a.lowest_ceiling() - b.lowest_ceiling()) < 1e-9:
                head = top  # no lintel: one room and two are both right
            a.openings.append(dressed(a, opening(spot, sill, head, b.name), top))
            return True
    width = round(rng.uniform(0.75, 0.85) if "closet" in (a.role, b.role) else rng.uniform(0.8, 1.2), 2)
    spot = place(rng, a, b, width, MARGIN, sill + 1.95) or place(rng, a, b, 0.75, 0.11, sill + 1.95)
    if not spot:
        return False
    i, k, start, end, _ = spot
    top = min(a.top_along(i, start, end), b.top_along(k, *along_other(a, b, i, k, start, end)))
    top -= 0.01 if a.facets or b.facets else 0.0
    head = top if style == "full" and not (a.facets or b.facets) else min(sill + rng.choice((2.0, 2.05, 2.1, 2.2)), top)
    if head - sill < 1.9:
        return False
    door = opening(spot, sill, head, b.name)
    kind = rng.random()
    if kind < 0.12 and a.role != "closet" and a.wants_station and b.wants_station:
        door["leaf"] = {"hinge": "from", "angle": 0}
    elif kind < 0.8 and style != "full" and not a.facets:
        size = g.length(g.sub(*a.edges[spot[0]]))
        for _ in range(6 if spot[2] > 0.12 and spot[3] < size - 0.12 else 0):
            door["leaf"] = {"hinge": rng.choice(("from", "to")), "angle": rng.choice((30, 45, 60, 75, 90, 90, 110))}
            outline = leaf_outline(a, door)
            if all(g.inside(a.outline, p) for p in outline[1:3]) and a.is_clear_of_walls(outline):
                a.obstacles.append(outline)
                a.taken.append(outline)
                break
            del door["leaf"]
    reserve(a, b, spot, 1.05, 0.8)
    a.openings.append(dressed(a, door, top) if not (a.facets or b.facets) else door)
    return True


def add_raised_door(rng, lower, upper):
    """A door half a storey up in the wall of a corridor, with a flight of stairs before it."""
    climb = upper.floor - lower.floor
    steps = math.ceil(climb / 0.18) - 1
    rise, run, width = climb / (steps + 1), 0.27 * steps, round(rng.uniform(0.9, 1.2), 2)
    if "corridor" not in (lower.role, upper.role) or lower.role == "room" or upper.role == "room":
        return False
    for _ in range(10):
        spot = place(rng, upper, lower, width, 0.2, upper.floor + 2.05)
        if not spot:
            return False
        a, u, n, _ = g.frame(upper.edges[spot[0]])  # n points down the stairs, out of the upper room
        top = g.along(g.along(a, u, (spot[2] + spot[3]) / 2), n, spot[4] + 0.01)
        foot = g.along(top, n, run)
        body = [g.along(p, u, s * width / 2) for p, s in ((top, -1), (top, 1), (foot, 1), (foot, -1))]
        whole = body[:2] + [g.along(p, n, 0.8) for p in body[2:]]
        if all(g.inside(lower.outline, p) for p in whole) and not any(g.meet(whole, t) for t in lower.taken):
            break
    else:
        return False
    lower.furniture.append({"stairs": {"at": [round(v, 4) for v in foot], "yaw": round(math.degrees(math.atan2(n[0], -n[1])), 3),
                                       "width": width, "rise": rise, "going": 0.27, "steps": steps}})
    lower.taken.append(whole)
    lower.obstacles.append(body)
    reserve(upper, lower, spot, 1.05, 0.0)
    upper.openings.append(opening(spot, upper.floor, upper.floor + 2.05, lower.name))
    return True


def dressed(room, hole, top):
    """Gives one opening in ten an arched head, passages up to 2.6 m wide a pair of leaves, one window in four a blind. The
    choice is the place's own, so that the building stays as it is without."""
    rng = random.Random(f"{room.name} {hole['wall']} {hole['from']}")
    width, height = hole["to"] - hole["from"], hole["head"] - hole["sill"]
    if rng.random() < 0.1 and hole["head"] < top and hole.get("leaf", {}).get("angle") != 0:
        rise = rng.choice((0.5, 0.5, 0.25)) * width
        hole["head"] = round(min(hole["head"] + rise, top - 0.05), 4) if "leads_to" in hole else hole["head"]
        hole["rise"] = round(min(rise, 0.4 * height), 4)
    if 1.2 < width < 2.6 and hole["head"] < top and height < 2.6 and "leads_to" in hole:
        hole["leaf"] = {"hinge": "both", "angle": rng.choice((45, 80, 90, 90))}
        middle = (hole["from"] + hole["to"]) / 2
        for end, far in (("from", "to"), ("to", "from")):
            room.obstacles.append(leaf_outline(room, {**hole, far: middle, "leaf": dict(hole["leaf"], hinge=end)}))
    if "glazing" in hole and rng.random() < 0.25 and room.wants_station:
        hole["blind"] = rng.choice((0.3, 0.6, 1.0, 1.0))
    return hole


def leaf_outline(room, door):
    a, u, n, _ = g.frame(room.edges[door["wall"]])
    width, angle = door["to"] - door["from"], math.radians(door["leaf"]["angle"])
    s, way = (door["from"] - 0.03, 1) if door["leaf"]["hinge"] == "from" else (door["to"] + 0.03, -1)
    hinge = g.along(a, u, s)
    along = (way * math.cos(angle) * u[0] - math.sin(angle) * n[0], way * math.cos(angle) * u[1] - math.sin(angle) * n[1])
    return g.turned_rectangle(g.along(hinge, along, width / 2), width, 0.1, math.atan2(along[1], along[0]))


def opening(spot, sill, head, leads_to=None):
    i, _, start, end, depth = spot
    json = {"wall": i, "from": start, "to": end, "sill": round(sill, 4), "head": round(head, 4), "depth": depth}
    if leads_to:
        json["leads_to"] = leads_to
    return json


def connect(rng, rooms, kind, style):
    """Doors along a tree over the rooms of a storey, corridors first, and a few more; False if a room stays alone."""
    todo = sorted(rooms, key=lambda r: (r.role not in DOOR_ROLES, -r.area))
    joined = [todo.pop(0)]
    alone = []
    while todo:
        for room in todo:
            near = sorted((r for r in joined if r.role != "closet"), key=lambda r: (r.role not in DOOR_ROLES, rng.random()))
            near += [r for r in joined if r.role == "closet"]
            if any(add_door(rng, room, r, style, kind.passages) for r in near):
                joined.append(room)
                todo.remove(room)
                break
        else:
            alone.append(todo.pop(0))
    for a in joined:
        for b in joined:
            if a.name < b.name and a.role == b.role == "room" and rng.random() < 0.12:
                add_door(rng, a, b, style, kind.passages)
    return not alone


def add_galleries(rng, tall, rooms, wide=0.0):
    """Openings of upper rooms to a tall one beside them, above a parapet; a share `wide` of those of corridors along the wall."""
    for room in rooms:
        spot = None
        if room.floor > tall.floor + 1.5 and room.role != "closet" and rng.random() < 0.4:
            spot = place(rng, room, tall, round(rng.uniform(1.5, 3.0), 2), 0.3)
        if wide and room.floor > tall.floor + 1.5 and room.role == "corridor" and rng.random() < wide:
            spot = next((s for share in (0.95, 0.7, 0.4, 0.2) for s in [place(rng, room, tall, round(share * room.length(), 2), 0.1)] if s), spot)
        if spot:
            sill = room.floor + rng.uniform(0.9, 1.1)
            head = min(room.lowest_ceiling() - 0.2, tall.lowest_ceiling() - 0.2, sill + 1.4)
            if head - sill > 0.5:
                room.openings.append(opening(spot, sill, head, tall.name))
                reserve(room, tall, spot, 0.0, 0.0)


def outer_stretches(room, rooms, reach=1.2):
    """(edge, start, end) of the straight walls behind which no room is."""
    others = [r for r in rooms if r is not room and r.floor < room.ceiling and room.floor < r.ceiling]
    found = []
    for i, e in enumerate(room.edges):
        if i in room.bulges:
            continue
        p, u, n, size = g.frame(e)
        steps = max(2, int(size / 0.2))
        start = None
        for k in range(steps + 1):
            s = min(size, (k + 0.5) * size / steps)
            is_outer = k < steps and not any(g.inside(r.outline, g.along(g.along(p, u, s), n, d))
                                             for r in others for d in (0.06, 0.15, 0.3, 0.5, 0.8, reach))
            if is_outer and start is None:
                start = k * size / steps
            if not is_outer and start is not None:
                if k * size / steps - start > 0.8:
                    found.append((i, start, k * size / steps))
                start = None
    return found


def add_windows(rng, room, rooms, kind, thickness):
    floor = room.floor
    for i, start, end in outer_stretches(room, rooms):
        size = end - start
        top = room.top_along(i, start, end) - (0.05 if room.facets else 0.0)
        if room.role in ("closet", "stairs") and rng.random() < 0.6 or rng.random() < 0.12:
            continue
        if rng.random() < kind.glass and size > 2.0:
            panes = [(start + 0.12, end - 0.12)]
            sill, head = floor + rng.choice((0.0, 0.05, 0.4)), top - rng.choice((0.0, 0.1, 0.3))
        else:
            width = min(rng.uniform(0.8, 2.2), size - 0.5)
            count = max(1, int(size / (width + rng.uniform(0.6, 2.0))))
            pitch = size / count
            panes = [(start + (k + 0.5) * pitch - width / 2, start + (k + 0.5) * pitch + width / 2) for k in range(count)]
            sill, head = floor + rng.uniform(0.7, 1.0), floor + rng.uniform(1.9, 2.3)
        head = min(head, top)
        if head - sill < 0.4:
            continue
        for a, b in panes:
            a, b = round(a, 3), round(b, 3)
            if b - a > 0.4 and room.is_free(i, a - 0.1, b + 0.1):
                room.use(i, a, b)
                window = opening((i, 0, a, b, round(thickness, 3)), sill, head)
                window["glazing"] = {}
                room.openings.append(dressed(room, window, top))
    for i, bulge in room.bulges.items():
        if i not in room.tilts:
            add_curved_windows(room, i, bulge, thickness)


def add_niches(rng, room, rooms, share):
    """Niches below a share of the windows, and a fireplace, a cupboard's or a shelf's in the free walls."""
    for window in [o for o in room.openings if "glazing" in o and o["wall"] not in room.bulges]:
        head = window["sill"] - rng.choice((0.0, 0.04, 0.1))
        if rng.random() < share and head - room.floor > 0.4:
            add_niche(room, window["wall"], window["from"], window["to"], 0.0, head - room.floor, rng.uniform(0.06, window["depth"] - 0.06))
    solid = [(*at, 0.6) for at in outer_stretches(room, rooms)]
    solid += [(i, low, high, depth - 0.06) for other in rooms if other is not room for i, _, low, high, depth in walls_between(room, other)]
    for i, low, high, thick in solid:
        width, bottom, height = rng.choice(((rng.uniform(0.7, 1.2), 0.0, rng.uniform(0.7, 1.1)), (rng.uniform(0.7, 1.6), 0.0, rng.uniform(1.8, 2.2)),
                                            (rng.uniform(0.4, 1.6), rng.uniform(0.5, 1.3), rng.uniform(0.35, 1.2))))
        if thick < 0.1 or high - low < width + 0.3 or rng.random() > share or room.top_along(i, low, high) < room.floor + bottom + height + 0.15:
            continue
        start = rng.uniform(low + 0.15, high - 0.15 - width)
        if room.is_free(i, start - 0.12, start + width + 0.12):
            room.use(i, start, start + width)
            add_niche(room, i, start, start + width, bottom, height, rng.uniform(0.08, thick))


def add_niche(room, wall, start, end, bottom, height, depth):
    room.keep_clear(wall, start, end, 0.5)
    room.niches.append({"wall": wall, "from": round(start, 3), "to": round(end, 3), "sill": round(room.floor + bottom, 4),
                        "head": round(room.floor + bottom + height, 4), "depth": round(depth, 3)})


def add_curved_windows(room, wall, bulge, thickness):
    """Windows side by side in a curved wall, measured along its arc."""
    rng = random.Random(f"{room.name} {wall} {bulge}")
    turn = 4 * math.atan(abs(bulge))
    chord = g.length(g.sub(*room.edges[wall]))
    size = turn * chord / (2 * math.sin(turn / 2))
    count = rng.randint(1, max(1, int(size / 2)))
    width = rng.uniform(0.8, min(1.8, size / count - 0.5))
    # A slope goes on down over the part of an arc beyond the outline.
    fall = max([math.tan(math.radians(slope)) for _, _, slope, _, _ in room.facets] + [0.0]) * max(0.0, bulge) * chord / 2
    sill, head = room.floor + rng.uniform(0.7, 1.0), min(room.floor + rng.uniform(1.9, 2.3), room.lowest_ceiling() - fall)
    if head - sill < 0.4:
        return
    for k in range(count):
        middle = (k + 0.5) * size / count
        window = opening((wall, 0, round(middle - width / 2, 3), round(middle + width / 2, 3), round(thickness, 3)), sill, head)
        room.openings.append(dict(window, glazing={}))
