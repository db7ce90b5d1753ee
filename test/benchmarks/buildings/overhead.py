# SPDX-License-Identifier: BSD-3-Clause
"""Ceilings of single rooms: roofs, vaults, domes, arches, coves, steps. Each function gives False if it does not fit."""
import math

from . import ceilings, geometry as g


def hang(rng, room):
    """Gives a room a random ceiling; the name of its kind."""
    names = sorted(CEILINGS) if g.is_rectangle(room.outline) and not room.bulges else ANYWHERE
    for name in rng.sample(names, k=len(names)):
        if CEILINGS[name](rng, room) is not False:
            return name
    return "level"


def highest(room):
    return max(room.ceiling_at(p) for p in room.inner_corners())


def across(rng, room):
    """An axis of the plan, 0 for x, and the sides of the room along it."""
    x0, y0, x1, y1 = g.bounds(room.outline)
    axis = rng.choice((0, 1, 0 if x1 - x0 < y1 - y0 else 1))
    return (axis,) + ((x0, x1), (y0, y1))[axis]


def strip(room, axis, low, high):
    x0, y0, x1, y1 = g.bounds(room.outline)
    loop = g.rectangle(low, y0, high, y1) if axis == 0 else g.rectangle(x0, low, x1, high)
    return [(round(x, 6), round(y, 6)) for x, y in loop]


def add_vault(room, axis, loop, middle, spring, radius):
    """A cylinder over a loop, across which the axis of the plan runs."""
    at = [middle, 0.0] if axis == 0 else [0.0, middle]
    vault = {"at": at, "direction": 90 if axis == 0 else 0, "height": spring, "radius": radius}

    def z_at(p):
        return spring + math.sqrt(max(0.0, radius ** 2 - (p[axis] - middle) ** 2)) if g.inside(loop, p) else None
    room.curves.append(({"loop": [list(p) for p in loop], "vault": vault}, z_at))


def add_arch(room, axis, loop, low, high, spring, rise):
    half = (high - low) / 2
    radius = (half * half + rise * rise) / (2 * rise)
    add_vault(room, axis, loop, (low + high) / 2, spring + rise - radius, radius + 1e-9)


def level(rng, room):
    """Level, with soffits, coffers, ribs or beams, or without."""
    if rng.random() < 0.4:
        return ceilings.deck(rng, room) if not room.bulges and rng.random() < 0.5 else ceilings.soffit(rng, room)
    return True


def step(rng, room):
    axis, low, high = across(rng, room)
    at = round(low + (high - low) * rng.uniform(0.3, 0.7), 3)
    drop = round(rng.uniform(0.08, min(0.6, room.ceiling - 2.1)), 3)
    room.details.append({"loop": strip(room, axis, low, at), "drop": drop})
    return True


def shed(rng, room):
    x0, y0, x1, y1 = g.bounds(room.outline)
    slope, towards = round(rng.uniform(5, 35), 2), rng.choice((0, 90, 180, 270, rng.randint(0, 359)))
    u = math.cos(math.radians(towards)), math.sin(math.radians(towards))
    at = min(g.rectangle(x0 - 0.8, y0 - 0.8, x1 + 0.8, y1 + 0.8), key=lambda p: g.dot(p, u))
    room.facets = [(room.outline, round(rng.uniform(1.4, 2.4), 3), slope, towards, at)]
    return True


def roof(rng, room):
    """A gable over knee walls, with two slopes, a flat strip between them, or a slope on one side only."""
    axis, low, high = across(rng, room)
    knee, slope = rng.uniform(0.7, 2.0), math.tan(math.radians(rng.uniform(20, 48)))
    ridge = low + (high - low) * rng.choice((0.5, 0.5, rng.uniform(0.35, 0.65)))
    top = knee + slope * (min(ridge - low, high - ridge))
    if top < 2.3 or top > 5.5:
        return False
    kind = rng.random()
    cap = rng.uniform(2.25, top) if kind < 0.4 else top
    run = (cap - knee) / slope
    if kind > 0.8:
        profile = [(low, knee), (low + run, cap), (high, cap)]
    elif cap < top - 0.1:
        profile = [(low, knee), (low + run, cap), (high - run, cap), (high, knee)]
    else:
        profile = [(low, knee), (ridge, top), (high, knee)]
    room.ceiling = round(cap, 4)
    ceilings.facet(room, axis, profile)
    if rng.random() < 0.4:
        dormer(rng, room, axis, low, knee, slope, cap)
    return True


def dormer(rng, room, axis, low, knee, slope, cap):
    """A box cut into the first slope, with a level ceiling."""
    z = round(rng.uniform(max(knee + 0.4, 2.0), max(cap - 0.1, knee + 0.5)), 3)
    run = (z - knee) / slope
    sides = strip(room, axis, low, low + run)
    start, end = min(p[1 - axis] for p in sides), max(p[1 - axis] for p in sides)
    width = round(rng.uniform(1.0, 2.0), 2)
    if z > cap - 0.05 or end - start < width + 1.2:
        return False
    a = round(rng.uniform(start + 0.5, end - 0.5 - width), 3)
    loop = [list(p) for p in (g.rectangle(low, a, low + run, a + width) if axis == 0 else g.rectangle(a, low, a + width, low + run))]
    room.curves.append(({"loop": loop, "height": z}, lambda p: z if g.inside(loop, p) else None))
    return True


def hip(rng, room):
    x0, y0, x1, y1 = g.bounds(room.outline)
    half = min(x1 - x0, y1 - y0) / 2
    if abs((x1 - x0) - (y1 - y0)) < 0.4:
        return False
    eaves, slope = round(rng.uniform(1.6, 2.6), 3), round(rng.uniform(15, 40), 2)
    if x1 - x0 > y1 - y0:
        a, b = (x0 + half, y0 + half), (x1 - half, y0 + half)
        south, east, north, west = [(x0, y0), (x1, y0), b, a], [(x1, y0), (x1, y1), b], [(x1, y1), (x0, y1), a, b], [(x0, y1), (x0, y0), a]
    else:
        a, b = (x0 + half, y0 + half), (x0 + half, y1 - half)
        south, east, north, west = [(x0, y0), (x1, y0), a], [(x1, y0), (x1, y1), b, a], [(x1, y1), (x0, y1), b], [(x0, y1), (x0, y0), a, b]
    room.facets = [(loop, eaves, slope, towards, loop[0]) for loop, towards in ((south, 90), (east, 180), (north, 270), (west, 0))]
    return True


def vault(rng, room):
    """A barrel: half a cylinder or a segment of one."""
    axis, low, high = across(rng, room)
    half = (high - low) / 2
    rise = half if rng.random() < 0.3 and half < 3.2 else half * rng.uniform(0.1, 0.7)
    room.ceiling = round(rng.uniform(max(1.2, 2.4 - rise), 2.4), 3)
    add_arch(room, axis, strip(room, axis, low, high), low, high, room.ceiling, rise)
    return True


def jack_arches(rng, room):
    """Arches side by side; they meet in lines, on level strips or on beams."""
    axis, low, high = across(rng, room)
    count = max(2, round((high - low) / rng.uniform(0.8, 2.2)))
    width = rng.choice((0.0, round(rng.uniform(0.1, 0.25), 3)))
    clear = (high - low - (count - 1) * width) / count
    rise = clear * rng.uniform(0.08, 0.25)
    depth = round(rng.uniform(0.06, 0.25), 3) if width and rng.random() < 0.6 else 0.0
    for k in range(count):
        start = low + k * (clear + width)
        add_arch(room, axis, strip(room, axis, start, start + clear), start, start + clear, room.ceiling, rise)
        if depth and k:
            room.details.append({"loop": strip(room, axis, start - width, start), "drop": depth})
    return True


def cove(rng, room):
    """A level ceiling that curves down to two walls."""
    axis, low, high = across(rng, room)
    radius = round(rng.uniform(0.2, 0.7), 3)
    room.ceiling = round(max(room.ceiling, 2.4), 3)
    for wall, side in ((low, 1), (high, -1)):
        loop = strip(room, axis, *sorted((wall, wall + side * radius)))
        add_vault(room, axis, loop, wall + side * radius, room.ceiling - radius, radius + 1e-9)
    return True


def dome(rng, room):
    """A cap of a sphere or of an ellipsoid in a level ceiling."""
    x0, y0, x1, y1 = g.bounds(room.outline)
    swell = max([-b * g.frame(room.edges[k])[3] / 2 for k, b in room.bulges.items()] + [0.0])
    places = [(rng.uniform(x0, x1), rng.uniform(y0, y1)) for _ in range(60)]
    at = max((p for p in places if g.inside(room.outline, p)), key=lambda p: g.wall_distance(room.outline, p))
    reach = g.wall_distance(room.outline, at) - 0.1 - swell
    if reach < 0.8:
        return False
    at, rim = [round(v, 4) for v in at], round(rng.uniform(0.7, min(reach, 2.5)), 4)
    radius = round(rim * rng.uniform(1.02, 2.2), 4)
    scale = [1.0, 1.0, 1.0]
    if rng.random() < 0.5:
        scale = [1.0, round(rng.uniform(0.6, 1.0), 3), round(rng.uniform(0.4, 1.0), 3)]
    turn = rng.choice((0, 90, rng.randint(0, 179)))
    centre = round(room.ceiling - scale[2] * math.sqrt(radius ** 2 - rim ** 2), 6)
    u = math.cos(math.radians(turn)), math.sin(math.radians(turn))

    def z_at(p):
        d = g.sub(p, at)
        off = math.hypot(g.dot(d, u) / scale[0], g.cross(u, d) / scale[1])
        return centre + scale[2] * math.sqrt(radius ** 2 - off ** 2) if off < rim else None
    room.curves.append(({"dome": {"at": at, "height": centre, "radius": radius, "rim": rim, "scale": scale, "direction": turn}}, z_at))
    return True


CEILINGS = {f.__name__: f for f in (level, step, shed, roof, hip, vault, jack_arches, cove, dome)}
ANYWHERE = ["dome", "level", "shed"]
