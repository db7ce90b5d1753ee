# SPDX-License-Identifier: BSD-3-Clause
"""Ceilings: suspended ones with missing tiles, ribs and beams on columns, soffits and coffers, attics and vaults."""
import math

from . import geometry as g


def suspend(rng, room):
    """A ceiling below the slab; now and then some tiles are missing and the space above it is seen."""
    drop = round(rng.uniform(0.2, 0.6), 3)
    if room.ceiling - drop - room.floor < 2.2:
        return
    room.ceiling = round(room.ceiling - drop, 4)
    room.plenum = round(drop - 0.01, 4)
    if rng.random() > 0.6:
        return
    x0, y0, x1, y1 = g.bounds(room.outline)
    swell = max([-b * g.frame(room.edges[k])[3] / 2 for k, b in room.bulges.items()] + [0.0])  # of walls that curve inwards
    for _ in range(rng.randint(1, 6)):
        x, y = round(rng.uniform(x0, x1 - 0.6), 3), round(rng.uniform(y0, y1 - 0.6), 3)
        tile = g.rectangle(x, y, round(x + 0.6, 4), round(y + 0.6, 4))
        others = [v["outline"] for v in room.voids] + room.columns
        if all(g.inside(room.outline, p) and g.wall_distance(room.outline, p) > 0.05 + swell for p in tile) and \
                not any(g.inside(tile, p) for p in room.outline) and not any(g.meet(tile, o) for o in others):
            room.voids.append({"loop": [list(p) for p in tile], "outline": tile})


def deck(rng, room):
    """Ribs, beams or both; columns stand under beams of wide rooms."""
    x0, y0, x1, y1 = g.bounds(room.outline)
    long_axis = 0 if x1 - x0 > y1 - y0 else 1
    spare = room.ceiling - room.floor - 2.3
    if spare < 0.15 or room.voids or room.columns:
        return
    beam_way = 90 if long_axis == 0 else 0  # beams span the short way
    kind = rng.random()
    if kind < 0.75:
        spacing, width = round(rng.uniform(2.4, 5.0), 2), round(rng.uniform(0.2, 0.45), 3)
        depth = round(min(spare, rng.uniform(0.2, 0.6)), 3)
        beams = {"direction": beam_way, "spacing": spacing, "width": width, "depth": depth}
    else:
        beams = None
    if kind > 0.45 and room.area < 450:
        way = 90 - beam_way
        room.ribs.append({"direction": way, "spacing": rng.choice((0.3, 0.45, 0.6, 0.75)),
                          "width": rng.choice((0.1, 0.12, 0.15)), "depth": round(min(spare, rng.uniform(0.12, 0.35)), 3)})
    if beams:
        if room.ribs:
            beams["depth"] = round(min(spare, max(beams["depth"], room.ribs[0]["depth"] + 0.05)), 3)
            if beams["depth"] <= room.ribs[0]["depth"] + 0.02:
                room.ribs = []
        room.ribs.append(beams)
        if rng.random() < 0.7:
            columns_under(rng, room, beams, long_axis)


def shaft(rng, room):
    """A closed shaft of lifts that stands free in the room: to the scanner, a large column."""
    x0, y0, x1, y1 = g.bounds(room.outline)
    w, d = rng.uniform(1.6, 4.5), rng.uniform(1.6, 3.0)
    for _ in range(20):
        p = rng.uniform(x0, x1), rng.uniform(y0, y1)
        outline = [(round(x, 4), round(y, 4)) for x, y in g.turned_rectangle(p, w, d, 0.0)]
        holes = [v["outline"] for v in room.voids] + room.floor_voids
        if room.fits(outline, 1.6) and not any(g.meet(outline, h) for h in holes):
            room.columns.append(outline)
            room.taken.append(g.turned_rectangle(p, w + 0.1, d + 0.1, 0.0))
            return


def columns_under(rng, room, beams, long_axis):
    """Square or round columns under the middles of beams, where they are clear of walls and doors."""
    x0, y0, x1, y1 = g.bounds(room.outline)
    low, high = ((x0, x1), (y0, y1))[long_axis]
    across = ((y0, y1), (x0, x1))[long_axis]
    half = beams["width"] / 2 - 0.02
    if across[1] - across[0] < 6 or half < 0.08:
        return
    is_round = rng.random() < 0.4
    lanes = [0.5] if across[1] - across[0] < 11 else [0.33, 0.67]
    # The first beam is half a spacing off the right end, seen along the beams: x1 for those that run along y.
    if long_axis == 0:
        middles = [x1 - beams["spacing"] * (k + 0.5) for k in range(50)]
    else:
        middles = [y0 + beams["spacing"] * (k + 0.5) for k in range(50)]
    # A corner of the room cuts the beam over it in two, and a column must not stand across that cut.
    corners = [p[long_axis] for p in room.outline]
    for middle in middles:
        if any(abs(c - middle) < beams["width"] / 2 + 0.01 for c in corners):
            continue
        for lane in lanes:
            c = across[0] + lane * (across[1] - across[0])
            p = (middle, c) if long_axis == 0 else (c, middle)
            column = g.turned_rectangle(p, 2 * half, 2 * half, 0.0)
            if low < middle < high and room.fits(column, 0.5):
                if is_round:
                    room.circles[len(room.columns)] = ((round(p[0], 4), round(p[1], 4)), round(half, 4))
                room.columns.append([(round(x, 4), round(y, 4)) for x, y in column])
                room.taken.append(g.turned_rectangle(p, 2 * half + 0.1, 2 * half + 0.1, 0.0))


def soffit(rng, room):
    """A soffit along a wall, or coffers."""
    if not g.is_rectangle(room.outline) or room.columns or room.voids or room.facets or room.bulges:
        return
    x0, y0, x1, y1 = g.bounds(room.outline)
    drop = round(rng.uniform(0.12, 0.4), 3)
    if room.ceiling - drop - room.floor < 2.15 or min(x1 - x0, y1 - y0) < 2.2:
        return
    wide = round(rng.uniform(0.3, 0.9), 3)
    if rng.random() < 0.7:
        side = rng.randrange(4)
        loop = (g.rectangle(x0, y0, x1, y0 + wide), g.rectangle(x1 - wide, y0, x1, y1),
                g.rectangle(x0, y1 - wide, x1, y1), g.rectangle(x0, y0, x0 + wide, y1))[side]
        room.details.append({"loop": [(round(x, 4), round(y, 4)) for x, y in loop], "drop": drop})
    elif room.area > 15:
        room.details.append({"loop": [(round(x, 4), round(y, 4)) for x, y in g.rectangle(x0, y0, x1, y1)], "drop": drop})
        room.details.append({"loop": [(round(x, 4), round(y, 4)) for x, y in
                                      g.rectangle(x0 + wide, y0 + wide, x1 - wide, y1 - wide)], "drop": 0})


def facet(room, axis, profile):
    """Gives a rectangular room a ceiling of strips between the points (place along the axis, z) of a profile."""
    x0, y0, x1, y1 = g.bounds(room.outline)
    pieces = []
    for (a, za), (b, zb) in zip(profile, profile[1:]):
        low, high = ((x0, x1), (y0, y1))[axis]
        c, d = max(a, low), min(b, high)
        if d - c < 1e-3:
            continue
        loop = g.rectangle(c, y0, d, y1) if axis == 0 else g.rectangle(x0, c, x1, d)
        slope = math.degrees(math.atan2(zb - za, b - a))
        towards = (0, 90)[axis] if slope >= 0 else (180, 270)[axis]
        at = (a, 0.0) if axis == 0 else (0.0, a)
        pieces.append((loop, za, abs(slope), towards, at))
    room.facets = pieces


def attic(rng, rooms, bounds, clear):
    """One roof over all rooms of a storey: a gable along the longer side, capped by a flat ceiling."""
    x0, y0, x1, y1 = bounds
    axis = 1 if x1 - x0 > y1 - y0 else 0
    low, high = ((x0, x1), (y0, y1))[axis]
    floor = rooms[0].floor
    knee = floor + rng.uniform(1.05, 1.6)
    slope = math.tan(math.radians(rng.uniform(25, 44)))
    middle = (low + high) / 2
    top = knee + slope * (middle - low)
    cap = floor + clear
    if top > cap:
        run = (cap - knee) / slope
        profile = [(low, knee), (low + run, cap), (high - run, cap), (high, knee)]
    else:
        profile = [(low, knee), (middle, top), (high, knee)]
    for room in rooms:
        room.ceiling = round(max(z for _, z in profile), 4)
        facet(room, axis, profile)


def vault(rng, room):
    """A barrel vault of twelve facets over a rectangular room, springing a metre or so above the walls' feet."""
    x0, y0, x1, y1 = g.bounds(room.outline)
    axis = 1 if x1 - x0 > y1 - y0 else 0
    low, high = ((x0, x1), (y0, y1))[axis]
    rise = min(0.2 * (high - low), 0.3 * (room.ceiling - room.floor)) * rng.uniform(0.6, 1.0)
    half = (high - low) / 2
    radius = (half * half + rise * rise) / (2 * rise)
    reach = math.asin(half / radius)
    spring = room.ceiling - rise
    profile = []
    for k in range(13):
        angle = -reach + 2 * reach * k / 12
        profile.append((low + half + radius * math.sin(angle), spring + radius * math.cos(angle) - radius + rise))
    facet(room, axis, profile)
