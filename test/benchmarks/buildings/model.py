# SPDX-License-Identifier: BSD-3-Clause
"""A building as rooms with walls, openings and things, and the scene file it makes. Metres, degrees, z up."""
import math

from . import geometry as g


class Room:
    """What the simulator calls a room; `taken` are outlines on its floor where nothing may stand."""

    def __init__(self, name, role, outline, floor, ceiling, storey):
        self.name, self.role, self.outline, self.storey = name, role, outline, storey
        self.floor, self.ceiling = floor, ceiling
        self.facets = []  # of a ceiling that is not level: (outline, height, slope, towards, at)
        self.bulges = {}  # edge -> bulge
        self.tilts = {}  # edge -> degrees into the room
        self.details, self.floor_details, self.ribs, self.voids = [], [], [], []
        self.floor_voids = []  # outlines of the holes in its floor
        self.columns, self.openings, self.niches, self.furniture = [], [], [], []
        self.circles = {}  # of round columns: index -> (centre, radius)
        self.plenum = 0.0
        self.taken, self.used = [], {}
        self.obstacles = []  # outlines of door leaves that stand open, and of stairs
        self.stations = []
        self.wants_station = True

    @property
    def area(self):
        return g.area(self.outline)

    def length(self):
        x0, y0, x1, y1 = g.bounds(self.outline)
        return max(x1 - x0, y1 - y0)

    @property
    def edges(self):
        return g.edges(self.outline)

    def ceiling_at(self, p):
        for outline, height, slope, towards, at in self.facets:
            if g.inside(outline, p):
                rise = math.tan(math.radians(slope))
                u = (math.cos(math.radians(towards)), math.sin(math.radians(towards)))
                return height + rise * g.dot(g.sub(p, at), u)
        return self.ceiling

    def top_along(self, edge, start, end):
        """The lowest ceiling before a part of a wall."""
        if not self.facets:
            return self.lowest_ceiling()
        a, u, n, size = g.frame(self.edges[edge])
        ends = [max(0.01, start), (start + end) / 2, min(size - 0.01, end)]
        return min(self.ceiling_at(g.along(g.along(a, u, s), n, -0.005)) for s in ends)

    def lowest_ceiling(self):
        """Below everything that hangs from the ceiling."""
        drop = max([d["drop"] for d in self.details] + [r["depth"] for r in self.ribs] + [0.0])
        low = min([self.ceiling_at(p) for p in self.inner_corners()] + [self.ceiling]) if self.facets else self.ceiling
        return low - drop

    def inner_corners(self):
        centre = (sum(p[0] for p in self.outline) / len(self.outline), sum(p[1] for p in self.outline) / len(self.outline))
        return [(p[0] + 1e-3 * (centre[0] - p[0]), p[1] + 1e-3 * (centre[1] - p[1])) for p in self.outline]

    def is_free(self, edge, start, end):
        return all(end <= a or start >= b for a, b in self.used.get(edge, []))

    def use(self, edge, start, end):
        self.used.setdefault(edge, []).append((start, end))

    def keep_clear(self, edge, start, end, depth):
        """Keeps the floor before a part of a wall clear."""
        a, u, n, _ = g.frame(self.edges[edge])
        p, q = g.along(a, u, start), g.along(a, u, end)
        self.taken.append([p, q, g.along(q, n, -depth), g.along(p, n, -depth)])

    def fits(self, outline, margin=0.02):
        """True if a convex outline can stand on the floor."""
        probes = outline + [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in g.edges(outline)]
        if not all(g.inside(self.outline, p) and g.wall_distance(self.outline, p) >= margin - 1e-9 for p in probes):
            return False
        if any(g.inside(outline, p) for p in self.outline):
            return False
        return not any(g.meet(outline, t) for t in self.taken)

    def is_open(self, p):
        """True if a tripod can stand at p as far as walls, columns, stairs and door leaves go."""
        return g.inside(self.outline, p) and g.wall_distance(self.outline, p) > 0.3 and \
            not any(g.inside(c, p) for c in self.columns) and \
            not any(g.inside(o, p) or g.wall_distance(o, p) < 0.15 for o in self.obstacles)

    def is_clear_of_walls(self, outline):
        """True if no wall or column crosses the inner part of a convex outline."""
        centre = (sum(p[0] for p in outline) / len(outline), sum(p[1] for p in outline) / len(outline))
        inner = [(p[0] + 0.08 * (centre[0] - p[0]), p[1] + 0.08 * (centre[1] - p[1])) for p in outline]
        return all(g.sees(p, q, self.loops()) for p, q in g.edges(inner)) and \
            not any(g.meet(outline, c) for c in self.columns)

    def is_clear(self, p):
        return not any(g.inside(t, p) for t in self.taken)

    def loops(self):
        return [self.outline] + self.columns

    def to_json(self):
        json = {"name": self.name, "storey": self.storey, "outline": self.outline_json(), "floor": rounded(self.floor)}
        if self.facets:
            json["ceiling"] = slope_json(self.facets[0])
            json["ceiling_details"] = [{"loop": points(f[0]), "height": slope_json(f)} for f in self.facets[1:]]
        else:
            json["ceiling"] = rounded(self.ceiling)
        if self.details:
            json.setdefault("ceiling_details", []).extend(
                {"loop": points(d["loop"]), "drop": d["drop"]} for d in self.details)
        for key in ("floor_details", "ribs", "openings", "niches", "furniture"):
            if getattr(self, key):
                json[key] = getattr(self, key)
        if self.plenum:
            json["plenum"] = rounded(self.plenum)
        if self.voids:
            json["voids"] = [{k: v[k] for k in v if k != "outline"} for v in self.voids]
        if self.columns:
            json["columns"] = [self.column_json(k) for k in range(len(self.columns))]
        return json

    def column_json(self, k):
        if k in self.circles:
            return {"circle": list(self.circles[k][0]), "radius": self.circles[k][1]}
        return points(self.columns[k])

    def outline_json(self):
        return [{"at": list(p), "bulge": self.bulges[k]} if k in self.bulges else list(p)
                for k, p in enumerate(self.outline)]


def rounded(value):
    return round(value, 4)


def points(outline):
    return [list(p) for p in outline]


def slope_json(facet):
    _, height, slope, towards, at = facet
    if slope == 0:
        return height
    return {"height": height, "slope": slope, "towards": towards, "at": list(at)}


class Building:
    """All rooms, and how they are scanned."""

    def __init__(self, name, summary, rng):
        self.name, self.summary, self.rng = name, summary, rng
        self.rooms, self.outside = [], []

    def room(self, name):
        return next(r for r in self.rooms if r.name == name)

    def on_storey(self, storey):
        return [r for r in self.rooms if r.storey == storey]

    def to_json(self, rays, noise, placement):
        stations = [[rounded(v) for v in s] for r in self.rooms for s in r.stations]
        return {"format": "sedr-scene", "version": 1, "name": self.name, "summary": self.summary,
                "rooms": [r.to_json() for r in self.rooms], "outside": self.outside,
                "scanners": [{"stations": stations, "rays": rays, "noise": noise, "jitter": 0.5}],
                "placement": placement}
