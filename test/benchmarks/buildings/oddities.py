# SPDX-License-Identifier: BSD-3-Clause
"""Rooms with one thing that is easily taken for another: what odd_scenes.py scans."""
import math


def rectangle(x0, y0, x1, y1):
    return {"rectangle": [[round(x0, 3), round(y0, 3)], [round(x1, 3), round(y1, 3)]]}


class Scene:
    """A rectangle of a room with a door and a window, to which one oddity is added."""

    def __init__(self, rng):
        self.rng = rng
        self.x, self.y = round(rng.uniform(3.6, 7.5), 2), round(rng.uniform(3.2, 5.5), 2)
        self.height = round(rng.uniform(2.4, 3.2), 2)
        self.room = {"name": "room", "outline": rectangle(0, 0, self.x, self.y), "floor": 0, "ceiling": self.height, "furniture": [],
                     "openings": [{"wall": 0, "from": 0.4, "to": 1.3, "head": 2.03, "depth": 0.15, "lobby": {"depth": 2, "margin": 1, "height": 2.3}},
                                  {"wall": 0, "from": 1.8, "to": 2.8, "sill": 0.9, "head": 2.1, "depth": 0.25, "glazing": {}}]}
        self.more = []       # other rooms
        self.stations = [[self.x * 0.3, self.y * 0.35, 1.5], [self.x * 0.68, self.y * 0.62, 1.5]]

    def between(self, low, high):
        return round(self.rng.uniform(low, high), 3)

    def furnish(self):
        for _ in range(self.rng.randrange(4)):
            size = [self.between(0.4, 1.2), self.between(0.4, 0.8), self.between(0.4, 1.9)]
            at = [self.between(0.8, self.x - 0.8), self.between(0.6, self.y - 0.6)]
            if all(math.dist(at, station[:2]) > 1 for station in self.stations):
                self.room["furniture"].append({"block": {"name": "chest", "at": at, "yaw": self.between(0, 90), "size": size}})

    def neighbour(self, thickness, height):
        left = self.x + thickness
        self.more.append({"name": "beside", "outline": rectangle(left, 0, left + 3, self.y), "floor": 0, "ceiling": height, "furniture": []})
        self.stations += [[left + 1.4, self.y * 0.4, 1.5], [left + 1.8, self.y * 0.75, 1.5]]


def cupboards(s):
    """Cupboards along a whole wall that end a little below the ceiling."""
    depth, below = s.between(0.3, 0.65), s.between(0.03, 0.3)
    s.room["furniture"].append({"block": {"name": "cupboard", "wall": 2, "s": s.x / 2, "size": [s.x - 0.02, depth, round(s.height - below, 3)]}})


def cupboard(s):
    """One cupboard in a corner that ends a little below the ceiling."""
    width, below = s.between(1, 2.5), s.between(0.03, 0.6)
    s.room["furniture"].append({"block": {"name": "cupboard", "wall": 2, "s": width / 2 + 0.01, "size": [width, s.between(0.4, 0.65), round(s.height - below, 3)]}})


def stage(s):
    rise = s.rng.choice((s.between(0.05, 0.15), s.between(0.15, 0.6), s.between(0.6, 1.6)))
    s.room["floor_details"] = [{"loop": rectangle(s.x * 0.55, 0, s.x, s.y), "rise": rise}]
    del s.room["openings"][1]
    s.room["ceiling"] = s.height = max(s.height, round(rise + 2.3, 2))
    s.stations[1] = [s.x * 0.78, s.y * 0.6, rise + 1.4]


def pit(s):
    s.room["floor_details"] = [{"loop": rectangle(s.x * 0.4, s.y * 0.4, s.x * 0.85, s.y * 0.85), "rise": -s.between(0.1, 1.2)}]


def sloping_floor(s):
    s.room["floor"] = {"height": 0, "slope": s.between(2, 8), "towards": s.rng.choice((0, 90, 180)), "at": [s.x / 2, s.y / 2]}
    s.room["openings"] = []
    s.room["ceiling"] = s.height = s.height + 0.8
    s.stations = [[x, y, z + 0.3] for x, y, z in s.stations]


def tilted_wall(s):
    s.room["tilts"] = [{"wall": s.rng.choice((1, 2, 3)), "tilt": s.rng.choice((-1, 1)) * s.between(1, 7)}]


def glass_partition(s):
    """A pane from floor to ceiling between two rooms."""
    s.neighbour(0.05, s.height)
    s.room["openings"].append({"wall": 1, "from": 0.06, "to": s.y - 0.06, "sill": 0.02, "head": round(s.height - s.between(0.03, 0.12), 3), "depth": 0.05,
                               "leads_to": "beside", "glazing": {}})


def thin_partition(s):
    s.neighbour(s.between(0.04, 0.1), round(s.height + s.between(-0.3, 0.3), 2))
    s.room["openings"].append({"wall": 1, "from": 0.5, "to": 1.4, "head": 2.03, "depth": 0.08, "leads_to": "beside"})
    s.room["openings"][-1]["depth"] = round(s.more[0]["outline"]["rectangle"][0][0] - s.x, 3)


def acute_corner(s):
    reach = s.y / math.tan(math.radians(s.between(15, 50)))
    s.room["outline"] = [[0, 0], [s.x, 0], [round(s.x + reach, 3), s.y], [0, s.y]]
    s.stations.append([s.x + reach * 0.45, s.y * 0.75, 1.5])


def low_beam(s):
    at = s.between(0.3, 0.6) * s.x
    s.room["ceiling_details"] = [{"loop": rectangle(at, 0, at + s.between(0.2, 0.5), s.y), "drop": round(s.height - s.between(2.05, 2.2), 3)}]


def edge_beam(s):
    """A beam a little before a wall: it hides the ceiling behind it."""
    gap, width = s.between(0.05, 0.5), s.between(0.15, 0.35)
    s.room["ceiling_details"] = [{"loop": rectangle(0, round(s.y - gap - width, 3), s.x, round(s.y - gap, 3)), "drop": s.between(0.25, 0.6)}]


def cut(s, x0, x1, depth):
    """Takes a rectangle at the far wall from the room."""
    s.room["outline"] = [[0, 0], [s.x, 0], [s.x, s.y], [x1, s.y], [x1, round(s.y - depth, 3)], [x0, round(s.y - depth, 3)], [x0, s.y], [0, s.y]]


def pilaster(s):
    """A column at a wall, or half a metre before it, the back of which nobody saw."""
    size, gap = s.between(0.2, 0.5), s.rng.choice((-0.05, s.between(0.1, 0.5)))
    at = s.x * 0.5
    s.room["columns"] = [{"rectangle": [[round(at, 3), round(s.y - gap - size, 3)], [round(at + size, 3), round(s.y - gap, 3)]]}] if gap > 0 else []
    if gap < 0:
        cut(s, round(at, 3), round(at + size, 3), size)


def relief(s):
    """A part of a wall a few centimetres before the rest."""
    depth, a, b = s.between(0.05, 0.14), s.x * s.between(0.2, 0.4), s.x * s.between(0.6, 0.8)
    cut(s, round(a, 3), round(b, 3), depth)


def closet(s):
    """A small room beside, seen through its door only."""
    width, depth, left = s.between(0.9, 1.6), s.between(0.9, 1.4), s.x + 0.1
    s.more.append({"name": "closet", "outline": rectangle(left, 0.6, left + depth, 0.6 + width), "floor": 0, "ceiling": s.height, "furniture": []})
    s.room["openings"].append({"wall": 1, "from": 0.75, "to": 1.4, "head": 2.03, "depth": 0.1, "leads_to": "closet"})
    s.stations.append([left + depth / 2, 0.6 + width / 2, 1.5])


def high_glazing(s):
    s.room["openings"][1] = {"wall": 2, "from": 0.3, "to": round(s.x - 0.3, 3), "sill": 0.05, "head": round(s.height - s.between(0.04, 0.15), 3), "depth": 0.25, "glazing": {}}


def soffit(s):
    drop = s.rng.choice((s.between(0.03, 0.1), s.between(0.1, 0.5)))
    s.room["ceiling_details"] = [{"loop": rectangle(0, s.y - s.between(0.3, 1), s.x, s.y), "drop": drop}]


def low_ceiling_slope(s):
    s.room["ceiling"] = {"height": s.height, "slope": s.between(1.5, 12), "towards": s.rng.choice((0, 90)), "at": [s.x, s.y]}
    s.room["openings"] = []


def half_wall(s):
    """A wall as high as a parapet or a man, from a wall into the room."""
    length, at = s.between(1.2, 0.6 * s.y), s.between(0.4, 0.6) * s.x
    s.room["furniture"].append({"block": {"name": "half wall", "at": [round(at, 3), round(s.y - length / 2 - 0.01, 3)], "yaw": 0,
                                          "size": [s.between(0.08, 0.2), length, s.between(0.9, 2)]}})
    s.stations.append([s.x * 0.25, s.y * 0.75, 1.5])


def pre_wall(s):
    """A wall for pipes, half as high as the room, along a whole wall."""
    s.room["furniture"].append({"block": {"name": "pre-wall", "wall": 2, "s": s.x / 2, "size": [s.x - 0.002, s.between(0.1, 0.3), s.between(0.8, 1.4)]}})


def stub_wall(s):
    """A wall from one side that ends 1 to 2.4 m before the other."""
    at = s.between(0.45, 0.55) * s.x
    cut(s, round(at, 3), round(at + s.between(0.08, 0.2), 3), s.y - s.between(1, 2.4))
    s.stations = [[s.x * 0.25, s.y * 0.4, 1.5], [s.x * 0.8, s.y * 0.6, 1.5]]


def chimney_breast(s):
    """One whose far side no station sees."""
    at = s.between(0.45, 0.6) * s.x
    cut(s, round(at, 3), round(at + s.between(0.9, 1.6), 3), s.between(0.3, 0.7))
    s.stations = [[s.x * 0.25, s.y * 0.4, 1.5], [s.x * 0.3, s.y * 0.65, 1.5]]


def glass_corner(s):
    """Panes up to a corner, at two walls."""
    for wall, start, end in ((1, s.y - s.between(1.2, 2.5), s.y - 0.03), (2, 0.03, s.between(1.2, 2.5))):
        s.room["openings"].append({"wall": wall, "from": round(start, 3), "to": end, "sill": 0.03, "head": round(s.height - 0.05, 3), "depth": 0.05,
                                   "glazing": {"return_share": 0.04, "mirror_share": 0.05}})


def loft(s):
    """A platform to sleep on, from wall to wall."""
    s.height = s.room["ceiling"] = max(s.height, 2.8)
    s.room["furniture"].append({"block": {"name": "loft", "wall": 3, "s": s.y / 2, "raise": s.between(1.6, 2), "size": [s.y - 0.002, s.between(1, 1.6), 0.2]}})


def s_wall(s):
    """A wall of two arcs, one to each side."""
    bulge = s.between(0.1, 0.35)
    s.room["outline"] = [[0, 0], [s.x, 0], {"at": [s.x, s.y], "bulge": bulge}, {"at": [round(s.x / 2, 3), s.y], "bulge": -bulge}, [0, s.y]]


def box_floor(s):
    """A box so large that it may be a stage."""
    size = [s.between(1.6, 2.4), s.between(1.6, 2.4), s.between(0.2, 0.5)]
    s.room["furniture"].append({"block": {"name": "box", "wall": 2, "s": size[0] / 2 + s.between(0.01, 0.5), "size": size}})


def mirror_wall(s):
    """A mirror up to the ceiling, in which the room is seen again."""
    width = s.between(1.5, 3)
    s.room["openings"].append({"wall": 2, "from": 0.3, "to": round(0.3 + width, 3), "sill": 0.05, "head": round(s.height - s.between(0.04, 0.5), 3), "depth": 0.05,
                               "glazing": {"return_share": 0.1, "mirror_share": 0.7}})


def bulkhead(s):
    """Cupboards the fronts of which are in line with a soffit."""
    drop, depth, width = s.between(0.25, 0.5), s.between(0.4, 0.65), s.between(0.4, 0.8) * s.x
    s.room["ceiling_details"] = [{"loop": rectangle(0, s.y - depth, s.x, s.y), "drop": drop}]
    s.room["furniture"].append({"block": {"name": "cupboard", "wall": 2, "s": width / 2 + 0.01, "size": [width, depth, round(s.height - drop - 0.02, 3)]}})


def curtain(s):
    """A curtain up to the ceiling before a part of a wall with a window."""
    width = s.between(0.3, 0.8) * s.x
    s.room["openings"][1]["wall"] = 2
    s.room["furniture"].append({"block": {"name": "curtain", "wall": 2, "s": width / 2 + 0.01, "gap": s.between(0.08, 0.25), "size": [width, 0.03, round(s.height - 0.03, 3)]}})


def base_units(s):
    """Base units of a kitchen below a bulkhead, the front of which is nearly in line with theirs; half of them with wall cupboards."""
    depth, drop, start, width = s.between(0.55, 0.65), s.between(0.3, 0.7), s.between(0.01, 0.15) * s.x, s.between(0.5, 0.8) * s.x
    s.room["ceiling_details"] = [{"loop": rectangle(0, s.y - depth + s.between(-0.15, 0.15), s.x, s.y), "drop": drop}]
    s.room["furniture"].append({"block": {"name": "units", "wall": 2, "s": round(start + width / 2, 3), "size": [width, depth, 0.9]}})
    if s.rng.random() < 0.5:
        s.room["furniture"].append({"block": {"name": "wall cupboards", "wall": 2, "s": round(start + width / 2, 3), "raise": 1.45,
                                              "size": [width, 0.35, round(s.height - drop - 1.47, 3)]}})


def shelves(s):
    """Shelves a little before the walls, below a soffit along three of these that nearly has their depth."""
    depth, drop, inset = s.between(0.25, 0.45), s.between(0.12, 0.4), s.between(-0.15, 0.15)
    x0, y0 = round(depth + inset, 3), round(s.y - depth - inset, 3)
    s.room["ceiling_details"] = [{"loop": [[0, 0.7], [x0, 0.7], [x0, y0], [round(s.x - x0, 3), y0], [round(s.x - x0, 3), 0.7], [s.x, 0.7], [s.x, s.y], [0, s.y]],
                                  "drop": drop}]
    for wall, length in ((2, s.x), (3, s.y - 0.7)):
        if wall == 2 or s.rng.random() < 0.5:
            width = s.between(0.4, 0.7) * length
            s.room["furniture"].append({"block": {"name": "shelves", "wall": wall, "s": round(depth + width / 2 + 0.1, 3), "gap": s.between(0.01, 0.06),
                                                  "size": [width, depth, round(s.height - drop - s.between(0.05, 0.6), 3)]}})


def alcoves(s):
    """A chimney breast with shelves in the alcoves beside it, nearly flush with it, up to the ceiling or below."""
    depth, x0, width = s.between(0.3, 0.5), s.between(0.3, 0.45) * s.x, s.between(1, 1.5)
    x1 = round(x0 + width, 3)
    cut(s, round(x0, 3), x1, depth)
    height = round(s.height - s.between(0.04, 0.8), 3)
    for left, right in ((0, x0), (x1, s.x)):
        if left == 0 or s.rng.random() < 0.6:
            size = [round(right - left - 0.02, 3), round(depth + s.between(-0.15, 0.15), 3), height]
            s.room["furniture"].append({"block": {"name": "shelves", "at": [round((left + right) / 2, 3), round(s.y - 0.005 - size[1] / 2, 3)], "size": size}})


def hall(s):
    """Makes the room a hall of four stations."""
    s.x, s.y = s.between(9, 13), s.between(7, 10)
    s.height = s.between(3, 4.5)
    s.room["outline"], s.room["ceiling"] = rectangle(0, 0, s.x, s.y), s.height
    s.stations = [[s.x * a, s.y * b, 1.6] for a, b in ((0.18, 0.2), (0.8, 0.25), (0.25, 0.82), (0.78, 0.75))]


def columns(s):
    """Four columns, round or square, thin or thick, free or near a wall, below a beam."""
    hall(s)
    s.room["columns"] = []
    for a, b in ((0.36, 0.5), (0.64, 0.5), (0.5, 0.25), (0.5, 0.78)):
        size, at = s.between(0.2, 0.8), [s.x * a, s.y * b]
        if s.rng.random() < 0.4:
            at[1] = (s.y - size / 2 - s.between(0.1, 1)) if b > 0.6 else size / 2 + s.between(0.1, 1) if b < 0.4 else at[1]
        at = [round(v, 3) for v in at]
        s.room["columns"].append({"circle": at, "radius": round(size / 2, 3)} if s.rng.random() < 0.5 else
                                 rectangle(at[0] - size / 2, at[1] - size / 2, at[0] + size / 2, at[1] + size / 2))
    if s.rng.random() < 0.5:
        s.room["ceiling_details"] = [{"loop": rectangle(0, s.y * 0.5 - 0.2, s.x, s.y * 0.5 + 0.2), "drop": s.between(0.2, 0.5)}]


def ribs(s):
    """A deck with ribs in one direction or two."""
    hall(s)
    ways = (0, 90) if s.rng.random() < 0.3 else (s.rng.choice((0, 90)),)
    s.room["ribs"] = [{"direction": way, "spacing": s.between(0.6, 3), "width": s.between(0.1, 0.3), "depth": s.between(0.1, 0.5)} for way in ways]


def bay_window(s):
    """A bay with slanting sides and a window in each of its three."""
    depth, slant, x0, x1 = s.between(0.5, 1), s.between(0.3, 0.8), s.x * s.between(0.25, 0.35), s.x * s.between(0.65, 0.75)
    y = round(s.y + depth, 3)
    s.room["outline"] = [[0, 0], [s.x, 0], [s.x, s.y], [round(x1, 3), s.y], [round(x1 - slant, 3), y], [round(x0 + slant, 3), y], [round(x0, 3), s.y], [0, s.y]]
    for wall, length in ((3, math.hypot(depth, slant)), (4, x1 - x0 - 2 * slant), (5, math.hypot(depth, slant))):
        if length > 0.5:
            s.room["openings"].append({"wall": wall, "from": 0.12, "to": round(length - 0.12, 3), "sill": s.between(0.3, 0.9), "head": round(s.height - 0.25, 3),
                                       "depth": 0.1, "glazing": {}})


def room_divider(s):
    """A bookcase that stands free across the room, with a station on either side."""
    length, at = s.between(0.4, 0.75) * s.y, s.between(0.45, 0.55) * s.x
    s.room["furniture"].append({"block": {"name": "bookcase", "at": [round(at, 3), round(s.between(0.5, 0.6) * s.y, 3)], "yaw": s.rng.choice((0, s.between(-15, 15))),
                                          "size": [s.between(0.25, 0.45), round(length * 0.8, 3), round(s.height - s.rng.choice((s.between(0.02, 0.15), s.between(0.15, 0.9))), 3)]}})
    s.stations = [[s.x * 0.2, s.y * 0.4, 1.5], [s.x * 0.8, s.y * 0.55, 1.5]]


def wall_duct(s):
    """A duct along a wall, a little below the ceiling: one that touches it is a soffit."""
    size, below = [round(s.x - s.between(0.01, 1.5), 3), s.between(0.25, 0.6), s.between(0.2, 0.45)], s.between(0.03, 0.3)
    s.room["furniture"].append({"block": {"name": "duct", "wall": 2, "s": s.x / 2, "gap": s.rng.choice((0.005, s.between(0.02, 0.15))),
                                          "raise": round(s.height - size[2] - below, 3), "size": size}})


def radiator_niche(s):
    """A niche for a radiator below a window, with the radiator in it or before it."""
    x0, x1, depth = s.between(0.5, 1), s.between(2, 2.9), s.between(0.08, 0.25)
    s.room["niches"] = [{"wall": 2, "from": x0, "to": x1, "sill": 0, "head": 0.85, "depth": depth}]
    s.room["openings"][1] = {"wall": 2, "from": x0, "to": x1, "sill": 0.9, "head": 2.15, "depth": 0.3, "glazing": {}}
    s.room["furniture"].append({"block": {"name": "radiator", "wall": 2, "s": round((x0 + x1) / 2, 3), "gap": 0.04, "raise": 0.1,
                                          "size": [round((x1 - x0) * 0.85, 3), 0.1, 0.6]}})


def door_mirror(s):
    """A mirror as large as a door, on a wall or as the front of a cupboard."""
    start, width = s.between(0.3, 1.6), s.between(0.6, 1.3)
    s.room["openings"].append({"wall": s.rng.choice((1, 2, 3)), "from": start, "to": round(start + width, 3), "sill": s.between(0.01, 0.3), "head": s.between(1.9, 2.2),
                               "depth": 0.03, "glazing": {"return_share": s.between(0.03, 0.15), "mirror_share": 0.75}})


def baffle(s):
    """An island that hangs below the ceiling."""
    size = [round(s.x * s.between(0.4, 0.75), 3), round(s.y * s.between(0.4, 0.75), 3), s.between(0.03, 0.1)]
    s.room["furniture"].append({"block": {"name": "island", "at": [s.x / 2, s.y / 2], "raise": round(s.height - size[2] - s.between(0.1, 0.45), 3), "size": size}})


def attic(s):
    """A steep ceiling above a knee wall."""
    slope, knee = s.between(25, 45), s.between(0.6, 1.3)
    s.room["ceiling"] = {"height": knee, "slope": slope, "towards": 90, "at": [0, 0]}
    s.room["openings"] = [{"wall": 2, "from": 0.6, "to": 1.5, "head": 2.03, "depth": 0.15, "lobby": {"depth": 2, "margin": 1, "height": 2.3}}]
    s.stations = [[s.x * 0.3, s.y * 0.6, 1.5], [s.x * 0.7, s.y * 0.65, 1.5]]


def winter_garden(s):
    """Panes from floor to ceiling in posts, along three walls."""
    s.room["openings"] = s.room["openings"][:1]
    for wall, length in ((1, s.y), (2, s.x), (3, s.y)):
        count = s.rng.randrange(2, 4)
        post = s.between(0.06, 0.15)
        for k in range(count):
            s.room["openings"].append({"wall": wall, "from": round(length * k / count + post / 2 + 0.02, 3), "to": round(length * (k + 1) / count - post / 2 - 0.02, 3),
                                       "sill": s.between(0.03, 0.15), "head": round(s.height - 0.12, 3), "depth": 0.08, "glazing": {}})


def free_wall(s):
    """A wall up to the ceiling with a gap at both ends."""
    at, gap, thickness = s.between(0.45, 0.55) * s.x, s.between(0.25, 0.9), s.between(0.08, 0.2)
    s.room["columns"] = [rectangle(at, gap, at + thickness, s.y - s.between(0.25, 0.9))]
    s.stations = [[s.x * 0.22, s.y * 0.4, 1.5], [s.x * 0.8, s.y * 0.6, 1.5]]


def half_column(s):
    """A half-round or flat-round pillar at a wall, and a quarter of a column in a corner."""
    x1, width, bulge = s.between(0.5, 0.7) * s.x, s.between(0.3, 1), s.between(0.3, 1)
    quarter = s.between(0.2, 0.5)
    s.room["outline"] = [[0, 0], [s.x, 0], [s.x, s.y], {"at": [round(x1, 3), s.y], "bulge": -bulge}, [round(x1 - width, 3), s.y],
                         {"at": [quarter, s.y], "bulge": -0.4142}, [0, round(s.y - quarter, 3)]]


def deep_niches(s):
    """Recesses for shelves, nearly from floor to ceiling, side by side."""
    count, depth, low = s.rng.randrange(1, 4), s.between(0.2, 0.6), s.rng.choice((0, 0.1, 0.5))
    width = (s.x - 0.3) / count
    s.room["niches"] = [{"wall": 2, "from": round(0.2 + width * k, 3), "to": round(0.2 + width * (k + 1) - s.between(0.08, 0.4), 3), "sill": low,
                         "head": round(s.height - s.between(0.05, 0.4), 3), "depth": depth} for k in range(count)]


def arcade(s):
    """Wide arches between two rooms."""
    thickness = s.between(0.15, 0.5)
    s.neighbour(thickness, s.height)
    count = 2 if s.y > 4.2 else 1
    width = (s.y - 0.4) / count
    for k in range(count):
        reach = s.between(0.15, 0.35)
        s.room["openings"].append({"wall": 1, "from": round(0.2 + width * k + reach, 3), "to": round(0.2 + width * (k + 1) - reach, 3),
                                   "head": 2.15, "rise": s.between(0.2, 0.6), "depth": round(s.more[0]["outline"]["rectangle"][0][0] - s.x, 3), "leads_to": "beside"})


def high_cupboards(s):
    """Cupboards that end a little below the ceiling: along a whole wall, half of it, or around a corner."""
    depth, height = s.between(0.35, 0.6), round(s.height - s.rng.choice((0.03, 0.08, 0.15, 0.25)), 3)
    extent = s.rng.choice(("whole", "half", "corner"))
    width = round((s.x - 0.02) * (0.5 if extent == "half" else 1), 3)
    s.room["furniture"].append({"block": {"name": "cupboard", "wall": 2, "s": width / 2 + 0.01, "size": [width, depth, height]}})
    if extent == "corner":
        length = round(s.between(0.4, 0.7) * s.y, 3)
        s.room["furniture"].append({"block": {"name": "cupboard", "wall": 3, "s": round(depth + length / 2 + 0.01, 3), "size": [length, depth, height]}})


def lecture_steps(s):
    """Steps across a lecture room with a desk on each."""
    s.x, s.y, s.height = s.between(8, 11), s.between(5, 8), s.between(4, 4.6)
    s.room.update({"outline": rectangle(0, 0, s.x, s.y), "ceiling": s.height, "openings": s.room["openings"][:1], "floor_details": []})
    rise, tread, first = s.between(0.15, 0.35), s.between(0.85, 1.1), s.between(0.4, 0.5) * s.x
    for k in range(int((s.x - first) / tread)):
        front, back = round(first + k * tread, 3), round(first + (k + 1) * tread, 3) if first + (k + 2) * tread <= s.x else s.x
        floor = round((k + 1) * rise, 3)
        s.room["floor_details"].append({"loop": rectangle(front, 0, back, s.y), "rise": floor})
        for name, at, depth, height in (("desk", 0.25, s.between(0.35, 0.5), 0.74), ("bench", 0.7, 0.3, 0.45)):
            if front + at + depth / 2 < back:
                s.room["furniture"].append({"block": {"name": name, "at": [round(front + at, 3), round(s.y / 2, 3)],
                                                      "size": [depth, round(s.y - s.between(1, 1.8), 3), height]}})
    s.stations = [[first * 0.35, s.y * 0.3, 1.5], [first * 0.6, s.y * 0.7, 1.5], [s.x - 0.3, s.y * 0.5, floor + 1.3]]


def hatch(s):
    """A hatch beside the door between two rooms."""
    thickness, start, sill = s.between(0.08, 0.2), s.between(1.5, s.y - 1.5), s.between(0.9, 1.2)
    s.neighbour(thickness, s.height)
    s.room["openings"] += [{"wall": 1, "from": 0.3, "to": 1.2, "head": 2.03, "depth": thickness, "leads_to": "beside"},
                           {"wall": 1, "from": start, "to": round(start + s.between(0.9, 1.3), 3), "sill": sill, "head": round(sill + s.between(0.6, 0.9), 3),
                            "depth": thickness, "leads_to": "beside"}]


def gate(s):
    """A closed gate, set back in its wall."""
    width = s.between(2.2, 3)
    start = s.between(0.2, s.x - width - 0.2)
    s.room["openings"].append({"wall": 2, "from": start, "to": round(start + width, 3), "head": s.between(2.05, 2.25), "depth": s.between(0.2, 0.36),
                               "leaf": {"hinge": "both", "angle": 0}})


def half_wall_kept(s):
    """A wall that ends between 0.9 m above the floor and 0.3 m below the ceiling, as part of the building."""
    at, thickness = s.between(0.4, 0.6) * s.x, s.between(0.1, 0.2)
    s.room["floor_details"] = [{"loop": rectangle(at, s.y - s.between(0.4, 0.75) * s.y, at + thickness, s.y), "rise": s.between(0.9, s.height - 0.3)}]
    s.stations = [[s.x * 0.2, s.y * 0.6, 1.5], [s.x * 0.8, s.y * 0.6, 1.5], [s.x * 0.5, s.y * 0.12, 1.5]]


FIRST = (cupboards, cupboard, stage, pit, sloping_floor, tilted_wall, glass_partition, thin_partition, acute_corner, low_beam, pilaster, relief, closet,
         high_glazing, soffit, low_ceiling_slope, half_wall, pre_wall, stub_wall, chimney_breast, glass_corner, loft, s_wall, box_floor, mirror_wall,
         bulkhead, curtain, base_units, shelves, alcoves, columns, ribs)
LATER = (bay_window, room_divider, wall_duct, radiator_niche, door_mirror, baffle, attic, winter_garden, free_wall, half_column, deep_niches, arcade)
NEWEST = (edge_beam,)
LATEST = (high_cupboards, lecture_steps, hatch, gate, half_wall_kept)
