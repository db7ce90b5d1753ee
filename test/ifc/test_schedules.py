#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Schedules, building model and sheet of a plan tell the same numbers.

    test_schedules.py pcl_floorplan_ifc pcl_floorplan_drawing
"""

import csv
import math
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import step_reader
from ifc_samples import VOLUMES, house_with_doors, write

IFC, DRAWING = sys.argv[1:3]
TEXT = "{http://www.w3.org/2000/svg}text"


def quantities(instances):
    """{object: {name: value}} of all quantity sets."""
    found = {}
    for kind, v in instances.values():
        if kind == "IFCRELDEFINESBYPROPERTIES" and instances[v[5]][0] == "IFCELEMENTQUANTITY":
            for thing in v[4]:
                for quantity in instances[v[5]][1][5]:
                    found.setdefault(thing, {})[instances[quantity][1][0]] = instances[quantity][1][3]
    return found


def properties(instances):
    """{object: {name: value}} of all property sets."""
    found = {}
    for kind, v in instances.values():
        if kind == "IFCRELDEFINESBYPROPERTIES" and instances[v[5]][0] == "IFCPROPERTYSET":
            for thing in v[4]:
                for single in instances[v[5]][1][4]:
                    found.setdefault(thing, {})[instances[single][1][0]] = instances[single][1][2].value
    return found


class SchedulesAgree(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.plan = house_with_doors()
        cls.plan["names"] = {"2": 'Cell, "north"'}
        hall, cell = cls.plan["rooms"][:2]
        hall["boundary"][0]["accuracy"] = {"standard_error": 0.0004, "deviation_95": 0.012}
        hall["boundary"][2]["accuracy"] = {"standard_error": 0.002, "deviation_95": 0.005}
        cell["boundary"][0]["accuracy"] = {"standard_error": 0.001, "deviation_95": 0.02}
        cell["floor"]["accuracy"] = {"standard_error": 0.003, "deviation_95": 0.06}
        cls.plan["openings"][0].update(residual=0.002, deviation_95=0.006)
        cls.plan["openings"][1].update(residual=0.02)  # nothing shows its edges
        path = write(IFC, cls.plan, folder.name, "--schedules", folder.name)
        cls.instances = step_reader.read(path)
        cls.sizes = quantities(cls.instances)
        cls.properties = properties(cls.instances)
        cls.tables = {}
        for name in ("rooms", "openings", "walls"):
            with open(os.path.join(folder.name, name + ".csv"), newline="", encoding="utf-8") as file:
                cls.tables[name] = list(csv.DictReader(file))
        cls.texts = set()
        for storey in ("1", "2"):
            sheet = os.path.join(folder.name, "sheet.svg")
            subprocess.run([DRAWING, os.path.join(folder.name, "model.json"), sheet, "--storey", storey, "--scale", "20"],
                           check=True)
            cls.texts |= {t.text for t in xml.etree.ElementTree.parse(sheet).iter(TEXT)}

    def things(self, kind):
        return {number: v for number, (name, v) in self.instances.items() if name == kind}

    def expect_same(self, row, sizes, columns):
        for column, name in columns.items():
            self.assertAlmostEqual(float(row[column]), sizes[name], 6, (row, name))

    def expect_accuracy(self, row, thing, stated, of=""):
        """Standard error and deviation, mm, and both levels: the stated ones in schedule and model."""
        names = ("standard_error_mm", "deviation_95_mm", "measured_accuracy", "represented_accuracy")
        self.assertEqual(tuple(row[of + name] for name in names), stated, row)
        told = self.properties[thing]
        self.assertEqual((told["MeasuredAccuracy"], told["RepresentedAccuracy"]), stated[2:])
        for name, text in zip(("StandardError", "Deviation95"), stated):
            self.assertEqual("%.1f" % (1000 * told[name]) if name in told else "", text)

    def test_accuracy(self):
        unknown = ("", "", "not measured", "not measured")
        walls = {v[7]: number for number, v in self.things("IFCWALL").items()}
        for row in self.tables["walls"]:
            stated = {"1.1": ("0.4", "12.0", "LOA50", "LOA30"), "1.3": ("2.0", "20.0", "LOA40", "LOA20")}  # the worse face
            self.expect_accuracy(row, walls[row["number"]], stated.get(row["number"], unknown))
        slabs = {v[2]: number for number, v in self.things("IFCSLAB").items()}
        for row in self.tables["rooms"]:
            stated = ("3.0", "60.0", "LOA30", "LOA10") if row["room"] == "2" else unknown
            self.expect_accuracy(row, slabs["room_%s_floor_slab" % row["room"]], stated, "floor_")
        fillings = {v[7]: number for kind in ("IFCDOOR", "IFCWINDOW") for number, v in self.things(kind).items()}
        for row in self.tables["openings"]:
            self.expect_accuracy(row, fillings[row["number"]], ("2.0", "6.0", "LOA40", "LOA30") if row["number"] == "D1" else unknown)

    def test_rooms(self):
        spaces = {v[2]: number for number, v in self.things("IFCSPACE").items()}
        self.assertEqual({row["room"] for row in self.tables["rooms"]}, set(spaces))
        for row in self.tables["rooms"]:
            self.expect_same(row, self.sizes[spaces[row["room"]]],
                             {"area_m2": "NetFloorArea", "perimeter_m": "GrossPerimeter", "height_m": "Height",
                              "volume_m3": "NetVolume"})
            self.assertIn("%.2f m\u00b2" % float(row["area_m2"]), self.texts)
            volume = VOLUMES[int(row["room"])]  # arcs of the solid are chords
            self.assertAlmostEqual(float(row["volume_m3"]), volume, delta=0.0005 * volume)
        attic = self.tables["rooms"][3]  # from 1.5 m to 3 m: two thirds of 15 m2 are at least 2 m high
        self.assertEqual((attic["storey"], attic["area_above_1.5m_m2"]), ("attic, \u00fcber \u20ac 'x' \\", "15.000"))
        self.assertAlmostEqual(float(attic["area_above_2.0m_m2"]), 10, delta=0.3)
        self.assertAlmostEqual(float(attic["lowest_m"]), 1.5)
        self.assertAlmostEqual(float(attic["highest_m"]), 3)
        self.assertEqual(self.tables["rooms"][1]["name"], 'Cell, "north"')
        self.assertIn("h %.2f m" % float(self.tables["rooms"][2]["height_m"]), self.texts)

    def test_openings(self):
        fillings = {v[7]: (number, v) for kind in ("IFCDOOR", "IFCWINDOW") for number, v in self.things(kind).items()}
        rows = {row["number"]: row for row in self.tables["openings"]}
        self.assertEqual(set(rows), {"D1", "W1", "W2"})
        self.assertEqual(set(fillings), set(rows))
        for mark, row in rows.items():
            number, attributes = fillings[mark]
            self.expect_same(row, self.sizes[number], {"width_m": "Width", "height_m": "Height"})
            self.assertAlmostEqual(attributes[8], float(row["height_m"]), 6)
            self.assertAlmostEqual(attributes[9], float(row["width_m"]), 6)
            size = "%s %.2f x %.2f" % (mark, float(row["width_m"]), float(row["height_m"]))
            self.assertTrue(any(text.startswith(size) for text in self.texts), size)
        self.assertEqual((rows["D1"]["leaf"], rows["D1"]["opens_into"], rows["W1"]["to_room"]), ("left", "1", "outside"))
        self.assertEqual((rows["W1"]["sill_m"], rows["W1"]["head_m"]), ("0.900", "2.100"))

    def test_walls(self):
        walls = {v[7]: number for number, v in self.things("IFCWALL").items()}
        rows = {row["number"]: row for row in self.tables["walls"]}
        self.assertEqual(set(rows), set(walls))
        for number, row in rows.items():
            self.expect_same(row, self.sizes[walls[number]],
                             {"length_m": "Length", "height_m": "Height", "thickness_m": "Width",
                              "gross_area_m2": "GrossSideArea", "net_area_m2": "NetSideArea"})
        window, inner = rows["1.1"], rows["1.3"]  # with the window of 1 m by 1.2 m; with the door of 0.9 m
        self.assertEqual((window["external"], inner["external"]), ("yes", "no"))
        self.assertAlmostEqual(float(window["gross_area_m2"]), 6 * 3, 3)
        self.assertAlmostEqual(float(window["net_area_m2"]), 6 * 3 - 1.2, 3)
        self.assertAlmostEqual(float(inner["gross_area_m2"]) - float(inner["net_area_m2"]), 0.9 * 2.05, 3)
        self.assertEqual((inner["thickness_m"], inner["thickness_known_by"], inner["other_face"]), ("0.100", "faces", "2.1"))
        self.assertAlmostEqual(float(rows["5.1"]["length_m"]), 6 * math.pi, 3)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
