#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What web-ifc, an independent reader, makes of the IFC files that SEDR writes: volumes of spaces and walls,
openings that cut. Skipped without node and web-ifc (npm install web-ifc; NODE_PATH says where).

    test_ifc_web.py pcl_floorplan_ifc
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import step_reader
from ifc_samples import VOLUMES, doorway, house, write
from plan_samples import rectangle, room, slab

TOOL = sys.argv[1]
READER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "web_ifc_volumes.js")
NODE = shutil.which("node") or shutil.which("nodejs")
if NODE is None or subprocess.run([NODE, "-e", "require('web-ifc')"], capture_output=True).returncode:
    print("skipped: node finds no web-ifc (npm install web-ifc, and NODE_PATH)")
    sys.exit(77)


def opened(path):
    """Products by kind and name."""
    result = subprocess.run([NODE, READER, path], capture_output=True, text=True, check=True)
    return json.loads(result.stdout)


def net_volumes(instances):
    """NetVolume of every space by its name, from the file's quantities."""
    values = {n: (name, v) for n, (name, v) in instances.items()}
    volumes = {}
    for name, v in instances.values():
        if name == "IFCRELDEFINESBYPROPERTIES" and values[v[5]][0] == "IFCELEMENTQUANTITY":
            for quantity in values[v[5]][1][5]:
                kind, q = values[quantity]
                if q[0] == "NetVolume":
                    volumes["IFCSPACE " + values[v[4][0]][1][2]] = q[3]
    return volumes


def swept_body(instances, product):
    """Edges in plan, bottom and top of a swept body in its placement; None of others."""
    shapes = instances[instances[product][1][6]][1][2]
    items = [v[3] for v in (instances[s][1] for s in shapes) if v[1] == "Body"]
    name, v = instances[items[0][0]]
    if name != "IFCEXTRUDEDAREASOLID":
        return None
    profile = instances[v[0]][1]
    loops = [[instances[p][1][0] for p in instances[n][1][0]] for n in [profile[2]] + sum(profile[3:], [])]
    axes = instances[v[1]][1]
    bottom = instances[axes[0]][1][0][2]
    return [edge for loop in loops for edge in zip(loop, loop[1:])], bottom, bottom + v[3]


def stretches(edges, y):
    """Where a line of constant y is within an outline."""
    xs = sorted(a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) for a, b in edges if (a[1] > y) != (b[1] > y))
    return list(zip(xs[::2], xs[1::2]))


def common_volume(wall, openings):
    """Of a swept wall and openings apart from each other, by lines along the wall."""
    outline, bottom, top = wall
    low, high = (f(p[1] for edge in outline for p in edge) for f in (min, max))
    volume, lines = 0, 1000
    for k in range(lines):
        y = low + (high - low) * (k + 0.5) / lines
        for hole, hole_bottom, hole_top in openings:
            height = min(top, hole_top) - max(bottom, hole_bottom)
            volume += max(height, 0) * sum(max(0, min(b, d) - max(a, c)) for a, b in stretches(outline, y)
                                           for c, d in stretches(hole, y)) * (high - low) / lines
    return volume


class WebIfc(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_volumes_of_spaces(self):
        for arcs in ("exact", "facets"):
            found = opened(write(TOOL, house(), self.folder, "--ifc-arcs", arcs))
            self.assertEqual(found["said"], [])
            for number, volume in VOLUMES.items():
                of_space = found["products"]["IFCSPACE %d" % number]["volume"]
                self.assertAlmostEqual(of_space / volume, 1, delta=0.001, msg=str(number))

    def test_heights_stand_above_their_storey(self):
        products = opened(write(TOOL, house(), self.folder))["products"]
        self.assertAlmostEqual(products["IFCSPACE 4"]["low"][2], 2.8, 5)
        self.assertAlmostEqual(products["IFCSPACE 4"]["high"][2], 5.8, 5)
        self.assertAlmostEqual(products["IFCSLAB room_4_floor_slab"]["low"][2], 2.5, 5)

    def test_roofs_cut_their_walls(self):
        """The roof of room 4 is at 4.3 m over y = 4.1 and rises by one in two; its walls start at 2.8 m, are
        0.2 m thick and meet at mitres. A wall below a plane is as large as its plan is, times its height over
        the middle of the plan."""
        path = write(TOOL, house(), self.folder)
        products = opened(path)["products"]
        gable, eaves, high = (products["IFCWALL room_4_wall_%d" % k] for k in (2, 1, 3))
        self.assertAlmostEqual(gable["high"][2], 5.8 + 0.1, 3)  # over the outer end of the mitre
        self.assertAlmostEqual(gable["volume"], (3 + 3.4) / 2 * 0.2 * 2.25, 3)
        self.assertAlmostEqual(eaves["high"][2], 4.3, 3)
        # A trapeze's middle is nearer to its longer side.
        middle = 0.2 * (5 + 2 * 5.4) / (3 * (5 + 5.4))
        self.assertAlmostEqual(eaves["volume"], 5.2 * 0.2 * (1.5 - 0.5 * middle), 3)
        self.assertAlmostEqual(high["volume"], 5.2 * 0.2 * (3 + 0.5 * middle), 3)
        kinds = [name for name, _ in step_reader.read(path).values()]
        self.assertEqual(kinds.count("IFCBOOLEANCLIPPINGRESULT"), 4)

    def test_openings_cut_their_walls(self):
        plan = house()
        with_doors = opened(write(TOOL, plan, self.folder))["products"]
        doorways = plan.pop("doorways")
        plan["rooms"][1]["niches"] = []
        without = opened(write(TOOL, plan, self.folder))["products"]
        cut = {name: p["volume"] - with_doors[name]["volume"] for name, p in without.items()
               if name.startswith("IFCWALL")}
        expected = {"IFCWALL room_1_wall_3": 0.9 * 2.05 * 0.1, "IFCWALL room_2_wall_2": 0.9 * 2.05 * 0.2,
                    "IFCWALL room_1_wall_4": 1 * 2.05 * 0.2, "IFCWALL room_2_wall_3": 1 * 1 * 0.1}
        for name, volume in cut.items():
            if name == "IFCWALL room_5_wall_1":  # a ring: the opening is across an arc
                self.assertAlmostEqual(volume, 0.8 * 2.05 * 0.2, delta=0.01)
            else:
                self.assertAlmostEqual(volume, expected.get(name, 0), 3, name)
        self.assertLessEqual(set(expected), set(cut))
        self.assertEqual(len(doorways), 4)

    def test_nothing_is_lost(self):
        path = write(TOOL, house(), self.folder)
        products = opened(path)["products"]
        kinds = ("IFCSPACE", "IFCWALL", "IFCSLAB", "IFCCOLUMN", "IFCBEAM", "IFCCOVERING")
        for name, values in step_reader.read(path).values():
            if name in kinds:
                self.assertGreater(products["%s %s" % (name, values[2])]["volume"], 0)

    def expect_cuts(self, plan, what):
        """Every opening takes as much of its wall as is in both, of walls below roofs and vaults at least
        something."""
        path = write(TOOL, plan, self.folder, "--ifc-arcs", "facets", name="with")
        instances, products = step_reader.read(path), opened(path)["products"]
        hosted = {}
        for name, v in instances.values():
            if name == "IFCRELVOIDSELEMENT":
                hosted.setdefault(v[4], []).append(v[5])
        whole = os.path.join(self.folder, "without.ifc")
        with open(path) as file, open(whole, "w") as copy:
            copy.writelines(line for line in file if "=IFCRELVOIDSELEMENT(" not in line)
        without = opened(whole)["products"]
        for host, openings in hosted.items():
            name = "IFCWALL " + instances[host][1][2]
            cut = without[name]["volume"] - products[name]["volume"]
            wall = swept_body(instances, host)
            if wall is None:
                self.assertGreater(cut, 0.001, what + name)
                continue
            expected = common_volume(wall, [swept_body(instances, n) for n in openings])
            self.assertGreater(expected, 0.001, what + name)
            self.assertAlmostEqual(cut, expected, delta=0.005 * expected + 1e-4, msg=what + name)
        return len(hosted)

    def test_openings_cut_as_much_as_they_should(self):
        """In walls of one face and of two, curved ones, and those about a core within a room."""
        self.assertEqual(self.expect_cuts(house(), "house "), 5)
        ring = room(1, rectangle(0, 0, 12, 12), slab(0), slab(3), columns=[rectangle(3, 3, 9, 9, clockwise=True)])
        core = room(2, rectangle(3.1, 3.2, 8, 8), slab(0), slab(2.6))
        plan = dict(house(), rooms=[ring, core], storeys=[], doorways=[
            doorway([1, 2], [5, 3.1], [6, 3.1]), doorway([1, 2], [3.05, 4], [3.05, 5]), doorway([0, 1], [9, 5], [9, 6])])
        self.assertEqual(self.expect_cuts(plan, "core "), 3)

    def test_plans_named_in_the_environment(self):
        """SEDR_PLANS: files of plans, parted by colons; for plans of real scans."""
        for plan in filter(None, os.environ.get("SEDR_PLANS", "").split(":")):
            path = os.path.join(self.folder, "real.ifc")
            subprocess.run([TOOL, plan, path], check=True)
            products = opened(path)["products"]
            with open(plan) as file:
                self.expect_cuts(json.load(file), plan + " ")
            for name, volume in net_volumes(step_reader.read(path)).items():
                self.assertAlmostEqual(products[name]["volume"] / volume, 1, delta=0.001, msg=plan + " " + name)
            for name, product in products.items():
                self.assertGreater(product["volume"], 0, plan + " " + name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
