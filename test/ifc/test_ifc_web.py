#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What web-ifc, an independent reader, makes of the IFC files that SEDR writes: volumes of spaces and walls,
openings that cut. Skipped without node and web-ifc (npm install web-ifc; NODE_PATH says where).

    test_ifc_web.py pcl_floorplan_ifc
"""

import math
import sys
import tempfile
import unittest

import step_reader
import web_ifc
from ifc_samples import VOLUMES, house, house_with_doors, opening, passage, write
from plan_samples import arc, rectangle, room, segment, slab
from web_ifc import opened

TOOL = sys.argv[1]
if not web_ifc.is_there():
    print("skipped: node finds no web-ifc (npm install web-ifc, and NODE_PATH)")
    sys.exit(77)


class WebIfc(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_volumes_of_spaces(self):
        for arcs in ("exact", "faceted"):
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

    def test_walls_end_at_their_roof(self):
        """The roof of room 4 is at 4.3 m over y = 4.1 and rises by one in two; its walls start at 2.8 m, are
        0.2 m thick and meet at mitres. The top of a wall is the ceiling along its face."""
        products = opened(write(TOOL, house(), self.folder))["products"]
        gable, eaves, high = (products["IFCWALL room_4_wall_%d" % k] for k in (2, 1, 3))
        self.assertAlmostEqual(gable["high"][2], 5.8, 2)
        self.assertAlmostEqual(gable["volume"], (3 + 3.4) / 2 * 0.2 * 2.25, delta=0.02)
        self.assertAlmostEqual(eaves["high"][2], 4.3, 1)
        self.assertAlmostEqual(eaves["volume"], 5.2 * 0.2 * 1.5, 1)
        self.assertAlmostEqual(high["volume"], 5.2 * 0.2 * 3, 1)

    def test_openings_cut_their_walls(self):
        plan = house()
        with_doors = opened(write(TOOL, plan, self.folder))["products"]
        openings = plan.pop("openings")
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
        self.assertEqual(len(openings), 4)

    def products_apart(self, plan):
        """All products of a plan, none of which is lost or stands in a space."""
        path = write(TOOL, plan, self.folder)
        products = opened(path, with_triangles=True)["products"]
        self.assertEqual([f for f in web_ifc.within_spaces(products) if f[0] > 0.002], [])
        self.assertEqual(web_ifc.lost(step_reader.read(path), products), [])
        return products

    def test_nothing_is_lost(self):
        path = write(TOOL, house(), self.folder)
        products = opened(path)["products"]
        self.assertEqual(web_ifc.lost(step_reader.read(path), products), [])

    def test_no_wall_stands_in_a_space(self):
        """A room that ends in a point behind a wall whose other face was not seen; a niche that goes on past
        the corner of its room, into both walls, and one with a sloping top; a post of 7 cm between a recess and a niche, which the
        solid fills."""
        beside_post = [[30, 0], [40, 0], [40, 4], [37.55, 4], [37.55, 4.22], [36.016, 4.221], [36.031, 4.069],
                       [36.1, 4.072], [36.1, 4], [30.45, 4], [30, 4]]
        niche = [[36.0255, 4.0001], [36.026, 4.2214], [30.45, 4.2255], [30.45, 4]]

        def loop(corners, residuals):
            return [segment(a, b, residual=r) for a, b, r in zip(corners, corners[1:] + corners[:1], residuals)]

        pointed = [[4.05, 4 / 3], [7, 4 / 3 - 1.7], [7, 4 / 3 + 1.7]]
        plan = dict(house(), rooms=[
            room(1, rectangle(0, 0, 4, 3), slab(0), slab(2.5)),
            room(2, [segment(a, b) for a, b in zip(pointed, pointed[1:] + pointed[:1])], slab(0), slab(2.5)),
            room(3, rectangle(10, 0, 14, 3), slab(0), slab(2.5),
                 niches=[{"bottom": slab(1), "top": slab(2), "boundary": rectangle(13, 3, 14.1, 3.15)}]),
            room(4, rectangle(20, 0, 24, 3), slab(0), slab(2.5),
                 niches=[{"bottom": slab(1), "top": slab(-0.1, 0.1), "boundary": rectangle(21, 3, 23, 3.15)}]),
            room(5, loop(beside_post, [0.004, 0.004, 0.013, 0.005, 0.006, 0, 0, 0, 0.013, 0.013, 0.004]), slab(0),
                 slab(2.5), niches=[{"bottom": slab(0.2), "top": slab(2.3),
                                     "boundary": loop(niche, [0, 0.005, 0, 0.013])}])],
                    storeys=[], stairs=[], openings=[])
        products = self.products_apart(plan)
        # The wall of room 1 ends at the point of room 2.
        point = 0.15 * 0.15 * 1.7 / 2.95
        corners = 2 * 0.2 * 0.2 / 2  # of mitres
        self.assertAlmostEqual(products["IFCWALL room_1_wall_2"]["volume"], (3 * 0.2 + corners - point) * 2.5, 3)

    def test_tilted_walls_lean_with_their_room(self):
        """By 10 degrees out of the room, in one wall of 4 m with a passage."""
        loop = rectangle(0, 0, 4, 3)
        loop[0]["tilt"] = -10
        plan = dict(house(), version=2, rooms=[room(1, loop, slab(0), slab(2.5))], storeys=[], stairs=[],
                    openings=[passage([0, 1], [1, 0], [1.9, 0])])
        products = self.products_apart(plan)
        out = 2.5 * math.tan(math.radians(10))
        self.assertAlmostEqual(products["IFCSPACE 1"]["volume"], 4 * (3 + out / 2) * 2.5, 3)
        wall = products["IFCWALL room_1_wall_1"]
        self.assertAlmostEqual(wall["low"][1], -0.2 - out, 4)
        self.assertAlmostEqual(wall["high"][1], 0, 4)
        self.assertAlmostEqual(wall["volume"], (4 * 0.2 + 0.04) * 2.5 - 0.9 * 2.05 * 0.2, 3)
        self.assertEqual(self.expect_cuts(plan, "tilted "), 1)

    def test_a_wall_with_one_tilted_face_tapers(self):
        """20 cm thick at the foot, one of its faces tilted by 3 degrees towards the other."""
        loop = rectangle(4.2, 0, 8, 3)
        loop[3]["tilt"] = -3
        plan = dict(house(), version=2, rooms=[room(1, rectangle(0, 0, 4, 3), slab(0), slab(2.5)),
                                               room(2, loop, slab(0), slab(2.5))], storeys=[], stairs=[],
                    openings=[passage([1, 2], [4.1, 1], [4.1, 1.9])])
        products = self.products_apart(plan)
        whole = opened(write(TOOL, dict(plan, openings=[]), self.folder, name="whole"))["products"]
        name = "IFCWALL room_1_wall_2"
        taken = 0.9 * 2.05 * (0.2 - math.tan(math.radians(3)) * 2.05 / 2)
        self.assertAlmostEqual(whole[name]["volume"] - products[name]["volume"], taken, 4)
        self.assertEqual(self.expect_cuts(plan, "tapered "), 1)

    def expect_cuts(self, plan, what):
        """Every opening takes as much of its wall as is in both, of walls below roofs and vaults at least
        something. Net volumes are those of the bodies, up to their rounding."""
        path = write(TOOL, plan, self.folder, "--ifc-arcs", "faceted", name="with")
        instances, products = step_reader.read(path), opened(path)["products"]
        for name, volume in web_ifc.net_volumes(instances).items():
            body = products[name]["volume"]
            self.assertAlmostEqual(volume, body, delta=0.001 * body + 0.0006, msg=what + name)
        for name, wall in web_ifc.fillings(instances):
            self.assertIsNotNone(wall, what + name)
            self.assertGreater(products[name]["volume"], 0.001, what + name)
        cuts = web_ifc.cuts(path, instances, products)
        for name, cut, expected in cuts:
            self.assertGreater(cut if expected is None else expected, 0.001, what + name)
            if expected is not None:
                self.assertAlmostEqual(cut, expected, delta=0.005 * expected + 1e-4, msg=what + name)
        return len(cuts)

    def test_openings_cut_as_much_as_they_should(self):
        """In walls of one face and of two, curved ones, and those about a core within a room."""
        self.assertEqual(self.expect_cuts(house(), "house "), 5)
        self.assertEqual(self.expect_cuts(house_with_doors(), "doors "), 4)  # and a niche
        ring = room(1, rectangle(0, 0, 12, 12), slab(0), slab(3), columns=[rectangle(3, 3, 9, 9, clockwise=True)])
        core = room(2, rectangle(3.1, 3.2, 8, 8), slab(0), slab(2.6))
        plan = dict(house(), rooms=[ring, core], storeys=[], stairs=[], openings=[
            passage([1, 2], [5, 3.1], [6, 3.1]), passage([1, 2], [3.05, 4], [3.05, 5]), passage([0, 1], [9, 5], [9, 6])])
        self.assertEqual(self.expect_cuts(plan, "core "), 3)

    def test_openings_cut_a_curved_wall_wherever_they_are(self):
        """A window of 1 m in a ring from 4 m to 4.2 m."""
        def below(radius, x=0.5):
            return x * math.sqrt(radius ** 2 - x ** 2) + radius ** 2 * math.asin(x / radius)

        for degrees in (0, 60, 184):
            a = math.radians(degrees)
            ends = [[4.1 * math.cos(a) + w * math.sin(a), 4.1 * math.sin(a) - w * math.cos(a)] for w in (0.5, -0.5)]
            plan = dict(house(), rooms=[room(1, [arc([0, 0], 4, [4, 0], [4, 0])], slab(0), slab(2.5))],
                        storeys=[], stairs=[], openings=[opening("window", [1, 0], *ends, 0.9, 2)])
            path = write(TOOL, plan, self.folder, "--ifc-arcs", "faceted")
            (_, cut, _), = web_ifc.cuts(path, step_reader.read(path), opened(path)["products"])
            self.assertAlmostEqual(cut, (below(4.2) - below(4)) * 1.1, 3, degrees)

    def test_openings_that_overlap_and_pass_through_the_roof(self):
        """The roof rises along a wall from 1.5 m to 3.5 m, through a window; another window overlaps it, so does
        a niche; one is at the mitre."""
        plan = dict(house(), rooms=[room(1, rectangle(0, 0, 4, 3), slab(0), slab(1.5, 0.5), niches=[
            {"bottom": slab(1), "top": slab(1.6, 0.1), "boundary": rectangle(1.8, -0.1, 2.6, 0)}])],
                    storeys=[], stairs=[], openings=[
            opening("window", [1, 0], [1, -0.1], [2, -0.1], 0.9, 2.25),
            opening("window", [1, 0], [1.5, -0.1], [3, -0.1], 0.5, 1.2),
            opening("window", [1, 0], [3.5, -0.1], [4, -0.1], 0.5, 1.2)])
        self.assertEqual(self.expect_cuts(plan, "roof "), 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
