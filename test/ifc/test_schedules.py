#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Schedules, building model, sheets and report tell the same numbers: of a plan known in closed form, and of a
simulated scan of two storeys.

    test_schedules.py pcl_floorplan_ifc pcl_floorplan_drawing pcl_simulate_indoor_scan pcl_sedr
"""

import csv
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

from shapely.geometry import Polygon

import step_reader
from ifc_samples import VOLUMES, house_with_doors, write

IFC, DRAWING, SIMULATOR, SEDR = sys.argv[1:5]
SVG = "{http://www.w3.org/2000/svg}"
SCALE = 20  # of the sheets, whose units are millimetres; Cairo's coordinates are exact to 1/256
ROUNDING = 0.0006  # metres, of schedules, whose sizes are whole millimetres, and of the paper
TWO_DIGITS = 0.005 + ROUNDING  # texts of sheets


def loops_of(path):
    """The closed loops of straight lines in a path, metres; none if it has curves."""
    d = path.get("d")
    if "C" in d:
        return []
    loops = ([tuple(float(x) * SCALE / 1000 for x in p) for p in re.findall(r"[ML] (\S+) (\S+)", part)]
             for part in d.split("Z"))
    return [loop for loop in loops if len(loop) > 2]


def sides_of(loop):
    return list(zip(loop, loop[1:] + loop[:1]))


class FilesAgree:
    """Compares the files of a class's model, each row of the schedules with what the others tell of it."""

    report = None

    @classmethod
    def read(cls, ifc, folder, plan, storeys):
        cls.instances = step_reader.read(ifc)
        cls.sizes = step_reader.sets(cls.instances, "IFCELEMENTQUANTITY")
        cls.properties = step_reader.sets(cls.instances, "IFCPROPERTYSET")
        cls.tables, cls.sheets = {}, {}
        for name in ("rooms", "openings", "walls"):
            with open(os.path.join(folder, name + ".csv"), newline="", encoding="utf-8") as file:
                cls.tables[name] = list(csv.DictReader(file))
        for number, name in enumerate(storeys, 1):
            sheet = os.path.join(folder, "sheet.svg")
            subprocess.run([DRAWING, plan, sheet, "--storey", str(number), "--scale", str(SCALE)], check=True)
            cls.sheets[name] = xml.etree.ElementTree.parse(sheet).getroot()

    def things(self, kind):
        return {number: v for number, (name, v) in self.instances.items() if name == kind}

    def texts(self, storey):
        return [t.text for t in self.sheets[storey].iter(SVG + "text")]

    def group(self, storey, name):
        return next(g for g in self.sheets[storey].iter(SVG + "g") if g.get("id") == name)

    def outline(self, room):
        """The loops of a room on its sheet."""
        storey = next(row["storey"] for row in self.tables["rooms"] if row["room"] == room)
        return loops_of(next(self.group(storey, "room_" + room).iter(SVG + "path")))

    def expect_same(self, row, found, columns):
        for column, name in columns.items():
            self.assertAlmostEqual(float(row[column]), found[name], delta=ROUNDING, msg="%s %s" % (row, name))

    def expect_text(self, storey, pattern, *sizes):
        """A text of a sheet with these numbers."""
        found = [[float(x) for x in m.groups()] for m in (re.match(pattern, t) for t in self.texts(storey)) if m]
        self.assertTrue(any(all(abs(x - size) < TWO_DIGITS for x, size in zip(numbers, sizes)) for numbers in found),
                        (pattern, sizes, found))

    def test_rooms_agree(self):
        spaces = {v[2]: number for number, v in self.things("IFCSPACE").items()}
        self.assertEqual({row["room"] for row in self.tables["rooms"]}, set(spaces))
        for row in self.tables["rooms"]:
            self.expect_same(row, self.sizes[spaces[row["room"]]],
                             {"area_m2": "NetFloorArea", "perimeter_m": "GrossPerimeter", "height_m": "Height",
                              "volume_m3": "NetVolume"})
            self.expect_text(row["storey"], r"([0-9.]+) m\u00b2$", float(row["area_m2"]))
            if row["lowest_m"] == row["highest_m"]:
                self.expect_text(row["storey"], r"h ([0-9.]+) m", float(row["height_m"]))
            loops = self.outline(row["room"])
            if loops:
                self.expect_same(row, {"perimeter": Polygon(loops[0]).length}, {"perimeter_m": "perimeter"})
                area = Polygon(loops[0], loops[1:]).area
                self.assertAlmostEqual(float(row["area_m2"]), area, delta=ROUNDING * math.sqrt(area))

    def test_openings_agree(self):
        fillings = {v[7]: (number, v) for kind in ("IFCDOOR", "IFCWINDOW") for number, v in self.things(kind).items()}
        self.assertEqual({row["number"] for row in self.tables["openings"] if row["kind"] != "passage"}, set(fillings))
        for row in self.tables["openings"]:
            width, height = float(row["width_m"]), float(row["height_m"])
            self.expect_text(row["storey"], row["number"] + r" ~?([0-9.]+) x ([0-9.]+)", width, height)
            gaps = [side for path in self.group(row["storey"], "openings").iter(SVG + "path")
                    if "stroke:none" in path.get("style") for loop in loops_of(path) for side in sides_of(loop)]
            self.assertTrue(any(abs(math.dist(*side) - width) < ROUNDING for side in gaps), row)
            self.assertAlmostEqual(float(row["head_m"]) - float(row["sill_m"]), height, delta=0.0011)
            if row["kind"] != "passage":
                number, attributes = fillings[row["number"]]
                self.expect_same(row, self.sizes[number], {"width_m": "Width", "height_m": "Height"})
                self.expect_same(row, attributes, {"width_m": 9, "height_m": 8})

    def test_walls_agree(self):
        walls = {v[7]: number for number, v in self.things("IFCWALL").items()}
        self.assertEqual({row["number"] for row in self.tables["walls"]}, set(walls))
        compared = 0
        for row in self.tables["walls"]:
            self.expect_same(row, self.sizes[walls[row["number"]]],
                             {"length_m": "Length", "height_m": "Height", "thickness_m": "Width",
                              "gross_area_m2": "GrossSideArea", "net_area_m2": "NetSideArea"})
            faces = [self.outline(name.split(".")[0]) for name in (row["number"], row["other_face"]) if name]
            if not all(faces):
                continue
            near, *far = [sides_of(loops[0])[int(re.search(r"\.(\d+)", name)[1]) - 1]
                          for loops, name in zip(faces, (row["number"], row["other_face"]))]
            drawn = {"length": math.dist(*near)}
            if far:
                middle = [sum(x) / 2 for x in zip(*near)]
                drawn["thickness"] = 2 * Polygon([middle, *far[0]]).area / math.dist(*far[0])
                self.expect_same(row, drawn, {"thickness_m": "thickness"})
                compared += 1
            elif row["external"] == "yes" and not any(
                    other["number"].startswith(row["number"].split("-")[0] + "-") for other in self.tables["walls"]):
                self.expect_same(row, drawn, {"length_m": "length"})  # the whole of a face
        self.assertGreater(compared, 0)

    def test_levels_agree(self):
        levels = [v[9] for v in self.things("IFCBUILDINGSTOREY").values()]
        for storey, level in zip(self.sheets, levels):
            self.expect_text(storey, "\u25bc [\u00b1+]?([-0-9.]+)", level - levels[0])


class Simulated(FilesAgree, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        scene, model = (os.path.join(folder.name, name) for name in ("scene", "model"))
        for command in ([SIMULATOR, "stairs_and_closet", scene, "--rays", "20000"],
                        [SEDR, os.path.join(scene, "scan.pcd"), model, "--no-mesh"]):
            subprocess.run(command, check=True, capture_output=True)
        with open(os.path.join(model, "report.json"), encoding="utf-8") as file:
            cls.report = json.load(file)
        cls.read(os.path.join(model, "model.ifc"), model, os.path.join(model, "floorplan.json"),
                 [storey["name"] for storey in cls.report["storeys"]])

    def test_the_report_agrees(self):
        for name, table in self.tables.items():
            told = self.report["schedules"][name]
            self.assertEqual([dict(zip(told["columns"], row)) for row in told["rows"]], table)
        for row, told in zip(self.tables["rooms"], self.report["rooms"]):
            self.expect_same(row, told, {"room": "id", "area_m2": "area", "perimeter_m": "perimeter", "height_m": "height",
                                         "volume_m3": "volume"})
        told = {opening["number"]: opening for opening in self.report["openings"]}
        self.assertEqual(set(told), {row["number"] for row in self.tables["openings"]})
        self.assertGreater(len(told), 6)
        for row in self.tables["openings"]:
            self.expect_same(row, told[row["number"]], {"width_m": "width", "height_m": "height"})
        levels = [v[9] for v in self.things("IFCBUILDINGSTOREY").values()]
        for storey, level in zip(self.report["storeys"], levels):
            self.assertAlmostEqual(storey["floor"] - self.report["storeys"][0]["floor"], level - levels[0], delta=0.001)


class InClosedForm(FilesAgree, unittest.TestCase):
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
        cls.plan["openings"][0]["edges"] = [{"seen": seen, "error": error} for seen, error in
                                            (("reveal", 0.001), ("rim", 0.002), ("nothing", 0), ("reveal", 0.001))]
        cls.plan["openings"][1].update(residual=0.02, depth=0.32, walls=[{"room": 1, "element": 0}])  # nothing shows its edges
        path = write(IFC, cls.plan, folder.name, "--schedules", folder.name)
        cls.read(path, folder.name, os.path.join(folder.name, "model.json"), [storey["name"] for storey in cls.plan["storeys"]])

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
        for row in self.tables["rooms"]:
            volume = VOLUMES[int(row["room"])]  # arcs of the solid are chords
            self.assertAlmostEqual(float(row["volume_m3"]), volume, delta=0.0005 * volume)
        attic = self.tables["rooms"][3]  # from 1.5 m to 3 m: two thirds of 15 m2 are at least 2 m high
        self.assertEqual((attic["storey"], attic["area_above_1.5m_m2"]), ("attic, \u00fcber \u20ac 'x' \\", "15.000"))
        self.assertAlmostEqual(float(attic["area_above_2.0m_m2"]), 10, delta=0.3)
        self.assertAlmostEqual(float(attic["lowest_m"]), 1.5)
        self.assertAlmostEqual(float(attic["highest_m"]), 3)
        self.assertEqual(self.tables["rooms"][1]["name"], 'Cell, "north"')

    def test_openings(self):
        rows = {row["number"]: row for row in self.tables["openings"]}
        self.assertEqual(set(rows), {"D1", "W1", "W2"})
        self.assertEqual((rows["D1"]["leaf"], rows["D1"]["opens_into"], rows["W1"]["to_room"]), ("left", "1", "outside"))
        self.assertEqual((rows["W1"]["sill_m"], rows["W1"]["head_m"]), ("0.900", "2.100"))
        self.assertEqual((rows["D1"]["width_is"], rows["D1"]["width_error_mm"]), ("between rims", "2.2"))
        self.assertEqual((rows["W1"]["width_is"], rows["W1"]["width_error_mm"]), ("", ""))
        told = {v[7]: self.properties[number] for kind in ("IFCDOOR", "IFCWINDOW") for number, v in self.things(kind).items()}
        self.assertEqual(told["D1"]["WidthIs"], "between rims")
        self.assertAlmostEqual(told["D1"]["WidthError"], math.hypot(0.001, 0.002), 9)
        self.assertTrue({"WidthIs", "WidthError"}.isdisjoint(told["W1"]))

    def test_walls(self):
        rows = {row["number"]: row for row in self.tables["walls"]}
        window, inner = rows["1.1"], rows["1.3"]  # with the window of 1 m by 1.2 m; with the door of 0.9 m
        self.assertEqual((window["external"], inner["external"]), ("yes", "no"))
        self.assertAlmostEqual(float(window["gross_area_m2"]), 6 * 3, 3)
        self.assertAlmostEqual(float(window["net_area_m2"]), 6 * 3 - 1.2, 3)
        self.assertAlmostEqual(float(inner["gross_area_m2"]) - float(inner["net_area_m2"]), 0.9 * 2.05, 3)
        self.assertEqual((inner["thickness_m"], inner["thickness_is"], inner["other_face"]), ("0.100", "measured", "2.1"))
        # As deep as the reveal of its window, as is the usual outer wall of its storey; none is known above.
        for number, thickness, claim in (("1.1", "0.320", "at least"), ("3.2", "0.320", "at least"), ("4.3", "0.200", "assumed")):
            self.assertEqual((rows[number]["thickness_m"], rows[number]["thickness_is"]), (thickness, claim), number)
        walls = {v[7]: self.properties[number] for number, v in self.things("IFCWALL").items()}
        for row in self.tables["walls"]:
            told = walls[row["number"]]
            self.assertEqual(told["ThicknessIs"], row["thickness_is"])
            self.assertEqual(told["ThicknessAssumed"] == "T", row["thickness_is"] == "assumed", told)
        self.assertAlmostEqual(float(rows["5.1"]["length_m"]), 6 * math.pi, 3)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
