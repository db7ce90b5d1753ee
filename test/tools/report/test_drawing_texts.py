#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Texts of drawings do not touch each other: every text of an SVG as a turned box, over the truth of
built-in scenes, a house with roofs, and plans of real scans.

    test_drawing_texts.py pcl_floorplan_drawing pcl_simulate_indoor_scan folder of models of real scans
"""

import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "ifc"))
from ifc_samples import house  # noqa: E402

DRAWING, SIMULATOR, MODELS = sys.argv[1:4]
# Many rooms, small ones, round walls, columns, stairs, coffers.
SCENES = ("syn_flat", "hls_hall", "atrium", "gallery", "split_level", "two_storeys", "stairs_and_closet",
          "curved_walls", "diagonal_rooms", "coffered_hall", "long_corridor")
# With all that scenes do not have.
REAL_SCANS = ("synth1", "stepped_room", "ifc_openhouse/scan")


def width_of(text):
    """Over the size of the font: letters of sans-serif fonts, narrow, usual and wide ones."""
    return sum(0.26 if c in " .,:;'iljItf()|-" else 0.84 if c in "mwMW" else 0.57 for c in text)


class Box:
    def __init__(self, text, font, x, y, degrees, is_from_start=False):
        angle = math.radians(degrees)
        self.text, self.font = text, font
        self.way = (math.cos(angle), math.sin(angle))
        # Letters are 0.72 high, and some hang below the line.
        self.half = (width_of(text) * font / 2, 0.4 * font)
        shift = self.half[0] if is_from_start else 0
        self.middle = (x + shift * self.way[0], y + shift * self.way[1])

    def corners(self):
        (x, y), (a, b), (u, v) = self.middle, self.half, self.way
        return [(x + i * a * u - j * b * v, y + i * a * v + j * b * u) for i in (-1, 1) for j in (-1, 1)]

    def is_parted_from(self, other):
        """Whether other lies beyond one of the sides of this box."""
        for axis, half in ((self.way, self.half[0]), ((-self.way[1], self.way[0]), self.half[1])):
            reach = [(x - self.middle[0]) * axis[0] + (y - self.middle[1]) * axis[1] for x, y in other.corners()]
            if min(reach) >= half or max(reach) <= -half:
                return True
        return False

    def meets(self, other):
        return not self.is_parted_from(other) and not other.is_parted_from(self)


def boxes_of(path):
    root = xml.etree.ElementTree.parse(path).getroot()
    size = [float(root.get(k)[:-2]) for k in ("width", "height")]
    return size, [box_of(t) for t in root.iter("{http://www.w3.org/2000/svg}text")]


def box_of(element):
    x, y, font = (float(element.get(k)) for k in ("x", "y", "font-size"))
    turn = re.match(r"rotate\((\S+)", element.get("transform", "rotate(0"))
    return Box(element.text, font, x, y, float(turn.group(1)), element.get("text-anchor") == "start")


def boxes_of_dxf(path):
    """Texts and those of dimensions; None without ezdxf."""
    try:
        import ezdxf
    except ImportError:
        return None
    drawing = ezdxf.readfile(path)
    texts = list(drawing.modelspace().query("TEXT"))
    for dimension in drawing.modelspace().query("DIMENSION"):
        texts += drawing.blocks.get(dimension.dxf.geometry).query("TEXT")
    return [Box(t.dxf.text.replace("%%c", "o"), t.dxf.height / 0.72, t.dxf.align_point[0], t.dxf.align_point[1],
                t.dxf.rotation) for t in texts]


def collisions(boxes):
    return [(a.text, b.text) for i, a in enumerate(boxes) for b in boxes[:i] if a.meets(b)]


def plan_of(truth):
    """The plan that a scene is the truth of: loops, columns, floors and ceilings; ways as files of version 1 have them."""
    def slab(height):
        return {"plane": [0, 0, 1, -height], "inliers": 9, "residual": 0}

    def loop(elements, clockwise=False):
        full = [dict(e, inliers=9, residual=0) for e in elements]
        if not clockwise:
            return full
        return [dict(e, start=e["end"], end=e["start"],
                     **({"counter_clockwise": not e["counter_clockwise"]} if e["type"] == "arc" else {}))
                for e in reversed(full)]

    rooms = [{"id": r["id"], "floor": slab(r["floor"]), "ceiling": slab(r["ceiling"]), "boundary": loop(r["boundary"]),
              "columns": [loop(c, True) for c in r["columns"]], "details": [], "floor_details": [], "niches": []}
             for r in truth["rooms"]]
    doorways = [{"rooms": k["rooms"], "start": k["start"], "end": k["end"], "bottom": k["bottom"], "top": k["top"]}
                for k in truth["links"] if k["kind"] in ("door", "passage")]
    return {"format": "sedr-floorplan", "version": 1, "unit": "m", "rooms": rooms, "doorways": doorways}


class DrawingTexts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_tool(self, *arguments):
        result = subprocess.run(arguments, capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def expect_free_texts(self, plan, scales=("0", "50", "200")):
        """On every sheet of a plan."""
        for scale in scales:
            self.run_tool(DRAWING, plan, self.path("sheet.svg"), "--scale", scale, "--wall-numbers")
            for name in filter(re.compile(r"sheet(_\d+)?\.svg$").match, sorted(os.listdir(self.folder))):
                size, boxes = boxes_of(self.path(name))
                os.remove(self.path(name))
                what = "%s %s 1:%s" % (plan, name, scale)
                self.assertGreater(len(boxes), 15, what)
                self.assertEqual(collisions(boxes), [], what)
                for box in boxes:
                    self.assertGreaterEqual(box.font, 1.7, "%s %s can be read" % (what, box.text))
                    for x, y in box.corners():
                        self.assertTrue(0 < x < size[0] and 0 < y < size[1], "%s %s on paper" % (what, box.text))

        self.run_tool(DRAWING, plan, self.path("sheet.dxf"))
        for name in filter(re.compile(r"sheet(_\d+)?\.dxf$").match, sorted(os.listdir(self.folder))):
            boxes = boxes_of_dxf(self.path(name))
            os.remove(self.path(name))
            if boxes is not None:
                self.assertGreater(len(boxes), 5, plan + " " + name)
                self.assertEqual(collisions(boxes), [], plan + " " + name)

    def expect_free_cuts(self, plan):
        """On a section, elevations and a ceiling plan."""
        for option, *value in (("--section", "rooms"), ("--elevations", "1"), ("--ceiling", "--storey", "1")):
            self.run_tool(DRAWING, plan, self.path("cut.svg"), option, *value)
            size, boxes = boxes_of(self.path("cut.svg"))
            what = "%s %s" % (plan, option)
            self.assertGreater(len(boxes), 10, what)
            self.assertEqual(collisions(boxes), [], what)
            for box in boxes:
                for x, y in box.corners():
                    self.assertTrue(0 < x < size[0] and 0 < y < size[1], "%s %s on paper" % (what, box.text))

    def test_scenes(self):
        for scene in SCENES:
            self.run_tool(SIMULATOR, scene, self.path(scene), "--rays", "200")
            with open(os.path.join(self.path(scene), "truth.json")) as file:
                plan = plan_of(json.load(file))
            with open(self.path(scene + ".json"), "w") as file:
                json.dump(plan, file)
            self.expect_free_texts(self.path(scene + ".json"))
            self.expect_free_cuts(self.path(scene + ".json"))

    def test_a_house_with_roofs(self):
        with open(self.path("house.json"), "w") as file:
            json.dump(house(), file)
        self.expect_free_texts(self.path("house.json"))
        self.expect_free_cuts(self.path("house.json"))

    def test_real_scans(self):
        plans = [os.path.join(MODELS, name, "floorplan.json") for name in REAL_SCANS]
        if not all(map(os.path.exists, plans)):
            self.skipTest("SEDR_DATA names no folder with " + ", ".join(REAL_SCANS))
        for plan in plans:
            self.expect_free_texts(plan)

    def test_the_check_itself(self):
        def box(x, y, text, turn=0):
            return box_of(xml.etree.ElementTree.fromstring(
                '<text x="%g" y="%g" font-size="2" transform="rotate(%g %g %g)">%s</text>'
                % (x, y, turn, x, y, text)))
        self.assertEqual(collisions([box(0, 0, "1.00"), box(3, 0.5, "2.00")]), [("2.00", "1.00")])
        self.assertEqual(collisions([box(0, 0, "1.00"), box(0, 1.7, "2.00")]), [])
        # Beside each other aslant, though the boxes around them meet.
        self.assertEqual(collisions([box(0, 0, "1.00", 45), box(1.3, -1.3, "2.00", 45)]), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
