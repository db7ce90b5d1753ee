# SPDX-License-Identifier: BSD-3-Clause
"""Plans of a storey: spaces of rectangles between the middle lines of walls, each line with a thickness."""
from . import geometry as g


class Space:
    """A room to be, of rectangles (x0, y0, x1, y1) side by side."""

    def __init__(self, role, *rects):
        self.role, self.rects = role, [tuple(round(v, 2) for v in r) for r in rects]
        self.lift = 0.0  # metres, of its floor above that of the storey

    @property
    def area(self):
        return sum((r[2] - r[0]) * (r[3] - r[1]) for r in self.rects)


class Lines:
    """How thick the walls on each line are."""

    def __init__(self, rng, partitions, outer):
        self.rng, self.partitions, self.outer = rng, partitions, outer
        self.known = {}
        self.has_attic = False  # whether a roof is to be over the highest storey

    def set(self, axis, value, thickness):
        self.known[(axis, round(value, 2))] = thickness

    def __call__(self, axis, value):
        key = (axis, round(value, 2))
        if key not in self.known:
            self.known[key] = self.rng.choice(self.partitions)
        return self.known[key]

    def enclose(self, rect):
        x0, y0, x1, y1 = rect
        for axis, value in ((0, x0), (0, x1), (1, y0), (1, y1)):
            self.set(axis, value, self.outer)


def snapped(value):
    return round(value * 20) / 20


def split(rng, rect, largest, smallest, narrowest):
    """Rectangles of a binary partition, each up to about `largest` square metres."""
    x0, y0, x1, y1 = rect
    w, d = x1 - x0, y1 - y0
    if w * d <= largest * rng.uniform(0.6, 1.2) and max(w, d) < 3 * min(w, d):
        return [rect]
    axis = 0 if w * rng.uniform(0.8, 1.25) > d else 1
    n = w if axis == 0 else d
    low = max(narrowest, smallest / (d if axis == 0 else w))
    if n < 2 * low + 0.1:
        return [rect]
    cut = snapped(rng.uniform(low, n - low))
    if axis == 0:
        parts = (x0, y0, x0 + cut, y1), (x0 + cut, y0, x1, y1)
    else:
        parts = (x0, y0, x1, y0 + cut), (x0, y0 + cut, x1, y1)
    return [r for p in parts for r in split(rng, tuple(round(v, 2) for v in p), largest, smallest, narrowest)]


def row(rng, rect, axis, least, most):
    """Rectangles in a row along an axis, each `least` to `most` metres long."""
    low, high = rect[axis], rect[axis + 2]
    cuts = [low]
    while high - cuts[-1] > most:
        step = snapped(rng.uniform(least, most))
        if high - cuts[-1] - step < least:
            step = snapped((high - cuts[-1]) / 2)
        cuts.append(round(cuts[-1] + step, 2))
    cuts.append(high)
    parts = []
    for a, b in zip(cuts, cuts[1:]):
        r = list(rect)
        r[axis], r[axis + 2] = a, b
        parts.append(tuple(r))
    return parts


def without(rect, hole):
    """What is left of a rectangle that a hole is cut out of, as up to four rectangles."""
    x0, y0, x1, y1 = rect
    a, b, c, d = max(x0, hole[0]), max(y0, hole[1]), min(x1, hole[2]), min(y1, hole[3])
    if a >= c or b >= d:
        return [rect]
    parts = [(x0, y0, a, y1), (c, y0, x1, y1), (a, y0, c, b), (a, d, c, y1)]
    return [p for p in parts if p[2] - p[0] > 0.01 and p[3] - p[1] > 0.01]


def touch(a, b):
    """Metres of edge that two rectangles share."""
    if abs(a[2] - b[0]) < 0.01 or abs(b[2] - a[0]) < 0.01:
        return min(a[3], b[3]) - max(a[1], b[1])
    if abs(a[3] - b[1]) < 0.01 or abs(b[3] - a[1]) < 0.01:
        return min(a[2], b[2]) - max(a[0], b[0])
    return 0.0


def shared(a, b):
    return max(touch(p, q) for p in a.rects for q in b.rects)


def merged(rng, spaces, share, largest):
    """Joins some neighbours to rooms in the shape of an L or a T."""
    spaces = list(spaces)
    for _ in range(len(spaces)):
        if rng.random() > share:
            continue
        a = rng.choice(spaces)
        near = [b for b in spaces if b is not a and b.role == a.role and len(a.rects) + len(b.rects) < 4 and
                a.area + b.area < largest and shared(a, b) > 1.6]
        for b in near[:1]:
            joined = Space(a.role, *a.rects, *b.rects)
            outline = g.union_outline(joined.rects)
            if outline and is_wide(joined, a, b):
                spaces = [s for s in spaces if s is not a and s is not b] + [joined]
    return spaces


def is_wide(joined, a, b):
    """True if nothing between the two looks like the two ends of a wall: at most one corner turns inwards a side."""
    outline = g.union_outline(joined.rects)
    turns = 0
    for k, p in enumerate(outline):
        turns += g.cross(g.sub(p, outline[k - 1]), g.sub(outline[(k + 1) % len(outline)], p)) < 0
    least = min(min(r[2] - r[0], r[3] - r[1]) for s in (a, b) for r in s.rects)
    return turns <= 2 and shared(a, b) > 0.85 * least


def closets(rng, spaces, share):
    """Cuts closets, lavatories or stores of 1.5 to 5 square metres out of the corners of some rooms."""
    out = []
    for space in spaces:
        x0, y0, x1, y1 = space.rects[0]
        w, d = snapped(rng.uniform(1.2, 2.2)), snapped(rng.uniform(1.4, 2.4))
        if rng.random() > share or len(space.rects) > 1 or space.role != "room" or x1 - x0 < w + 2.2 or y1 - y0 < d + 2.2:
            out.append(space)
            continue
        a = x0 if rng.random() < 0.5 else x1 - w
        b = y0 if rng.random() < 0.5 else y1 - d
        hole = (round(a, 2), round(b, 2), round(a + w, 2), round(b + d, 2))
        left, right = (x0, y0, hole[0], y1), (hole[2], y0, x1, y1)
        side = left if left[2] - left[0] > 0.01 else right
        rest = (hole[0], y0, hole[2], hole[1]) if hole[1] > y0 else (hole[0], hole[3], hole[2], y1)
        out += [Space("room", side, rest), Space("closet", hole)]
    return out


def corridor_plan(rng, rect, width, near, far, least, most, stairs=None):
    """A corridor along x with rooms on one side or both; `near`, `far` are their depths, 0 for none."""
    x0, y0, x1, _ = rect
    low, high = round(y0 + near, 2), round(y0 + near + width, 2)
    spaces = []
    if stairs:  # at the end of the corridor, over its whole depth
        spaces.append(Space("stairs", stairs))
        x1 = stairs[0]
    spaces.append(Space("corridor", (x0, low, x1, high)))
    for a, b in ((y0, low), (high, round(high + far, 2))):
        if b - a > 0.5:
            spaces += [Space("room", r) for r in row(rng, (x0, a, x1, b), 0, least, most)]
    return spaces
