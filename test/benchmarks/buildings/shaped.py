# SPDX-License-Identifier: BSD-3-Clause
"""One room, or two beside each other, whose plan, ceiling and walls have any shape that the simulator knows."""
import math
import random

from . import furnish, geometry as g, overhead, shapes, walls
from .build import Unfit
from .kinds import KINDS
from .model import Building, Room

TRIES = 200
NOISE = 0.01          # metres
RAYS = 1.5e6          # of all stations
FEWEST_STATIONS = 4   # of a room
STYLE = KINDS["flat"]
PLANS = {"rectangle": 10, "l": 3, "bulge": 3, "s_curve": 2, "round": 1, "slanted": 2, "chamfer": 1}
TILT_SHARE = 0.2      # of the rooms that may have tilted walls


class ShapedRoom(Room):
    """A room that may have curves in its ceiling, as the scene file has them, each with its height over the plan."""

    def __init__(self, name, outline, height):
        super().__init__(name, "room", outline, 0.0, height, 1)
        self.curves = []  # (facet of the scene file, z at a place or None beside it)

    def ceiling_at(self, p):
        for _, z_at in reversed(self.curves):
            if z_at(p) is not None:
                return z_at(p)
        return super().ceiling_at(p)

    def lowest_ceiling(self):
        x0, y0, x1, y1 = g.bounds(self.outline)
        places = [(x0 + (x1 - x0) * (i + 0.01) / 24.02, y0 + (y1 - y0) * (k + 0.01) / 24.02)
                  for i in range(25) for k in range(25)]
        drop = max([d["drop"] for d in self.details] + [r["depth"] for r in self.ribs] + [0.0])
        return min(self.ceiling_at(p) for p in places if g.inside(self.outline, p)) - drop

    def top_along(self, edge, start, end):
        a, u, n, size = g.frame(self.edges[edge])
        spans = [min(size - 0.01, max(0.01, start + (end - start) * k / 16)) for k in range(17)]
        drop = max([d["drop"] for d in self.details] + [r["depth"] for r in self.ribs] + [0.0])
        top = min(self.ceiling_at(g.along(g.along(a, u, s), n, -1e-6)) for s in spans) - drop
        return top - (0.05 if self.curves else 0.0)

    def to_json(self):
        json = super().to_json()
        parts = json.pop("ceiling_details", [])
        slopes = max(0, len(self.facets) - 1)
        more = {"facets": parts[:slopes] + [f for f, _ in self.curves], "ceiling_details": parts[slopes:],
                "tilts": [{"wall": w, "tilt": t} for w, t in sorted(self.tilts.items())]}
        json.update({key: value for key, value in more.items() if value})
        return json


def build(seed):
    """The scene file of a seed as a dictionary."""
    for attempt in range(TRIES):
        rng = random.Random(f"shape {seed} {attempt}")
        try:
            return attempt_to_build(rng, seed)
        except Unfit:
            continue
    raise RuntimeError(f"no room fits seed {seed}")


def attempt_to_build(rng, seed):
    are_two = rng.random() < 0.3
    first = ShapedRoom("west", [], round(rng.uniform(2.4, 3.4), 3))
    plan = rng.choice([k for k, n in PLANS.items() for _ in range(n) if not are_two or k in ("rectangle", "l")])
    width, depth = round(rng.uniform(3.6, 8.5), 2), round(rng.uniform(3.2, 6.0), 2)
    lay_out(rng, first, plan, width, depth)
    rooms = [first]
    partition = round(rng.choice((rng.uniform(0.08, 0.4), rng.uniform(0.5, 0.8))), 3)
    if are_two:
        start, end = round(rng.uniform(-0.8, 0.8), 2), round(depth + rng.uniform(-0.8, 0.8), 2)
        second = ShapedRoom("east", [], round(rng.uniform(2.4, 3.4), 3))
        second.outline = g.rectangle(round(width + partition, 4), start, round(width + partition + rng.uniform(3, 6), 2), end)
        rooms.append(second)
    names = [plan] + [overhead.hang(rng, room) for room in rooms]
    if tilt_walls(rng, rooms, partition):
        names.append("tilted")
    building = Building("-".join(names) + f"_{seed}", "", rng)
    building.rooms = rooms
    open_walls(rng, building)
    if rng.random() < 0.7:
        names.append("furnished")
        for room in rooms:
            furnish.furnish(rng, room)
    building.summary = " ".join(names)
    building.outside = [{"block": {"name": "ground", "at": [5, 2], "floor": -0.6, "size": [80, 80, 0.2]}},
                        {"block": {"name": "facade", "at": [4, -16], "floor": -0.4, "size": [40, 1, 8]}}]
    return scanned(rng, building)


def lay_out(rng, room, plan, width, depth):
    room.outline = g.rectangle(0.0, 0.0, width, depth)
    if plan == "l":
        x, y = round(width * rng.uniform(0.4, 0.65), 2), round(depth * rng.uniform(0.4, 0.65), 2)
        room.outline = rng.choice(([(0.0, 0.0), (width, 0.0), (width, depth), (x, depth), (x, y), (0.0, y)],
                                   [(0.0, 0.0), (x, 0.0), (x, y), (width, y), (width, depth), (0.0, depth)]))
        for k, (a, b) in enumerate(room.edges):  # windows on both sides of the notch's corner would meet
            if g.cross(g.sub(a, room.outline[k - 1]), g.sub(b, a)) < 0:
                room.use(k, 0.0, 0.4)
                size = g.frame(room.edges[k - 1])[3]
                room.use(k - 1, size - 0.4, size)  # k > 0: the outline begins at another corner
    elif plan == "bulge":
        shapes.curve_facade(rng, room, [room])
    elif plan == "s_curve":
        rise = round(rng.choice((-1, 1)) * rng.uniform(0.12, 0.35), 4)
        room.outline[3:3] = [(round(width * rng.uniform(0.42, 0.58), 3), depth)]
        room.bulges = {2: rise, 3: -rise}
        for wall in room.bulges:
            size = g.frame(room.edges[wall])[3]
            room.use(wall, 0.0, size)
            room.keep_clear(wall, 0.0, size, 0.2 + 0.5 * size * abs(rise))
    elif plan == "round":
        radius = round(depth / 2, 3)
        room.outline = [(radius, 0.0), (2 * radius, radius), (radius, 2 * radius), (0.0, radius)]
        room.bulges = {k: math.tan(math.pi / 8) for k in range(4)}
    elif plan == "slanted":
        room.outline[2] = (round(width - rng.uniform(0.4, 1.2), 3), round(depth - rng.uniform(0.0, 0.5), 3))
    elif plan == "chamfer":
        shapes.chamfer(rng, room)


def tilt_walls(rng, rooms, partition):
    """Tilts a wall or two of a room below a plane, the wall between two rooms on both sides, or an arc: a cone."""
    able = [r for r in rooms if not r.curves and len(r.facets) < 2 and not r.details and not r.ribs]
    if len(able) < len(rooms) or rng.random() > TILT_SHARE * 2:
        return False
    room = rooms[0]
    if len(rooms) == 2:
        both = [round(rng.uniform(2, 8), 1) for _ in rooms]
        high = max(overhead.highest(r) for r in rooms)
        if partition < 0.1 + sum(math.tan(math.radians(t)) for t in both) * high or not g.is_rectangle(room.outline):
            return False
        tilt(room, 1, -both[0])
        tilt(rooms[1], 3, -both[1])
        return True
    if room.bulges:
        if min(room.bulges.values()) < 0 or room.facets:
            return False
        degrees = round(rng.choice((-1, 1)) * rng.uniform(4, 12), 1)
        if len(room.bulges) < len(room.edges):  # one that leans outwards would leave its neighbours
            degrees = abs(degrees)
        for wall in room.bulges:
            tilt(room, wall, degrees)
        return True
    if len(room.outline) > 5:  # the wall beside the notch of an L would be tilted through it
        return False
    chosen = rng.sample(range(len(room.edges)), rng.choice((1, 1, 2)))
    for wall in chosen:
        tilt(room, wall, round(rng.choice((-1, 1)) * rng.uniform(4, 20), 1))
    return True


def tilt(room, wall, degrees):
    room.tilts[wall] = degrees
    size = g.frame(room.edges[wall])[3]
    room.use(wall, 0.0, size)
    reach = math.tan(math.radians(degrees)) * overhead.highest(room) + 0.05
    if degrees > 0:
        room.keep_clear(wall, 0.0, size, reach)
        before, after = (wall - 1) % len(room.edges), (wall + 1) % len(room.edges)
        length = g.frame(room.edges[before])[3]
        room.use(before, length - reach, length)
        room.use(after, 0.0, reach)


def open_walls(rng, building):
    if len(building.rooms) > 1 and not any(r.tilts for r in building.rooms) and \
            not walls.connect(rng, building.rooms, STYLE, "usual"):
        raise Unfit
    for room in building.rooms:
        front_door(rng, room, building.rooms)
        walls.add_windows(rng, room, building.rooms, STYLE, 0.3)


def lobby_meets(room, door, rooms):
    """Whether the space behind a door, with its walls, reaches into a room."""
    thickness, step = 0.1, 0.15
    a, u, n, _ = g.frame(room.edges[door["wall"]])
    margin, depth = door["lobby"]["margin"] + thickness, door["lobby"]["depth"] + thickness
    first, last = door["from"] - margin, door["to"] + margin
    places = [g.along(g.along(a, u, min(first + step * i, last)), n, min(door["depth"] + step * k, door["depth"] + depth))
              for i in range(math.ceil((last - first) / step) + 1) for k in range(math.ceil(depth / step) + 1)]
    return any(g.inside(other.outline, p) for other in rooms for p in places)


def front_door(rng, room, rooms):
    """A door to a lobby, shut or open."""
    stretches = walls.outer_stretches(room, rooms, 4.0)
    for wall, start, end in rng.sample(stretches, k=len(stretches)):
        if end - start < 1.6:
            continue
        at = round(rng.uniform(start + 0.3, end - 1.2), 3)
        if room.is_free(wall, at - 0.1, at + 1.0) and room.top_along(wall, at, at + 0.9) > 2.1:
            door = {"wall": wall, "from": at, "to": round(at + 0.9, 3), "head": 2.05, "depth": 0.25,
                    "leaf": {"hinge": "from", "angle": rng.choice((0, 90))}}
            if door["leaf"]["angle"] == 90:
                door["lobby"] = {"depth": 2.4, "margin": round(rng.uniform(0.6, 1.4), 2), "height": 2.5}
                if lobby_meets(room, door, rooms):  # as in the notch of an L
                    raise Unfit
                room.obstacles.append(walls.leaf_outline(room, door))
            room.openings.append(door)
            room.use(wall, at, at + 0.9)
            room.keep_clear(wall, at - 0.1, at + 1.0, 1.05)
            return


def scanned(rng, building):
    for room in building.rooms:
        room.stations = furnish.stations(rng, room)
        for _ in range(50):
            more = furnish.stations(rng, room) if len(room.stations) < FEWEST_STATIONS else []
            room.stations += [s for s in more if s not in room.stations][:1]
        if len(room.stations) < 2:
            raise Unfit
    rays = RAYS / sum(len(r.stations) for r in building.rooms)
    return building.to_json(int(rays), NOISE, {"yaw": round(rng.uniform(-180, 180), 2), "shift": [6, 2, 1]})
