#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The figures of ifc_round_trip.py, on models whose truth is known.

    test_ifc_round_trip.py pcl_floorplan_ifc
"""

import json
import os
import sys
import tempfile
import unittest

import ifc_round_trip
from ifc_samples import rectangle, room, slab, write

TOOL = sys.argv[1]


def true_room(name, x0, y0, x1, y1, height, parts=()):
    area = (x1 - x0) * (y1 - y0)
    return {"id": name, "name": name, "plan": [{"exterior": [[x0, y0], [x1, y0], [x1, y1], [x0, y1]], "holes": []}],
            "area": area, "volume": area * height, "floor": 0, "ceiling": height, "scanned": True, "shaft": False,
            "space_ids": list(parts)}


class RoundTrip(unittest.TestCase):
    def figures(self, rooms, truth, parts=()):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "truth_spaces.json"), "w") as file:
                json.dump({"rooms": truth, "spaces": list(parts)}, file)
            plan = {"format": "sedr-floorplan", "version": 1, "unit": "m", "rooms": rooms}
            return ifc_round_trip.figures(write(TOOL, plan, folder), folder)

    def test_a_model_that_is_the_truth(self):
        rooms = [room(1, rectangle(0, 0, 4, 3), slab(0), slab(2.5)),
                 room(2, rectangle(4.2, 0, 9, 3), slab(0), slab(2.5, 0, 0.2))]
        truth = [true_room("a", 0, 0, 4, 3, 2.5), true_room("b", 4.2, 0, 9, 3, 2.8)]
        found = self.figures(rooms, truth)
        self.assertEqual(found["spaces true / found / matched"], "2 / 2 / 2")
        self.assertEqual(found["plan in common, median"], "1.000")
        self.assertEqual(found["error of area, median / largest"], "0.00 % / 0.00 %")
        self.assertEqual(found["error of volume, median / largest"], "0.00 % / 0.00 %")
        self.assertEqual(found["walls of the model / with two faces"], "7 / 1")
        self.assertEqual(found["walls of the model on a true face"], "7")
        self.assertIn("(100 %)", found["true faces / with a wall within 5 cm"])
        self.assertEqual(found["error of thickness, median"], "0.0 cm")

    def test_a_wall_that_is_off(self):
        truth = [true_room("a", 0, 0, 4, 3, 2.5)]
        found = self.figures([room(1, rectangle(0, 0, 4, 2.8), slab(0), slab(2.5))], truth)
        self.assertEqual(found["spaces true / found / matched"], "1 / 1 / 1")
        self.assertEqual(found["error of area, median / largest"], "6.67 % / 6.67 %")
        self.assertEqual(found["walls of the model on a true face"], "3")
        self.assertIn("14.0 m / 9.", found["true faces / with a wall within 5 cm"])
        far = self.figures([room(1, rectangle(10, 0, 14, 3), slab(0), slab(2.5))], truth)
        self.assertEqual(far["spaces true / found / matched"], "1 / 1 / 0")

    def test_rooms_without_a_wall_between_count_as_one_or_as_two(self):
        whole = [true_room("a + b", 0, 0, 8, 3, 2.5, ("a", "b"))]
        parts = [true_room("a", 0, 0, 4, 3, 2.5), true_room("b", 4, 0, 8, 3, 2.5)]
        one = [room(1, rectangle(0, 0, 8, 3), slab(0), slab(2.5))]
        two = [room(1, rectangle(0, 0, 4, 3), slab(0), slab(2.5)), room(2, rectangle(4, 0, 8, 3), slab(0), slab(2.5))]
        key = "spaces true / found / matched"
        self.assertEqual(self.figures(one, whole, parts)[key], "1 / 1 / 1")
        self.assertEqual(self.figures(two, whole, parts)[key], "2 / 2 / 2")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
