# SPDX-License-Identifier: BSD-3-Clause
"""What kinds of building there are: how each storey is laid out, how high it is, what its rooms are like."""
from .layouts import Lines, Space, closets, corridor_plan, merged, row, snapped, split, without

HIDDEN = "hidden"  # a space in which there is no room: a shaft, or the air of a tall room below


class Kind:
    """What the kinds differ in; heights in metres."""

    def __init__(self, storeys, clear, slab, **more):
        self.storeys, self.clear, self.slab = storeys, clear, slab  # choices or ranges
        self.suspended = more.get("suspended", 0.0)   # share of rooms with a suspended ceiling
        self.ribs = more.get("ribs", 0.0)             # share of large rooms with ribs or beams
        self.soffits = more.get("soffits", 0.2)       # share of rooms with a soffit
        self.glass = more.get("glass", 0.1)           # share of facades that are nearly all glass
        self.passages = more.get("passages", 0.1)     # share of doors that are wide passages
        self.full_doors = more.get("full_doors", 0.1)  # share of storeys with doors up to the ceiling
        self.attic = more.get("attic", 0.0)           # share of buildings with sloped ceilings on top
        self.is_fitted = more.get("is_fitted", False)  # cubicles, leaves and cupboards in corridors
        self.vaults = more.get("vaults", 0.0)         # share of rectangular rooms below a barrel vault
        self.galleries = more.get("galleries", 0.0)   # share of the openings of storeys to a hall that are as wide as the wall
        self.niches = more.get("niches", 0.0)         # share of windows with a niche below, and of free walls with one
        self.seen_from_end = more.get("seen_from_end", 0.0)  # share of corridors that were scanned from one end only
        self.is_for_all_seeds = more.get("is_for_all_seeds", True)  # else only when asked for: seeds keep their building


KINDS = {
    "flat": Kind((1,), (2.3, 3.2), (0.25, 0.35), soffits=0.25, passages=0.15, full_doors=0.2),
    "house": Kind((2, 2, 3), (2.3, 2.7), (0.2, 0.35), soffits=0.15, passages=0.15, attic=0.5),
    "office": Kind((1, 2, 3), (2.6, 3.4), (0.25, 0.4), suspended=0.6, glass=0.35, full_doors=0.25),
    "openplan": Kind((1, 1, 2), (2.8, 3.8), (0.3, 0.4), suspended=0.3, ribs=0.7, glass=0.5),
    "school": Kind((1, 2, 2), (3.0, 3.8), (0.25, 0.4), suspended=0.3, ribs=0.4, glass=0.3, passages=0.3),
    "hall": Kind((1, 2), (2.5, 3.0), (0.25, 0.4), ribs=0.8, glass=0.2, passages=0.3),
    "fitted": Kind((1, 1, 2), (2.4, 3.0), (0.25, 0.4), suspended=0.3, glass=0.4, full_doors=0.15, is_fitted=True, is_for_all_seeds=False),
    "cellar": Kind((1,), (2.9, 4.0), (0.4, 0.6), soffits=0.0, glass=0.0, passages=0.1, full_doors=0.0, vaults=0.9, is_for_all_seeds=False),
    "atrium": Kind((2, 2, 3), (2.8, 3.4), (0.3, 0.4), suspended=0.3, glass=0.8, galleries=0.7, seen_from_end=0.5, is_fitted=True, is_for_all_seeds=False),
    "halflevel": Kind((1,), (3.7, 4.3), (0.3, 0.4), glass=0.3, is_for_all_seeds=False),
    "niches": Kind((1,), (2.4, 3.2), (0.25, 0.35), niches=0.5, is_for_all_seeds=False),
}

PARTITIONS = {"flat": (0.08, 0.1, 0.12, 0.15, 0.24), "house": (0.1, 0.12, 0.15, 0.2, 0.3),
              "office": (0.08, 0.1, 0.12, 0.15), "openplan": (0.1, 0.12, 0.2, 0.25),
              "school": (0.12, 0.2, 0.25, 0.3), "hall": (0.15, 0.2, 0.3, 0.4), "fitted": (0.08, 0.1, 0.12, 0.15),
              "cellar": (0.5, 0.6, 0.7, 0.75), "atrium": (0.08, 0.1, 0.12, 0.15), "halflevel": (0.1, 0.12, 0.15, 0.2), "niches": (0.1, 0.15, 0.24, 0.4)}


def lines_for(rng, kind):
    return Lines(rng, PARTITIONS[kind], rng.choice((0.24, 0.3, 0.36, 0.4)))


def flat(rng, _storeys, _flight, kind="flat"):
    w, d = snapped(rng.uniform(8, 15)), snapped(rng.uniform(6.5, 11))
    rect = (0.0, 0.0, w, d)
    lines = lines_for(rng, kind)
    lines.enclose(rect)
    if rng.random() < 0.5:
        width = snapped(rng.uniform(1.1, 1.8))
        near = snapped(rng.uniform(0.35, 0.55) * (d - width))
        spaces = corridor_plan(rng, rect, width, near, d - width - near, 2.4, 5.0)
    else:
        spaces = [Space("room", r) for r in split(rng, rect, 22, 5, 2.0)]
        min(spaces, key=lambda s: abs(s.area - 10)).role = "corridor"
    spaces = closets(rng, merged(rng, spaces, 0.3, 50), 0.35)
    return [spaces], lines


def niches(rng, storeys, flight):
    """A flat with niches in its walls."""
    return flat(rng, storeys, flight, "niches")


def house(rng, storeys, flight):
    w, d = snapped(rng.uniform(8.5, 12)), snapped(rng.uniform(8, 10.5))
    rect = (0.0, 0.0, w, d)
    lines = lines_for(rng, "house")
    lines.enclose(rect)
    length, width = snapped(flight[0] + rng.uniform(2.1, 2.6)), snapped(flight[1] + rng.uniform(0.5, 1.0))
    x = snapped(rng.uniform(2.6, w - width - 2.6))
    hall = (x, 0.0, round(x + width, 2), length if d - length >= 2.4 else d)
    plans = []
    lines.has_attic = rng.random() < KINDS["house"].attic
    for k in range(storeys):
        parts = [(0.0, 0.0, x, d), (hall[2], 0.0, w, d)] + ([(x, hall[3], hall[2], d)] if hall[3] < d else [])
        spaces = [Space("room", r) for p in parts for r in split(rng, p, 20, 5, 2.2)]
        if not (lines.has_attic and k == storeys - 1):  # under a roof all rooms are rectangles
            spaces = closets(rng, merged(rng, spaces, 0.3, 45), 0.25)
        plans.append([Space("stairs", hall)] + spaces)
    return plans, lines


def office(rng, storeys, flight):
    length, width = snapped(rng.uniform(16, 40)), snapped(rng.uniform(1.4, 2.4))
    near, far = snapped(rng.uniform(4, 6.5)), snapped(rng.choice((0, rng.uniform(4, 6.5), rng.uniform(4, 6.5))))
    rect = (0.0, 0.0, length, round(near + width + far, 2))
    lines = lines_for(rng, "office")
    stairs = None
    if storeys > 1:
        wide = snapped(max(flight[1] + 0.6, 3.0))
        stairs = (length, 0.0, round(length + wide, 2), max(rect[3], snapped(flight[0] + 2.4)))
    lines.enclose(rect if not stairs else (0.0, 0.0, stairs[2], rect[3]))
    if stairs:
        lines.set(1, stairs[3], lines.outer)
        lines.set(0, length, 0.24)
    plans = []
    for _ in range(storeys):
        full = rect if not stairs else (0.0, 0.0, stairs[2], rect[3])
        spaces = corridor_plan(rng, full, width, near, far, 2.6, 7.5, stairs)
        spaces = closets(rng, spaces, 0.2)
        if rng.random() < 0.3:  # a meeting place that is open to the corridor over its whole width
            corridor = next(s for s in spaces if s.role == "corridor")
            low = [s for s in spaces if s.role == "room" and len(s.rects) == 1 and s.rects[0][1] == 0.0 and s.area > 12]
            if low:
                bay = rng.choice(low)
                spaces = [s for s in spaces if s is not bay and s is not corridor]
                spaces.append(Space("corridor", *corridor.rects, *bay.rects))
        plans.append(spaces)
    return plans, lines


def fitted(rng, storeys, flight):
    """An office or an open plan that is furnished as one in use."""
    return (office if rng.random() < 0.6 else openplan)(rng, storeys, flight)


def openplan(rng, storeys, flight):
    w, d = snapped(rng.uniform(20, 30)), snapped(rng.uniform(12, 18))
    rect = (0.0, 0.0, w, d)
    lines = lines_for(rng, "openplan")
    lines.enclose(rect)
    wide, deep = snapped(max(flight[1] + 0.5, rng.uniform(3, 4))), snapped(flight[0] + 2.4)
    x = snapped(rng.uniform(0.35, 0.6) * w)
    core = [(x, 0.0, round(x + wide, 2), deep)]
    side = snapped(rng.uniform(2.2, 3.2))
    small = row(rng, (round(x + wide, 2), 0.0, round(x + wide + side, 2), deep), 1, 1.8, 3.2)
    plans = []
    for _ in range(storeys):
        spaces = [Space("stairs" if storeys > 1 else "room", core[0])]
        spaces += [Space("closet" if (r[3] - r[1]) * side < 5 else "room", r) for r in small]
        rest = without(rect, (x, 0.0, round(x + wide + side, 2), deep))
        if rng.random() < 0.5:  # a row of small rooms at one end
            depth = snapped(rng.uniform(3.5, 5))
            cells = row(rng, (0.0, 0.0, depth, d), 1, 3, 6)
            spaces += [Space("room", c) for c in cells]
            rest = [p for r in rest for p in without(r, (0.0, 0.0, depth, d))]
        plans.append(spaces + [Space("open", *rest)])
    return plans, lines


def school(rng, storeys, flight):
    length, width = snapped(rng.uniform(24, 40)), snapped(rng.uniform(2.4, 4.0))
    near = snapped(rng.uniform(6.5, 8.5))
    far = snapped(rng.choice((0, rng.uniform(5, 8))))
    lines = lines_for(rng, "school")
    wide = snapped(max(flight[1] + 0.8, 3.4))
    top = max(round(near + width + far, 2), snapped(flight[0] + 2.4))
    stairs = (length, 0.0, round(length + wide, 2), top) if storeys > 1 else None
    east = stairs[2] if stairs else length
    rect = (0.0, 0.0, east, round(near + width + far, 2))
    lines.enclose(rect)
    lines.set(1, top, lines.outer)
    hall_deep, hall_wide = snapped(rng.uniform(9, 14)), snapped(rng.uniform(8, 13))
    hall = (round(-hall_wide, 2), 0.0, 0.0, max(hall_deep, round(near + width, 2)))
    lines.enclose(hall)
    lines.set(0, 0.0, 0.3)
    plans = []
    for k in range(storeys):
        spaces = corridor_plan(rng, rect, width, near, far, 5.5, 10.0, stairs)
        spaces = closets(rng, spaces, 0.15)
        plans.append(spaces + [Space("hall" if k == 0 else HIDDEN, hall)])
    return plans, lines


def hall(rng, storeys, flight):
    w, d = snapped(rng.uniform(13, 25)), snapped(rng.uniform(9, 16))
    deep = snapped(max(rng.uniform(4, 6), flight[0] + 2.4 if storeys > 1 else 4.0))
    lines = lines_for(rng, "hall")
    main = (0.0, deep, w, round(deep + d, 2))
    lines.enclose((0.0, 0.0, w, main[3]))
    plans = []
    wide = snapped(max(flight[1] + 0.6, 3.0))
    for k in range(storeys):
        start = wide if storeys > 1 else 0.0
        spaces = [Space("room", r) for r in row(rng, (start, 0.0, w, deep), 0, 2.6, 8.0)]
        if storeys > 1:
            spaces.append(Space("stairs", (0.0, 0.0, wide, deep)))
        spaces = closets(rng, spaces, 0.3)
        plans.append(spaces + [Space("hall" if k == 0 else HIDDEN, main)])
    return plans, lines


def cellar(rng, _storeys, _flight):
    """Vaulted rooms behind thick walls, on both sides of a passage or in rows."""
    w, d = snapped(rng.uniform(16, 26)), snapped(rng.uniform(11, 17))
    rect = (0.0, 0.0, w, d)
    lines = lines_for(rng, "cellar")
    lines.enclose(rect)
    if rng.random() < 0.6:
        width = snapped(rng.uniform(2.4, 3.2))
        near = snapped(rng.uniform(0.4, 0.6) * (d - width))
        spaces = corridor_plan(rng, rect, width, near, d - width - near, 3.4, 6.5)
    else:
        spaces = [Space("room", r) for r in split(rng, rect, 45, 12, 3.2)]
    return [spaces], lines


def atrium(rng, storeys, flight):
    """Storeys of rooms along corridors that open to a hall as high as the building."""
    length, width = snapped(rng.uniform(16, 28)), snapped(rng.uniform(1.8, 2.8))
    near, deep = snapped(rng.uniform(4, 6)), snapped(rng.uniform(6, 10))
    lines = lines_for(rng, "atrium")
    wide = snapped(max(flight[1] + 0.8, 3.2))
    stairs = (length, 0.0, round(length + wide, 2), max(round(near + width, 2), snapped(flight[0] + 2.4)))
    edge = round(near + width, 2)
    hall = (0.0, edge, length, round(edge + deep, 2))
    lines.enclose((0.0, 0.0, stairs[2], hall[3]))
    lines.set(0, length, 0.24)
    plans = []
    for k in range(storeys):
        spaces = closets(rng, corridor_plan(rng, (0.0, 0.0, stairs[2], edge), width, near, 0, 2.6, 6.0, stairs), 0.3)
        plans.append(spaces + [Space("hall" if k == 0 else HIDDEN, hall)])
    return plans, lines


def halflevel(rng, _storeys, _flight):
    """A row of rooms on the ground and another half a storey up, with a corridor each; a flight joins these."""
    w, d = snapped(rng.uniform(9, 16)), snapped(rng.uniform(13, 16))
    lines = lines_for(rng, "halflevel")
    lines.enclose((0.0, 0.0, w, d))
    wide, upper = snapped(rng.uniform(3.2, 4.0)), snapped(rng.uniform(1.3, 2.0))
    near = snapped(rng.uniform(0.4, 0.6) * (d - wide - upper))
    low = corridor_plan(rng, (0.0, 0.0, w, d), wide, near, 0, 2.6, 6.0)
    high = corridor_plan(rng, (0.0, round(near + wide, 2), w, d), upper, 0, d - near - wide - upper, 2.6, 6.0)
    lift = rng.uniform(1.2, 1.5)
    for space in high:
        space.lift = lift
    return [closets(rng, low, 0.3) + high], lines


PLANS = {"flat": flat, "house": house, "office": office, "openplan": openplan, "school": school, "hall": hall,
         "cellar": cellar, "fitted": fitted, "atrium": atrium, "halflevel": halflevel, "niches": niches}
