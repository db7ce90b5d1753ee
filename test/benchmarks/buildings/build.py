# SPDX-License-Identifier: BSD-3-Clause
"""Puts a building together: storeys of rooms, what joins them, what hangs and stands in them, and the scan."""
import random

from . import ceilings, fitments, furnish, geometry as g, shapes, stairs, walls
from .kinds import HIDDEN, KINDS, PLANS
from .model import Building, Room

TRIES = 40          # layouts that are tried until every room has a door
RAYS = (1.5e6, 3.2e6)  # of all stations
FEWEST_RAYS, MOST_RAYS = 130_000, 400_000  # of one
LARGEST_SCAN = 4.5e6  # rays


class Unfit(Exception):
    """A layout in which something did not fit; the next one is tried."""


def build(seed, kind=None):
    """The scene file of a seed as a dictionary; the kind is the seed's if none is given."""
    chooser = random.Random(f"kind {seed}")
    kind = kind or chooser.choice(sorted(k for k in KINDS if KINDS[k].is_for_all_seeds))
    for attempt in range(TRIES):
        rng = random.Random(f"{kind} {seed} {attempt}")
        try:
            return attempt_to_build(rng, kind, f"{kind}_{seed}")
        except Unfit:
            continue
    raise RuntimeError(f"no building of kind {kind} fits seed {seed}")


def attempt_to_build(rng, kind, name):
    style = KINDS[kind]
    count = rng.choice(style.storeys)
    heights = storey_heights(rng, style, count)
    flight = stairs.room_for(max(b[0] - a[0] for a, b in zip(heights, heights[1:])) if count > 1 else 3.0)
    plans, lines = PLANS[kind](rng, count, flight)
    building = Building(name, f"{kind} of {count} storey{'s' if count > 1 else ''}", rng)
    for storey, spaces in enumerate(plans):
        add_rooms(building, storey, spaces, lines, heights)
    tall = raise_halls(rng, building, heights, kind)
    shape_walls(rng, [r for r in building.rooms if not (lines.has_attic and r.storey == count)])
    join_storeys(rng, building, count)
    if lines.has_attic:
        put_attic_on(rng, building.on_storey(count), heights[-1])
    hang_ceilings(rng, building, style)
    doors = "full" if rng.random() < style.full_doors else "usual"
    for storey in range(1, count + 1):
        if not walls.connect(rng, building.on_storey(storey), style, doors):
            raise Unfit
    for room in tall:
        walls.add_galleries(rng, room, building.rooms, style.galleries)
    fill(rng, building, style, lines.outer)
    return scan(rng, building, style)


def storey_heights(rng, style, count):
    """(floor, slab's underside) of every storey."""
    heights, z = [], 0.0
    for _ in range(count):
        clear, slab = rng.uniform(*style.clear), rng.uniform(*style.slab)
        heights.append((round(z, 3), round(z + clear, 3)))
        z = round(z + clear + slab, 3)
    return heights


def add_rooms(building, storey, spaces, lines, heights):
    floor, ceiling = heights[storey]
    rng = building.rng
    for k, space in enumerate(s for s in spaces if s.role != HIDDEN):
        outline = g.union_outline(space.rects)
        if outline is None:
            raise Unfit
        outline = g.inset(outline, lines)
        x0, y0, x1, y1 = g.bounds(outline)
        if g.area(outline) < 1.2 or min(x1 - x0, y1 - y0) < 0.9:
            raise Unfit
        step = rng.uniform(0.08, 0.18) if space.role == "room" and rng.random() < 0.03 else 0.0
        name = f"{space.role} {storey + 1}.{k + 1}"
        building.rooms.append(Room(name, space.role, outline, round(floor + space.lift + step, 3), ceiling, storey + 1))


def raise_halls(rng, building, heights, kind):
    """Gives the halls the height of all storeys, or of more than one."""
    tall = [r for r in building.rooms if r.role == "hall"]
    for room in tall:
        if len(heights) > 1:
            room.ceiling = heights[-1][1]
        elif kind == "hall" or rng.random() < 0.7:
            room.ceiling = round(min(room.floor + rng.uniform(3.8, 6.0), room.ceiling + 3.0), 3)
    return tall


def shape_walls(rng, rooms):
    """Slanting partitions, chamfers and curves. Stairwells stay as they are."""
    plain = [r for r in rooms if r.role not in ("stairs", "corridor", "closet")]
    if rng.random() < 0.3:
        pairs = [(a, b) for a in plain for b in plain if a.name < b.name and a.storey == b.storey]
        rng.shuffle(pairs)
        any(shapes.slant_partition(rng, a, b) for a, b in pairs)
    for room in plain:
        if rng.random() < 0.07:
            shapes.chamfer(rng, room)
    if plain and rng.random() < 0.3:
        shapes.curve_facade(rng, rng.choice(plain), rooms)


def join_storeys(rng, building, count):
    for storey in range(1, count):
        lower = next(r for r in building.on_storey(storey) if r.role == "stairs")
        upper = next(r for r in building.on_storey(storey + 1) if r.role == "stairs")
        if not stairs.add(lower, upper, storey % 2):
            raise Unfit
        open_plans = [r for s in (storey, storey + 1) for r in building.on_storey(s) if r.role == "open"]
        if len(open_plans) == 2 and rng.random() < 0.5:
            stairs.add_well(rng, *open_plans)


def put_attic_on(rng, rooms, heights):
    """A roof over the highest storey, all of whose rooms are rectangles."""
    box = [g.bounds(r.outline) for r in rooms]
    around = min(b[0] for b in box), min(b[1] for b in box), max(b[2] for b in box), max(b[3] for b in box)
    ceilings.attic(rng, rooms, around, max(2.3, heights[1] - heights[0]))


def hang_ceilings(rng, building, style):
    for room in building.rooms:
        if room.facets or room.role == "stairs":
            continue
        if style.vaults and g.is_rectangle(room.outline) and not room.bulges and rng.random() < style.vaults:
            ceilings.vault(rng, room)
            continue
        if room.role == "open" and rng.random() < 0.3:
            ceilings.shaft(rng, room)
        is_large = room.area > 45 and room.role in ("open", "hall", "room")
        if is_large and not room.bulges and rng.random() < style.ribs:
            ceilings.deck(rng, room)
        elif room.role == "hall" and g.is_rectangle(room.outline) and not room.bulges and rng.random() < 0.4:
            ceilings.vault(rng, room)
        elif rng.random() < style.suspended and room.role != "hall":
            ceilings.suspend(rng, room)
        elif rng.random() < 0.15 and room.ceiling - room.floor > 2.5 and room.role != "hall":
            room.ceiling = round(room.ceiling - rng.uniform(0.05, 0.3), 4)
        if not room.ribs and not room.facets and rng.random() < style.soffits:
            ceilings.soffit(rng, room)


def fill(rng, building, style, thickness):
    for room in building.rooms:
        walls.add_windows(rng, room, building.rooms, style, thickness)
        if style.niches and not room.facets:
            walls.add_niches(rng, room, building.rooms, style.niches)
    if rng.random() < 0.5:
        box = [g.bounds(r.outline) for r in building.rooms]
        x = max(b[2] for b in box) + rng.uniform(6, 14)
        y = (min(b[1] for b in box) + max(b[3] for b in box)) / 2
        building.outside.append({"block": {"name": "facade", "at": [round(x, 2), round(y, 2)], "floor": -1,
                                           "size": [1.0, round(rng.uniform(15, 40), 1), round(rng.uniform(5, 12), 1)]}})
    if style.is_fitted:
        fitments.fit_out(rng, building)
    for room in building.rooms:
        furnish.furnish(rng, room)


def scan(rng, building, style):
    """Stations in every room but some closets and one room in thirty, which are seen through their doors."""
    for room in building.rooms:
        is_seen_by_door = rng.random() < {"closet": 0.35, "room": 0.03}.get(room.role, 0.0)
        if is_seen_by_door and look_in(rng, building, room):
            continue
        room.stations += furnish.stations(rng, room)
        if not room.stations:
            raise Unfit
        if room.role == "corridor" and style.seen_from_end and rng.random() < style.seen_from_end:
            room.stations = [min(room.stations)]
    for room in building.rooms:
        if room.role in ("corridor", "open", "hall") and rng.random() < 0.5:
            near_a_door(rng, room)
    number = sum(len(r.stations) for r in building.rooms)
    rays = min(MOST_RAYS, max(FEWEST_RAYS, rng.uniform(*RAYS) / number), LARGEST_SCAN / number)
    noise = round(rng.choice((rng.uniform(0.001, 0.006), rng.uniform(0.002, 0.02))), 4)
    placement = {"yaw": round(rng.uniform(-180, 180), 2) if rng.random() < 0.75 else 0.0,
                 "shift": [round(rng.uniform(*span), 3) for span in ((-50, 50), (-50, 50), (-5, 100))]}
    return building.to_json(int(rays), noise, placement)


def door_places(room, building):
    """Places a step before each open door that leads to or from a room: (the other room, place in it)."""
    for other in building.rooms:
        for door in other.openings:
            if other is not room and door.get("leads_to") == room.name and door.get("leaf", {}).get("angle") != 0:
                a, u, n, _ = g.frame(other.edges[door["wall"]])
                yield other, g.along(g.along(a, u, (door["from"] + door["to"]) / 2), n, -0.7)
    for door in room.openings:
        if "leads_to" in door and door.get("leaf", {}).get("angle") != 0:
            a, u, n, _ = g.frame(room.edges[door["wall"]])
            middle = g.along(a, u, (door["from"] + door["to"]) / 2)
            yield building.room(door["leads_to"]), g.along(middle, n, door["depth"] + 0.7)


def look_in(rng, building, room):
    """A station before a room's open door; False if there is no place."""
    for other, p in door_places(room, building):
        if other.is_open(p) and other.ceiling_at(p) - other.floor > 1.9:
            other.stations.append(furnish.with_height(rng, other, p))
            return True
    return False


def near_a_door(rng, room):
    for door in room.openings:
        a, u, n, _ = g.frame(room.edges[door["wall"]])
        p = g.along(g.along(a, u, (door["from"] + door["to"]) / 2), n, -0.9)
        if "leads_to" in door and room.is_open(p):
            room.stations.append(furnish.with_height(rng, room, p))
            return
