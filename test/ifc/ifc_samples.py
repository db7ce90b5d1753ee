# SPDX-License-Identifier: BSD-3-Clause
"""Plans with volumes known in closed form, and the tool that writes them as IFC."""

import json
import math
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from plan_samples import arc, rectangle, room, segment, slab


def opening(kind, rooms, start, end, bottom=0.0, top=2.05, hinge="unknown", swing=0, state="unknown"):
    """An opening in no named wall; the first room is to the left."""
    return {"kind": kind, "rooms": rooms, "walls": [], "start": start, "end": end, "bottom": bottom, "top": top,
            "depth": 0.1, "hinge": hinge, "swing": swing, "state": state}


def passage(rooms, start, end):
    return opening("passage", rooms, start, end)


def house():
    """A hall with an apse, columns and a soffit; behind 10 cm of wall a cell with a platform and a niche, and
    behind 20 cm a plain box; above the cell an attic below a sloping roof; a rotunda apart."""
    hall = room(1, [segment([0, 0], [6, 0], evidence={"seen": 0.7, "hidden": 0.2, "opening": 0.1}),
                    arc([6, 2], 2, [6, 0], [6, 4]), segment([6, 4], [0, 4]), segment([0, 4], [0, 0])],
                slab(0), slab(3),
                columns=[[arc([3, 2], 0.4, [3.4, 2], [3.4, 2], False)],
                         rectangle(4.5, 1, 5, 1.5, clockwise=True)],
                details=[{"slab": slab(2.6), "boundary": rectangle(0, 0, 0.5, 4), "holes": []}])
    cell = room(2, rectangle(0, 4.1, 5, 7.1), slab(0), slab(2.5),
                floor_details=[{"slab": slab(0.3), "boundary": rectangle(3.5, 4.1, 5, 7.1), "holes": []}],
                niches=[{"bottom": slab(1), "top": slab(2), "boundary": rectangle(1, 7.1, 2, 7.2)}])
    box = room(3, rectangle(5.2, 4.5, 9.2, 7.1), slab(0), slab(2.5))
    attic = room(4, rectangle(0, 4.1, 5, 7.1), slab(2.8), slab(2.8 + 1.5 - 0.5 * 4.1, 0, 0.5))
    rotunda = room(5, [arc([14, 2], 3, [17, 2], [17, 2])], slab(0), slab(4))
    return {"format": "sedr-floorplan", "version": 1, "unit": "m", "origin": [691600, 5335900, 500],
            "rooms": [hall, cell, box, attic, rotunda],
            "storeys": [{"number": 1, "name": "ground floor", "rooms": [1, 2, 3, 5]},
                        {"number": 2, "name": "attic, \u00fcber \u20ac 'x' \\", "rooms": [4]}],
            "openings": [passage([1, 2], [2.0, 4.05], [2.9, 4.05]), passage([2, 3], [5.1, 5.0], [5.1, 5.9]),
                         passage([0, 1], [0.0, 1.0], [0.0, 2.0]), passage([0, 5], [14.4, -1.07], [13.6, -1.07])],
            "stairs": [{"rooms": [2, 4], "at": [2, 6], "bottom": 0, "top": 2.8, "flights": [
                {"bottom": 0, "rise": 0.175, "risers": [[[0.5 + 0.25 * k, 6.5], [0.5 + 0.25 * k, 5.5]] for k in range(16)]}]}]}


def house_with_doors(hinge="start", swing=1):
    """The house with a door between hall and cell, windows in a flat wall and in a curved one."""
    return dict(house(), openings=[
        opening("door", [1, 2], [2.9, 4.05], [2.0, 4.05], hinge=hinge, swing=swing, state="open"),
        opening("window", [1, 0], [2, -0.1], [3, -0.1], 0.9, 2.1),
        opening("window", [5, 0], [14.4, -1.07], [13.6, -1.07], 1.0, 2.0)])


VOLUMES = {1: (24 + 2 * math.pi - 0.16 * math.pi - 0.25) * 3 - 2 * 0.4, 2: 15 * 2.5 - 4.5 * 0.3 + 0.1,
           3: 4 * 2.6 * 2.5, 4: 15 * (1.5 + 0.75), 5: 9 * math.pi * 4}


def write(tool, plan, folder, *options, name="model"):
    """The file that the tool makes of a plan."""
    source, path = os.path.join(folder, name + ".json"), os.path.join(folder, name + ".ifc")
    with open(source, "w") as file:
        json.dump(plan, file)
    result = subprocess.run([tool, source, path, *options], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert result.stderr == "", result.stderr
    return path
