#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Texts of drawings do not touch each other: every text of an SVG as a turned box, over the truth of
built-in scenes, a house with roofs, and plans of real scans.

    test_drawing_texts.py pcl_floorplan_drawing pcl_simulate_indoor_scan folder of models of real scans
"""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

from shapely.affinity import rotate
from shapely.geometry import box

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "ifc"))
from ifc_samples import house  # noqa: E402

try:
    import ezdxf
except ImportError:
    ezdxf = None

DRAWING, SIMULATOR, MODELS = sys.argv[1:4]
# Many rooms, small ones, round walls, columns, stairs, coffers.
SCENES = ("syn_flat", "hls_hall", "atrium", "gallery", "split_level", "two_storeys", "stairs_and_closet",
          "curved_walls", "diagonal_rooms", "coffered_hall", "long_corridor")
# With all that scenes do not have.
REAL_SCANS = ("synth1", "stepped_room", "ifc_openhouse/scan")


def width_of(text):
    """Over the size of the font: letters of sans-serif fonts, narrow, usual and wide ones."""
    return sum(0.26 if c in " .,:;'iljItf()|-" else 0.84 if c in "mwMW" else 0.57 for c in text)


class Text:
    """A text and the box that it fills: letters are 0.72 high, and some hang below the line."""

    def __init__(self, text, font, x, y, degrees, is_from_start=False):
        self.text, self.font = text, font
        width = width_of(text) * font
        low = x if is_from_start else x - width / 2
        self.box = rotate(box(low, y - 0.4 * font, low + width, y + 0.4 * font), degrees, (x, y))


def texts_of(path):
    root = xml.etree.ElementTree.parse(path).getroot()
    size = [float(root.get(k)[:-2]) for k in ("width", "height")]
    return box(0, 0, *size), [text_of(t) for t in root.iter("{http://www.w3.org/2000/svg}text")]


def text_of(element):
    x, y, font = (float(element.get(k)) for k in ("x", "y", "font-size"))
    turn = re.match(r"rotate\((\S+)", element.get("transform", "rotate(0"))
    return Text(element.text, font, x, y, float(turn.group(1)), element.get("text-anchor") == "start")


def texts_of_dxf(path):
    """Texts and those of dimensions, on no paper."""
    drawing = ezdxf.readfile(path)
    texts = list(drawing.modelspace().query("TEXT"))
    for dimension in drawing.modelspace().query("DIMENSION"):
        texts += drawing.blocks.get(dimension.dxf.geometry).query("TEXT")
    return None, [Text(t.dxf.text.replace("%%c", "o"), t.dxf.height / 0.72, t.dxf.align_point[0], t.dxf.align_point[1],
                 t.dxf.rotation) for t in texts]


def collisions(texts):
    return [(a.text, b.text) for i, a in enumerate(texts) for b in texts[:i]
            if a.box.intersects(b.box) and not a.box.touches(b.box)]


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

    def expect_free(self, plan, ending, least, *options):
        """On every sheet of a plan."""
        self.run_tool(DRAWING, plan, self.path("sheet" + ending), *options)
        for name in filter(re.compile(r"sheet(_\d+)?\%s$" % ending).match, sorted(os.listdir(self.folder))):
            what = "%s %s %s" % (plan, name, options)
            paper, texts = (texts_of if ending == ".svg" else texts_of_dxf)(self.path(name))
            os.remove(self.path(name))
            self.assertGreater(len(texts), least, what)
            self.assertEqual(collisions(texts), [], what)
            for text in texts if paper else ():
                self.assertGreaterEqual(text.font, 1.7, "%s %s can be read" % (what, text.text))
                self.assertTrue(paper.contains(text.box), "%s %s on paper" % (what, text.text))

    def expect_free_texts(self, plan):
        for scale in ("0", "50", "200"):
            self.expect_free(plan, ".svg", 15, "--scale", scale, "--wall-numbers")
        if ezdxf:
            self.expect_free(plan, ".dxf", 5)

    def expect_free_cuts(self, plan):
        """On a section, elevations and a ceiling plan."""
        for options in (("--section", "rooms"), ("--elevations", "1"), ("--ceiling", "--storey", "1")):
            self.expect_free(plan, ".svg", 10, *options)

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
        def text(x, y, words, turn=0):
            return text_of(xml.etree.ElementTree.fromstring(
                '<text x="%g" y="%g" font-size="2" transform="rotate(%g %g %g)">%s</text>' % (x, y, turn, x, y, words)))
        self.assertEqual(collisions([text(0, 0, "1.00"), text(3, 0.5, "2.00")]), [("2.00", "1.00")])
        self.assertEqual(collisions([text(0, 0, "1.00"), text(0, 1.7, "2.00")]), [])
        # Beside each other aslant, though the boxes around them meet.
        self.assertEqual(collisions([text(0, 0, "1.00", 45), text(1.3, -1.3, "2.00", 45)]), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
