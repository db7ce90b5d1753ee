#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""report.html, read back as HTML and opened in a browser, of a model known in closed form.

    test_report_page.py pcl_sedr_report pcl_floorplan_extrusion [NAMES OF TESTS...]

The tests in a browser are skipped where there is no Chromium, those of the model that can be turned where three.js
(Debian's libjs-three) is missing.
"""

import atexit
import base64
import functools
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(sys.path[0], "..", ".."))
import chromium
from glb import Glb, volume_of
from plan_samples import rectangle, room, slab

REPORT, EXTRUSION = sys.argv[1:3]
THREE = "/usr/share/javascript/three"
needs_three = unittest.skipUnless(os.path.exists(THREE + "/three.min.js"), "three.js is missing: Debian package libjs-three")
WITHOUT_MODEL = ("--three", "/nowhere")  # opened at once
NASTY = "<script>alert('1')</script>&\"scan\".pcd"


def sample_plan():
    """A room of 4 by 3 m with a square column and a soffit, one of 2 by 3 m beside it; 2.5 m high."""
    first, second = (room(number, rectangle(x0, 0, x1, 3), slab(0), slab(2.5))
                     for number, x0, x1 in ((1, 0, 4), (2, 4.2, 6.2)))
    first["columns"] = [rectangle(2, 1, 2.5, 1.5, clockwise=True)]
    first["details"] = [{"slab": slab(2.2), "boundary": rectangle(0, 0, 1, 3), "holes": []}]
    return {"format": "sedr-floorplan", "version": 1, "unit": "m", "rooms": [first, second]}


def sample_report():
    rooms = [{"id": 1, "area": 11.75, "perimeter": 14.0, "height": 2.4255, "volume": 28.5, "walls": 4, "columns": 1,
              "details": 1, "support": {"measured": 0.38, "inferred": 0.5, "unseen": 0.12}, "solid": {"closed_manifold": True, "wall_area": 34.1, "problem": ""},
              "mesh": {"closed_manifold": False, "problem": "2 edges are open"}},
             {"id": 2, "area": 6.0, "perimeter": 10.0, "height": 2.5, "volume": 15.0, "walls": 4, "columns": 0,
              "details": 0, "support": {"measured": 0.96, "inferred": 0.04, "unseen": 0}, "solid": {"closed_manifold": True, "wall_area": 25.0, "problem": ""},
              "mesh": {"closed_manifold": True, "problem": ""}}]
    distances = {"count": 1000, "mean": 0.004, "rms": 0.006, "median": 0.003, "p95": 0.012, "p99": 0.02, "max": 0.8,
                 "within_1cm": 0.9, "within_5cm": 0.99, "beyond_5cm": 0.01, "histogram_range": 0.1,
                 "histogram": [900, 50, 20, 10, 10], "beyond_histogram": 10}
    return {"format": "sedr-report", "version": 1, "input": {"path": NASTY, "points": 4800, "unit": 1.0},
            "parameters": {"voxel_size": 0.05, "plane_tolerance": 0.07, "tree_depth": 9},
            "stages": [{"stage": "ParallelVoxelGrid", "points_in": 1234567, "points_out": 4800, "seconds": 0.25},
                       {"stage": "StructuralPoisson", "points_in": 4800, "points_out": 9000, "seconds": 1.5}],
            "rooms": rooms, "evaluation": {"mesh": {"triangles": 64}, "cloud_to_mesh": distances},
            "support": {"measured": 0.59, "inferred": 0.33, "unseen": 0.08},
            "noise": [{"rooms": [1, 2], "measured": 0.0052, "correlation": 0.12, "stretches": 9}],
            "verdict": {"verdict": "check", "checks": 2, "shown": 10, "text": "check these 2 places before you hand it over"},
            "remarks": ["the scan is tilted"],
            "doubts": [{"subject": "room 1", "room": 1, "at": [0.75, 2.5], "stake": 2, "kinds": ["stage"], "text": "look at room 1: <b>a part</b>"},
                       {"subject": "wall 2.3", "room": 2, "at": [4.75, 0.5], "stake": 1, "kinds": ["stage"], "text": "look at wall 2.3: second"},
                       {"subject": "", "room": 0, "at": None, "stake": 0, "kinds": ["strays"], "text": "strays were left out"}]}


def write_scan(path):
    """The floors and one wall of the rooms, 5 cm between points."""
    points = [(0.05 * i, 0.05 * j, 0) for i in range(124) for j in range(60)]
    points += [(0.05 * i, 3, 0.05 * j) for i in range(124) for j in range(50)]
    points.append((float("nan"), 0, 0))
    with open(path, "wb") as file:
        file.write(b"VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH %d\nHEIGHT 1\n"
                   b"VIEWPOINT 0 0 0 1 0 0 0\nPOINTS %d\nDATA binary\n" % (len(points), len(points)))
        for point in points:
            file.write(struct.pack("<3f", *point))


class Page:
    """A page as it is written: its text, and its JSON."""

    def __init__(self, text):
        self.text = text
        self.data = json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.S).group(1))
        self.models = {name: base64.b64decode(model["glb"], validate=True) for name, model in self.data["models"].items()}


@functools.lru_cache(maxsize=None)
def sample_folder():
    """A folder with the scan, and with the model's folder and its page, made once."""
    root = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, root)
    model, scan = os.path.join(root, "model"), os.path.join(root, "scan.pcd")
    os.mkdir(model)
    for name, content in (("floorplan.json", sample_plan()), ("report.json", sample_report())):
        with open(os.path.join(model, name), "w") as file:
            json.dump(content, file)
    for name in ("solid.ply", "model.glb"):
        subprocess.run([EXTRUSION, os.path.join(model, "floorplan.json"), os.path.join(model, name)], check=True)
    shutil.copy(os.path.join(model, "solid.ply"), os.path.join(model, "mesh.ply"))
    write_scan(scan)
    subprocess.run([REPORT, model, "--scan", scan], check=True)
    return root


class ReportCase(unittest.TestCase):
    def setUp(self):
        self.root = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.root)
        shutil.copytree(sample_folder(), self.root, dirs_exist_ok=True)
        self.model = os.path.join(self.root, "model")
        self.scan = os.path.join(self.root, "scan.pcd")

    def file(self, name):
        return os.path.join(self.model, name)

    def write(self, name, content):
        with open(self.file(name), "w") as file:
            json.dump(content, file)

    def make(self, *options):
        run = subprocess.run([REPORT, self.model, *options], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""))
        with open(self.file("report.html"), encoding="utf-8") as file:
            return file.read()

    def page(self, *options):
        return Page(self.make("--scan", self.scan, *options))


class ReportPage(ReportCase):
    def test_loads_nothing_from_anywhere(self):
        text = re.sub(r"<script.*?</script>", "", self.page().text, flags=re.S)
        self.assertNotRegex(text, r"https?://|@import|url\(|<iframe|<object|<link rel=.?stylesheet|src=")

    def test_has_both_files_as_they_are_and_a_drawing(self):
        data = self.page().data
        self.assertEqual((data["report"], data["plan"]), (sample_report(), sample_plan()))
        self.assertEqual([d["name"] for d in data["drawings"]], ["storey 1"])
        self.assertIn("<svg", data["drawings"][0]["svg"])
        self.assertLessEqual({"model.glb", "solid.ply", "mesh.ply"}, set(data["files"]))

    def test_text_of_others_ends_no_script(self):
        self.assertNotIn("<script>alert", self.page().text)

    def test_models_are_gltf(self):
        """The folder's model.glb as it is, and the mesh: both closed, with rooms and labels."""
        models = self.page().models
        with open(self.file("model.glb"), "rb") as file:
            self.assertEqual(models["solid"], file.read())
        # 12 m2 less the column, 2.5 m high, less the soffit; and the second room. Faces look out of the rooms.
        volume = 11.75 * 2.5 - 3 * 0.3 + 15
        for name, glb in models.items():
            parts = list(Glb(glb).parts())
            way = 1 if name == "solid" else -1  # the sample's mesh.ply is a solid, whose faces look out already
            self.assertAlmostEqual(way * sum(volume_of(triangles) for *_, triangles in parts), volume, 3, name)
            self.assertEqual({room for room, *_ in parts}, {"room_1", "room_2"})
            self.assertEqual({material for _, _, material, _ in parts}, {"ceiling", "floor", "wall", "detail", "column"})

    def test_points_lie_where_the_scan_does(self):
        """One a voxel, those of the second wall's foot on the box's faces, and as far from the mesh as they are."""
        scan = self.page().data["scan"]
        places = struct.unpack("<%dH" % (3 * scan["count"]), base64.b64decode(scan["places"]))
        points = [[low + (high - low) * n / 65535 for low, high, n in zip(scan["low"], scan["high"], places[i:i + 3])]
                  for i in range(0, len(places), 3)]
        self.assertTrue(all(min(abs(p[2]), abs(p[1] - 3)) < 0.03 for p in points), "on the floor or on the wall")
        self.assertEqual(scan["points"], 124 * 60 + 124 * 50 + 1)
        self.assertTrue(all(p[2] < 2.5 - 0.15 + 1e-3 for p in points[:scan["below"]]))
        steps = base64.b64decode(scan["distances"])
        inside = [step for p, step in zip(points, steps) if 0.1 < p[0] < 3.9 and 1.7 < p[1] < 2.9 and p[2] < 0.02]
        self.assertTrue(inside and max(inside) <= 1, "the floor lies on the mesh")

    def test_a_large_mesh_is_thinned(self):
        n = 100  # the six sides of a box in squares of 3 cm
        vertices, faces = [], []
        for axis in range(3):
            for side in (0, 3):
                first = len(vertices)
                for i in range(n + 1):
                    for j in range(n + 1):
                        p = [0.03 * i, 0.03 * j]
                        p.insert(axis, side)
                        vertices.append(p)
                for i in range(n):
                    for j in range(n):
                        a = first + i * (n + 1) + j
                        faces += [(a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1)]
        with open(self.file("mesh.ply"), "wb") as file:
            file.write(b"ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
                       b"property float z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n"
                       % (len(vertices), len(faces)))
            file.writelines(struct.pack("<3f", *v) for v in vertices)
            file.writelines(struct.pack("<B3i", 3, *f) for f in faces)
        page = self.page("--max-triangles", "20000")
        corners = [c for *_, triangles in Glb(page.models["mesh"]).parts() for t in triangles for c in t]
        self.assertTrue(5000 < len(corners) / 3 <= 20000, len(corners) / 3)
        self.assertEqual(page.data["models"]["mesh"]["triangles"], 12 * n * n)
        self.assertTrue(all(any(abs(c[k]) < 1e-6 or abs(abs(c[k]) - 3) < 1e-6 for k in range(3)) for c in corners))

    def test_parts_that_are_missing_are_left_out(self):
        for name in ("solid.ply", "mesh.ply", "report.json", "model.glb"):
            os.remove(self.file(name))
        data = Page(self.make()).data
        self.assertEqual((data["report"], data["models"], data["scan"]), ({}, {}, None))
        self.assertEqual(len(data["drawings"]), 1)

    def test_a_folder_of_others_is_refused(self):
        for folder in (self.root, os.path.join(self.root, "nowhere"), self.scan):
            run = subprocess.run([REPORT, folder], capture_output=True, text=True)
            self.assertEqual(run.returncode, 1)
            self.assertRegex(run.stderr, r"\A[^\n]{20,}\n\Z")
        self.write("report.json", {"format": "another"})
        self.assertEqual(subprocess.run([REPORT, self.model], capture_output=True).returncode, 1)

    def test_is_the_same_every_time(self):
        self.assertEqual(self.make("--scan", self.scan), self.make("--scan", self.scan))


class BrowserCase(ReportCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = chromium.Browser()  # for all tests, as it takes a second to start
        cls.addClassCleanup(cls.browser.close)

    opened = None  # the page as it was written, and its size, while nobody has touched it

    def open(self, width=1000, height=1200, model=True):
        browser = self.browser
        with open(self.file("report.html"), "rb") as file:
            page = file.read(), width, height
        if page == type(self).opened:
            return browser
        type(self).opened = None
        browser.resize(width, height)
        browser.messages.clear()
        browser.requests.clear()
        browser.open(self.file("report.html"))
        if model:
            self.wait(browser)
        self.assertEqual(browser.messages, [], "nothing on the console")
        self.assertTrue(all(r.startswith(("file://", "data:")) for r in browser.requests), browser.requests)
        type(self).opened = page
        return browser

    def wait(self, browser):
        """Until the model is read."""
        for _ in range(100):
            if browser.run("!document.getElementById('view-controls').hidden"
                                            " || !document.getElementById('view-problem').hidden"):
                return
            time.sleep(0.1)
        self.fail("the model does not appear")

    def row(self, browser, section, first):
        """The texts of a table's row by its heads."""
        return browser.run(f"""(() => {{
          const texts = row => [...row.children].map(cell => cell.textContent);
          const rows = [...document.querySelectorAll('#{section} tr')].map(texts);
          const row = rows.find(r => r[0] === '{first}');
          return row && Object.fromEntries(rows[0].map((head, k) => [head, row[k]]));
        }})()""")

    def expect_row(self, browser, section, first, cells):
        row = self.row(browser, section, first)
        self.assertEqual({head: row[head] for head in cells}, cells)

    def shown(self, options=WITHOUT_MODEL, plan=None, **changes):
        """The page of the sample with changes of its report, and with another plan."""
        self.write("report.json", {**sample_report(), **changes})
        self.write("floorplan.json", plan or sample_plan())
        self.make(*options)
        return self.open()

    def words(self, browser, selector="body"):
        return " ".join(browser.run(f"document.querySelector('{selector}').innerText").split())


@unittest.skipUnless(chromium.program(), "there is no Chromium")
class ReportInABrowser(BrowserCase):
    """The sample."""

    def canvas(self, browser):
        """What the model's canvas shows: a list of RGB."""
        data = base64.b64decode(browser.run("""(() => {
          const view = document.querySelector('#view canvas'), copy = document.createElement('canvas');
          Object.assign(copy, { width: view.width, height: view.height });
          const pen = copy.getContext('2d');
          pen.drawImage(view, 0, 0);
          const data = pen.getImageData(0, 0, copy.width, copy.height).data;
          let text = '';
          for (let i = 0; i < data.length; i += 4) text += String.fromCharCode(data[i], data[i + 1], data[i + 2]);
          return btoa(text);
        })()"""))
        return [data[i:i + 3] for i in range(0, len(data), 3)]

    def test_rooms_and_stages_are_told_with_units(self):
        browser = self.open()
        self.expect_row(browser, "rooms", "1", {
            "area, m²": "11.75", "perimeter, m": "14.00", "volume, m³": "28.50", "wall surface, m²": "34.10",
            "walls measured": "38\u00a0%", "mesh": "open", "solid": "closed"})
        self.assertEqual(self.row(browser, "rooms", "2")["walls measured"], "96\u00a0%")
        self.expect_row(browser, "stages", "ParallelVoxelGrid",
                        {"points in": "1\u202f234\u202f567", "points out": "4\u202f800", "seconds": "0.25"})
        self.assertEqual(self.row(browser, "stages", "together")["seconds"], "1.75")
        self.assertEqual(self.row(browser, "parameters", "plane_tolerance")["value"], "0.07")
        self.assertEqual(self.row(browser, "files", "model.glb")["what it is"], "sharp model for the web, glTF 2.0")
        self.assertIn("17.8 m²", self.words(browser, "#figures"), "floor area of all")

    def test_text_of_others_is_shown_as_text(self):
        words = self.words(self.open())
        self.assertIn(NASTY, words)
        self.assertIn("<b>a part</b>", words)

    def test_what_is_doubted_is_told_as_the_report_has_it(self):
        words = self.words(self.open(), "#check")
        self.assertRegex(words, "(?s)hand it over.*The scan is tilted\\..*look at room 1", "what is of the whole comes before places")
        self.assertIn("Check these 2 places before you hand it over.", words)
        self.assertIn("look at room 1: <b>a part</b>", words)
        self.assertIn("2.00 m² at stake", words)
        self.assertIn("strays were left out", words)

    def test_the_share_of_walls_that_was_measured_and_their_noise_head_the_page(self):
        figures = self.open().run("document.getElementById('figures').textContent")
        self.assertIn("59\u00a0%", figures)
        self.assertIn("noise of walls, correlated over 12\u00a0cm0.52\u00a0cm", figures)

    def test_warnings_have_numbers_on_the_plan_that_lies_over_the_scan(self):
        browser = self.open()
        marks = browser.run("[...document.querySelectorAll('#plan .mark')].map(mark => {"
                            " const sheet = mark.parentElement.getBoundingClientRect(), box = mark.getBoundingClientRect();"
                            " return [mark.textContent, mark.title, box.x + box.width / 2 - sheet.x, box.y + box.height / 2 - sheet.y]; })")
        self.assertEqual([mark[:2] for mark in marks], [["1", "look at room 1: <b>a part</b>"], ["2", "look at wall 2.3: second"]])
        # From (0.75, 2.5) to (4.75, 0.5), where no text is: twice as far to the right as down.
        self.assertAlmostEqual((marks[1][2] - marks[0][2]) / (marks[1][3] - marks[0][3]), 2, delta=0.005)
        # The wall that was scanned, y = 3, is on the slice, half a metre above the first place.
        dots = browser.run("""(() => { const canvas = document.querySelector('#plan canvas'), pen = canvas.getContext('2d');
          const box = canvas.getBoundingClientRect(), [dx, dy] = [%s, %s];
          const seen = (x, y) => pen.getImageData(x * canvas.width / box.width - 8, y * canvas.height / box.height - 8, 16, 16).data
            .some(value => value > 0);
          return [seen(dx, dy), seen(dx, dy + %s)]; })()""" % (marks[0][2], marks[0][3], (marks[0][3] - marks[1][3]) / 4))
        self.assertEqual(dots, [False, True])

    def test_histogram_has_a_bar_a_bin_and_one_beyond(self):
        bars = self.open().run("[...document.querySelectorAll('.chart div')].map(bar => "
                               "[bar.querySelector('b').getBoundingClientRect().height, bar.title])")
        self.assertEqual([title.rsplit(": ", 1)[1] for _, title in bars],
                         ["90.00 %", "5.00 %", "2.00 %", "1.00 %", "1.00 %", "1.00 %"])
        self.assertAlmostEqual(bars[0][0] / bars[1][0], 18, delta=0.1)

    def test_pictures_show_scan_model_and_distances(self):
        browser = self.open()
        for picture in ("scan", "model", "distance"):
            share = browser.run(f"""(() => {{
              const canvas = document.querySelector('#{picture}-picture canvas');
              const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
              let drawn = 0;
              for (let i = 3; i < data.length; i += 4) drawn += data[i] > 0;
              return 4 * drawn / data.length;
            }})()""")
            self.assertGreater(share, 0.2, picture)
        self.assertTrue(browser.run("[...document.querySelectorAll('.plans img')].every(i => i.naturalWidth > 100)"))

    def share(self, pixels, test):
        return sum(map(test, pixels[::7])) / len(pixels[::7])

    def difference(self, a, b):
        """Share of pixels that differ: lines that lie on faces flicker by a few."""
        return sum(p != q for p, q in zip(a, b)) / len(a)

    def choose(self, browser, selector, script):
        type(self).opened = None
        browser.run(f"(() => {{ const e = document.querySelector('{selector}'); {script}; "
                    "e.dispatchEvent(new Event('input')); e.dispatchEvent(new Event('change')); })()")

    @needs_three
    def test_the_model_is_seen_and_opened_and_cut(self):
        browser = self.open()
        is_blue = lambda p: p[2] > p[0] + 60
        is_green = lambda p: p[1] > p[0] + 40 and p[1] > p[2] + 30
        is_orange = lambda p: p[0] > p[2] + 80 and p[1] > p[2] + 30
        is_red = lambda p: p[0] > p[1] + 80 and p[0] > p[2] + 80 and not is_orange(p)
        first = self.canvas(browser)
        self.assertGreater(self.share(first, is_blue), 0.02, "floors are seen without the ceilings")
        self.assertGreater(self.share(first, is_green), 0.02)
        self.assertEqual(self.share(first, is_orange), 0)
        self.choose(browser, "#ceiling", "e.checked = true")
        closed = self.canvas(browser)
        self.assertGreater(self.share(closed, is_orange), 0.03)
        self.assertGreater(self.share(closed, is_red), 0.005, "the soffit")
        self.assertLess(self.share(closed, is_blue), 0.002)
        self.choose(browser, "#clip", "e.value = 1")
        self.assertEqual(browser.run("document.getElementById('clip-text').textContent"), "1.00 m")
        cut = self.canvas(browser)
        self.assertEqual(self.share(cut, is_orange), 0)
        self.assertLess(self.share(cut, is_green), 0.7 * self.share(first, is_green))
        self.choose(browser, "#clip", "e.value = e.max")
        self.assertLess(self.difference(self.canvas(browser), closed), 0.01)
        self.choose(browser, "#ceiling", "e.checked = false")
        self.assertLess(self.difference(self.canvas(browser), first), 0.01)
        self.choose(browser, "input[name=model][value=mesh]", "e.checked = true")
        self.assertGreater(self.difference(self.canvas(browser), first), 0.002, "the mesh has no edges")
        self.choose(browser, "input[name=colour][value=room]", "e.checked = true")
        self.assertEqual(self.share(self.canvas(browser), is_green), 0)
        browser.run("document.getElementById('from-above').click()")
        self.assertLess(self.share(self.canvas(browser), lambda p: p == b"\xff\xff\xff"), 0.98)
        self.choose(browser, "input[name=model][value=distances]", "e.checked = true")
        self.assertGreater(self.share(self.canvas(browser), is_blue), 0.02, "the floor lies on the mesh")
        self.assertEqual(browser.messages, [])

    @needs_three
    def test_a_drag_turns_the_model(self):
        browser = self.open()
        type(self).opened = None
        before = self.canvas(browser)
        browser.run("document.getElementById('view').scrollIntoView({block: 'center'})")
        box = browser.run("(() => { const b = document.querySelector('#view canvas').getBoundingClientRect();"
                          "return [b.left + b.width / 2, b.top + b.height / 2]; })()")
        for kind, shift in (("mousePressed", 0), ("mouseMoved", 60), ("mouseMoved", 120), ("mouseReleased", 120)):
            browser.ask("Input.dispatchMouseEvent", type=kind, x=box[0] + shift, y=box[1], button="left", buttons=1,
                        clickCount=1)
        self.assertGreater(self.difference(self.canvas(browser), before), 0.05)

    def test_fits_a_phone_and_any_window(self):
        for width in (390, 700, 840, 1100):
            browser = self.open(width, 844)
            self.assertLessEqual(browser.run("document.documentElement.scrollWidth"), width)
            self.assertEqual(browser.run("[...document.querySelectorAll('.wide')]"
                                         ".filter(e => e.scrollWidth > e.clientWidth).length"), 0, "no table is cut off")

    def test_fits_a_sheet_of_paper(self):
        browser = self.open(700, 1000)
        browser.ask("Emulation.setEmulatedMedia", media="print")
        self.addCleanup(browser.ask, "Emulation.setEmulatedMedia", media="")
        widest = browser.run("Math.max(...[...document.querySelectorAll('body *')].filter(e => !e.closest('svg'))"
                             ".map(e => e.getBoundingClientRect().right))")
        self.assertLessEqual(widest, 700)


@unittest.skipUnless(chromium.program(), "there is no Chromium")
class OtherReportsInABrowser(BrowserCase):
    def test_storeys_and_what_was_left_out(self):
        """The sample, and the same rooms 2.8 m higher as rooms 3 and 4."""
        plan, rooms = sample_plan(), sample_report()["rooms"]
        for low in sample_plan()["rooms"]:
            plan["rooms"].append({**low, "id": low["id"] + 2, "floor": slab(2.8), "ceiling": slab(5.3), "details": []})
        plan["storeys"] = [{"number": 1, "name": "ground floor", "rooms": [1, 2]}, {"number": 2, "name": "<attic>", "rooms": [3, 4]}]
        plan["openings"] = [{"kind": "door", "number": 7, "rooms": [1, 2], "walls": [], "start": [4.1, 1], "end": [4.1, 1.9], "bottom": 0, "top": 2,
                             "hinge": "unknown", "state": "unknown"}]
        coverage = {"seen": 60.5, "modelled": 12.1, "share": 0.2, "left_out": [
            {"reason": "room 3: <no> plan", "area": 48.4, "floor": -0.5, "ceiling": 2.5, "at": [10, -2.25], "counts": True}]}
        browser = self.shown(plan=plan, coverage=coverage, rooms=rooms + [{**room, "id": room["id"] + 2} for room in rooms])
        self.expect_row(browser, "storeys", "<attic>", {"area, m²": "17.75", "height, m": "2.43 to 2.50"})
        self.assertEqual(browser.run("document.querySelectorAll('.plans img').length"), 2)
        self.assertEqual(browser.run("[...document.querySelectorAll('#rooms h3')].map(h => h.textContent)"),
                         ["ground floor", "<attic>"])
        self.expect_row(browser, "openings", "D7", {"between": "room 1 and room 2", "width, m": "0.90", "height, m": "2.00"})
        self.expect_row(browser, "coverage", "room 3: <no> plan", {"area, m²": "48.4", "z, m": "-0.5 to 2.5", "counts": "yes"})
        self.assertIn("12.1 m² of 60.5 m² of floor that was seen are in the plan, 20 %", self.words(browser, "#coverage"))

    def test_openings_tell_their_walls_and_their_place(self):
        door = {"kind": "door", "number": 7, "rooms": [1, 2], "walls": [{"room": 1, "element": 1}, {"room": 2, "element": 3}],
                "start": [4.1, 1], "end": [4.1, 2], "bottom": 0, "top": 2, "depth": 0.2, "hinge": "unknown", "state": "closed",
                "confidence": 0.9, "residual": 0.01}
        without_edges = {**door, "number": 8, "start": [4.1, 2.2], "end": [4.1, 2.9]}
        plan = {**sample_plan(), "openings": [door, without_edges]}
        told = [{"number": "D8", "width_is": "", "width_error": 0.0}, {"number": "D7", "width_is": "between rims", "width_error": 0.0213}]
        certainty = {"openings": {"columns": ["element", "area", "within_1cm", "within_3cm", "within_5cm"], "rows": [["D7", 2, 0.1, 0.4, 0.55]]}}
        browser = self.shown(plan=plan, openings=told, certainty=certainty)
        self.expect_row(browser, "openings", "D7", {"sure": "55\u00a0%"})  # as doubts tell it, not the probability of its kind
        self.expect_row(browser, "openings", "D7", {"walls": "1.2, 2.4", "at x, y, m": "4.1, 1.5", "width is": "between rims",
                                                    "its standard error, cm": "2.1"})
        self.expect_row(browser, "openings", "D8", {"width is": "", "its standard error, cm": ""})
        # As it was written before:
        self.expect_row(self.shown(plan=plan), "openings", "D7", {"width is": "", "its standard error, cm": ""})

    def test_what_somebody_confirmed_is_told_and_ticked_on_the_plan(self):
        plan = sample_plan()
        plan["rooms"][0]["boundary"][1]["confirmed"] = True
        plan["openings"] = [{"kind": "door", "number": 7, "rooms": [1, 2], "walls": [], "start": [4.1, 1], "end": [4.1, 2], "bottom": 0, "top": 2,
                             "depth": 0.2, "hinge": "unknown", "state": "closed", "confidence": 0.9, "residual": 0.01, "confirmed": True}]
        browser = self.shown(plan=plan)
        self.assertIn("Somebody looked and confirmed: wall 1.2, door D7.", self.words(browser, "#check"))
        self.expect_row(browser, "openings", "D7", {"sure": "confirmed"})
        self.assertEqual(browser.run("[...document.querySelectorAll('#plan .mark.fine')].map(mark => mark.title)"),
                         ["wall 1.2 is confirmed", "door D7 is confirmed"])
        self.assertNotIn("confirmed", self.words(self.shown(), "#check"))

    def test_schedules_have_units(self):
        rooms = {"columns": ["room", "area_m2", "area_above_2.0m_m2", "walls_measured_percent"], "rows": [["1", "11.750", "9.000", "38"]]}
        browser = self.shown(schedules={"rooms": rooms, "walls": {"columns": ["number"], "rows": []}})
        self.expect_row(browser, "schedules", "1", {"area, m²": "11.750", "area above 2.0m, m²": "9.000", "walls measured, %": "38"})
        self.assertNotIn("walls: ", self.words(browser, "#schedules"))

    def test_the_accuracy_of_nine_tenths_of_what_was_measured_is_stated(self):
        walls = {"measured": {"LOA50": 4, "LOA40": 5, "LOA20": 1, "not measured": 2}, "represented": {"LOA30": 8, "LOA10": 2, "not measured": 2}}
        browser = self.shown(accuracy={"walls": walls})
        self.assertIn("75 % of the walls are measured to LOA40 or better. 83 % of the walls are represented to LOA10 or better.",
                      self.words(browser, "#accuracy"))
        self.assertIn("of the walls measured to LOA40 or better 75 %", self.words(browser, "#figures"))
        self.expect_row(browser, "accuracy", "walls", {"LOA50": "4", "LOA40": "5", "LOA30": "", "LOA20": "1", "not measured": "2"})

    def test_walls_show_what_was_seen_of_them(self):
        wall = {"room": 1, "walls": [2, 3], "length": 4, "base": 0, "cell": 1, "columns": 4, "rows": 2, "cells": "4s2h1e1w",
                "openings": [{"kind": "door", "from": 2, "to": 3, "bottom": 0, "top": 1}]}
        browser = self.shown(walls=[wall])
        self.assertIn("room 1: 2 of 4 walls, 1 opening", self.words(browser, "#walls"))
        browser.run("new Promise(done => { const box = document.querySelector('#walls details');"
                    " box.addEventListener('toggle', () => setTimeout(done, 0)); box.open = true; })")
        self.assertIn("wall 1.2, 1.3: 4.0 m, door", self.words(browser, "#walls"))
        # Pixels of cells from the top left: three a cell.
        pixel = "[...document.querySelector('#walls canvas').getContext('2d').getImageData({}, {}, 1, 1).data]"
        self.assertEqual(browser.run(pixel.format(1, 1)), [155, 155, 155, 255], "seen")
        self.assertEqual(browser.run(pixel.format(1, 4)), [150, 184, 225, 255], "hidden")

    def test_a_malformed_section_leaves_the_others(self):
        with self.assertRaisesRegex(AssertionError, "console"):
            self.shown((), coverage=7)
        self.assertIn("11.75", self.words(self.browser, "#rooms"))

    def test_numbers_of_warnings_lie_beside_texts_and_each_other(self):
        doubts = [{"text": "thin", "room": 1, "at": [1 + k % 5 * 0.4, 1 + k // 5 * 0.4]} for k in range(20)]
        meeting = self.shown(doubts=doubts).run("""(() => {
          const image = document.querySelector('.plans img'), sheet = image.getBoundingClientRect(), holder = document.createElement('div');
          holder.innerHTML = decodeURIComponent(image.src.split(',').slice(1).join(','));
          Object.assign(holder.style, { position: 'absolute', left: sheet.x + scrollX + 'px', top: sheet.y + scrollY + 'px' });
          document.body.append(holder);
          Object.assign(holder.firstElementChild.style, { width: sheet.width + 'px', height: sheet.height + 'px' });
          const middle = box => [box.x + box.width / 2, box.y + box.height / 2];
          const marks = [...document.querySelectorAll('#plan .mark')].map(mark => middle(mark.getBoundingClientRect()));
          const texts = [...holder.querySelectorAll('text')].map(text => text.getBoundingClientRect());
          const inside = ([x, y]) => texts.some(box => x > box.left && x < box.right && y > box.top && y < box.bottom);
          const near = (a, b) => a !== b && Math.hypot(a[0] - b[0], a[1] - b[1]) < 8;
          return [marks.length, texts.length > 5, marks.filter(inside).length, marks.filter(a => marks.some(b => near(a, b))).length]; })()""")
        self.assertEqual(meeting, [10, True, 0, 0], "ten are shown, the rest is folded")

    def test_nothing_amiss_is_told_too(self):
        self.assertIn("Nothing is doubted", self.words(self.shown(doubts=[]), "#check"))

    def test_a_room_without_a_mesh_counts_as_neither_closed_nor_open(self):
        first, *rest = sample_report()["rooms"]
        browser = self.shown(rooms=[{**first, "mesh": None}, *rest])
        self.assertIn("closed meshes1 of 1", browser.run("document.getElementById('figures').textContent"))

    def test_figures_of_another_plan_are_left_out_and_the_page_says_so(self):
        first, *rest = sample_report()["rooms"]
        browser = self.shown(rooms=[{**first, "area": 12.75}, *rest])
        self.assertIn("is not the plan that report.json tells of", self.words(browser, "#check"))
        self.assertNotIn("12.75", self.words(browser, "#rooms"))

    def test_without_report_scan_and_models_the_plan_is_shown(self):
        for name in ("solid.ply", "mesh.ply", "report.json", "model.glb"):
            os.remove(self.file(name))
        self.make()
        browser = self.open(model=False)
        self.assertEqual(self.row(browser, "rooms", "1")["columns"], "1")
        ids = browser.run("[...document.querySelectorAll('section')].map(s => s.id)")
        self.assertEqual(ids, ["check", "plan", "rooms", "files"])

    def test_without_the_scan_the_page_says_so(self):
        self.make()
        self.assertIn("The scan was not found", self.words(self.open(), "#pictures"))

    def test_without_three_the_page_says_so_and_has_pictures(self):
        self.make("--scan", self.scan, *WITHOUT_MODEL)
        browser = self.open()
        self.assertIn("three.js was not found", self.words(browser, "#model"))
        self.assertGreater(browser.run("document.querySelector('#model-picture canvas').height"), 200)

    @needs_three
    def test_without_webgl_a_sentence_stands_there(self):
        browser = chromium.Browser(1000, 800, "--disable-3d-apis")
        self.addCleanup(browser.close)
        browser.open(self.file("report.html"))
        self.wait(browser)
        self.assertIn("no WebGL", browser.run("document.getElementById('view-problem').textContent"))
        self.assertTrue(browser.run("document.getElementById('view').hidden"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[3:]])
