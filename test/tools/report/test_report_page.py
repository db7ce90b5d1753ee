#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""report.html, read back as HTML and opened in a browser, of a model known in closed form.

    test_report_page.py pcl_sedr_report pcl_floorplan_extrusion [NAMES OF TESTS...]

The tests in a browser are skipped where there is no Chromium, those of the model that can be turned where three.js
(Debian's libjs-three) is missing.
"""

import base64
import html.parser
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
import zlib

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(sys.path[0], "..", ".."))
import chromium
from plan_samples import rectangle, room, slab

REPORT, EXTRUSION = sys.argv[1:3]
THREE = "/usr/share/javascript/three"
HAS_THREE = os.path.exists(THREE + "/three.min.js")
NASTY = "<script>alert('1')</script>&\"scan\".pcd"
VOID = {"area", "br", "col", "hr", "img", "input", "link", "meta", "source"}


def sample_plan():
    """A room of 4 by 3 m with a square column and a soffit, one of 2 by 3 m beside it; 2.5 m high."""
    first, second = (room(number, rectangle(x0, 0, x1, 3), slab(0), slab(2.5))
                     for number, x0, x1 in ((1, 0, 4), (2, 4.2, 6.2)))
    first["columns"] = [rectangle(2, 1, 2.5, 1.5, clockwise=True)]
    first["details"] = [{"slab": slab(2.2), "boundary": rectangle(0, 0, 1, 3), "holes": []}]
    return {"format": "sedr-floorplan", "version": 1, "unit": "m", "rooms": [first, second]}


def sample_report():
    rooms = [{"id": 1, "area": 11.75, "perimeter": 14.0, "height": 2.4255, "volume": 28.5, "walls": 4, "columns": 1,
              "details": 1, "repaired_share": 0.625, "solid": {"closed_manifold": True, "wall_area": 34.1, "problem": ""},
              "mesh": {"closed_manifold": False, "problem": "2 edges are open"}},
             {"id": 2, "area": 6.0, "perimeter": 10.0, "height": 2.5, "volume": 15.0, "walls": 4, "columns": 0,
              "details": 0, "repaired_share": 0.04, "solid": {"closed_manifold": True, "wall_area": 25.0, "problem": ""},
              "mesh": {"closed_manifold": True, "problem": ""}}]
    distances = {"count": 1000, "mean": 0.004, "rms": 0.006, "median": 0.003, "p95": 0.012, "p99": 0.02, "max": 0.8,
                 "within_1cm": 0.9, "within_5cm": 0.99, "beyond_5cm": 0.01, "histogram_range": 0.1,
                 "histogram": [900, 50, 20, 10, 10], "beyond_histogram": 10}
    return {"format": "sedr-report", "version": 1, "input": {"path": NASTY, "points": 4800, "unit": 1.0},
            "parameters": {"voxel_size": 0.05, "plane_tolerance": 0.07, "tree_depth": 9},
            "stages": [{"stage": "ParallelVoxelGrid", "points_in": 1234567, "points_out": 4800, "seconds": 0.25},
                       {"stage": "StructuralPoisson", "points_in": 4800, "points_out": 9000, "seconds": 1.5}],
            "rooms": rooms, "evaluation": {"mesh": {"triangles": 64}, "cloud_to_mesh": distances},
            "warnings": ["room 1: <b>a part</b> of its ceiling is left out"]}


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


class Page(html.parser.HTMLParser):
    """What is in a page; `faults` are tags that do not match."""

    def __init__(self, text):
        super().__init__()
        self.text, self.open, self.faults, self.ids = text, [], [], []
        self.images, self.links, self.words, self.scripts, self.rows, self.alternatives = [], [], "", [], [], 0
        self.feed(text)
        self.close()
        self.faults += self.open

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if tag not in VOID:
            self.open.append(tag)
        if "id" in values:
            self.ids.append(values["id"])
        self.links += [values[name] for name in ("src", "href", "xlink:href", "action", "data") if name in values]
        if tag == "img":
            self.images.append(values["src"])
            self.alternatives += bool(values.get("alt"))
        if tag == "script":
            self.scripts.append("")
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_startendtag(self, tag, attributes):  # <path/> within SVG
        self.handle_starttag(tag, attributes)
        self.handle_endtag(tag)

    def handle_endtag(self, tag):
        if tag in VOID:
            return
        if not self.open or self.open.pop() != tag:
            self.faults.append("/" + tag)

    def handle_data(self, data):
        inside = self.open[-1] if self.open else ""
        if inside == "script":
            self.scripts[-1] += data
        elif inside != "style":
            self.words += data
            if "td" in self.open or "th" in self.open:
                self.rows[-1][-1] += data

    def row(self, first):
        return next(row for row in self.rows if row and row[0] == first)


def glb_of(page):
    """The models of a page by their name."""
    found = re.findall(r'<script type="model/gltf-binary" class="model" data-name="(\w+)">([^<]*)</script>', page.text)
    return {name: base64.b64decode(text, validate=True) for name, text in found}


def parts_of(glb):
    """Elements of a binary glTF: name of the room above, material, triangles."""
    size, = struct.unpack_from("<I", glb, 12)
    gltf, binary = json.loads(glb[20:20 + size]), glb[28 + size:]

    def numbers(accessor, kind, width):
        a = gltf["accessors"][accessor]
        start = gltf["bufferViews"][a["bufferView"]]["byteOffset"]
        return struct.unpack_from("<%d%s" % (width * a["count"], kind), binary, start)

    parts = []
    for node in gltf["nodes"]:
        for child in (gltf["nodes"][c] for c in node.get("children", [])):
            if "mesh" in child:
                primitive, = gltf["meshes"][child["mesh"]]["primitives"]
                places = list(zip(*[iter(numbers(primitive["attributes"]["POSITION"], "f", 3))] * 3))
                corners = [places[i] for i in numbers(primitive["indices"], "I", 1)]
                parts.append({"room": node["name"], "label": gltf["materials"][primitive["material"]]["name"] if "material" in primitive else "",
                              "triangles": list(zip(*[iter(corners)] * 3))})
    return parts


def volume_of(triangles):
    return sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
               + a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in triangles) / 6


def png_size(data):
    """Width and height of a PNG, all of whose chunks and pixels are read."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, pixels, size = 8, b"", None
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        assert zlib.crc32(kind + body) == struct.unpack(">I", data[place + 8 + length:place + 12 + length])[0]
        if kind == b"IHDR":
            size = struct.unpack(">2I", body[:8])
        if kind == b"IDAT":
            pixels += body
        place += 12 + length
    assert len(zlib.decompress(pixels)) == size[1] * (1 + 3 * size[0])
    return size


def pixels_of(png):
    """Rows of RGB bytes of a PNG as Chromium writes them: 8 bits, RGB or RGBA, no interlace."""
    width, height = struct.unpack(">2I", png[16:24])
    channels = {2: 3, 6: 4}[png[25]]
    place, packed = 8, b""
    while place < len(png):
        length, kind = struct.unpack(">I4s", png[place:place + 8])
        packed += png[place + 8:place + 8 + length] if kind == b"IDAT" else b""
        place += 12 + length
    raw, stride, above, rows = zlib.decompress(packed), width * channels, bytes(width * channels), []
    for y in range(height):
        start = y * (stride + 1)
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for i in range(stride):
            left = row[i - channels] if i >= channels else 0
            up, corner = above[i], above[i - channels] if i >= channels else 0
            if kind == 1:
                row[i] = row[i] + left & 255
            elif kind == 2:
                row[i] = row[i] + up & 255
            elif kind == 3:
                row[i] = row[i] + (left + up) // 2 & 255
            elif kind == 4:
                guess = left + up - corner
                nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))
                row[i] = row[i] + nearest[2] & 255
        above = bytes(row)
        rows.append([above[i:i + 3] for i in range(0, stride, channels)])
    return rows


class ReportCase(unittest.TestCase):
    def setUp(self):
        self.root = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.root)
        self.model = os.path.join(self.root, "model")
        os.mkdir(self.model)
        self.write("floorplan.json", sample_plan())
        self.write("report.json", sample_report())
        for name in ("solid.ply", "model.glb"):
            subprocess.run([EXTRUSION, self.file("floorplan.json"), self.file(name)], check=True)
        shutil.copy(self.file("solid.ply"), self.file("mesh.ply"))
        self.scan = os.path.join(self.root, "scan.pcd")
        write_scan(self.scan)

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
        page = Page(self.make("--scan", self.scan, *options))
        self.assertEqual(page.faults, [])
        self.assertEqual(len(page.ids), len(set(page.ids)), "ids are unique")
        return page


class ReportPage(ReportCase):
    def test_loads_nothing_from_anywhere(self):
        page = self.page()
        for link in page.links:
            self.assertRegex(link, r"^(data:|#|[a-z_0-9]+\.[a-z]+$)", "no address but data and files beside it")
        without_scripts = re.sub(r"<script.*?</script>", "", page.text, flags=re.S)
        self.assertNotRegex(without_scripts, r"https?://|@import|url\(|<iframe|<object")

    def test_pictures_are_whole(self):
        page = self.page()
        self.assertEqual(len(page.images), 3, "scan, model, distances")
        self.assertEqual(page.alternatives, 3)
        sizes = {png_size(base64.b64decode(i.split(",", 1)[1], validate=True)) for i in page.images}
        self.assertEqual(len(sizes), 1, "one direction and scale")

    def test_rooms_and_stages_are_told_with_units(self):
        page = self.page()
        heads = page.row("room")
        first, second = page.row("1"), page.row("2")
        told = dict(zip(heads, first))
        self.assertEqual(told["area, m²"], "11.75")
        self.assertEqual(told["perimeter, m"], "14.00")
        self.assertEqual(told["volume, m³"], "28.50")
        self.assertEqual(told["wall surface, m²"], "34.10")
        self.assertEqual(told["filled in"], "62\u00a0%")
        self.assertEqual((told["mesh"], told["solid"]), ("open", "closed"))
        self.assertEqual(dict(zip(heads, second))["filled in"], "4.0\u00a0%")
        stage = page.row("ParallelVoxelGrid")
        self.assertEqual(stage[1:4], ["1\u202f234\u202f567", "4\u202f800", "0.25"])
        self.assertIn("voxel\u00a00.05\u00a0m", stage[4])
        self.assertIn("depth up to\u00a09", page.row("StructuralPoisson")[4])
        self.assertEqual(page.row("together")[3], "1.75")
        self.assertIn("17.8\u00a0m²", page.words, "floor area of all")
        self.assertEqual(page.row("plane_tolerance")[1], "0.07")

    def test_plan_is_drawn_in_the_page(self):
        page = self.page()
        self.assertIn("room_1", page.ids)
        self.assertIn("11.75 m²", page.words)

    def test_text_of_others_is_escaped(self):
        page = self.page()
        self.assertIn(NASTY, page.words)
        self.assertIn("<b>a part</b>", page.words)
        self.assertNotIn("alert(", "".join(page.scripts))

    def test_what_is_amiss_is_told_with_a_remedy(self):
        words = " ".join(self.page().words.split())
        self.assertIn("Room 1: its mesh is not closed: 2 edges are open.", words)
        self.assertIn("was not seen and is filled in: room 1 62 %.", words)
        self.assertIn("--mesh-from-plan", words)
        self.assertNotIn("room 2 4 %", words)

    def test_nothing_amiss_is_told_too(self):
        report = sample_report()
        report["warnings"], report["rooms"] = [], report["rooms"][1:]
        self.write("report.json", report)
        self.assertIn("Nothing stands out", self.page().words)

    def test_histogram_has_a_bar_a_bin_and_one_beyond(self):
        text = self.page().text
        bars = re.findall(r'<rect x="[0-9.]+" y="[0-9.]+" width="[0-9.]+" height="([0-9.]+)"[^>]*><title>([^<]*)', text)
        self.assertEqual([title.rsplit(": ", 1)[1] for _, title in bars],
                         ["90.00 %", "5.00 %", "2.00 %", "1.00 %", "1.00 %", "1.00 %"])
        heights = [float(height) for height, _ in bars]
        self.assertAlmostEqual(heights[0] / heights[1], 18, delta=0.1)

    def test_models_are_gltf(self):
        """The folder's model.glb as it is, and the mesh: both closed, with rooms and labels."""
        if not HAS_THREE:
            self.skipTest("three.js is missing: Debian package libjs-three")
        models = glb_of(self.page())
        with open(self.file("model.glb"), "rb") as file:
            self.assertEqual(models["solid"], file.read())
        # 12 m2 less the column, 2.5 m high, less the soffit; and the second room. Faces look out of the rooms.
        volume = 11.75 * 2.5 - 3 * 0.3 + 15
        for name, glb in models.items():
            parts = parts_of(glb)
            way = 1 if name == "solid" else -1  # the sample's mesh.ply is a solid, whose faces look out already
            self.assertAlmostEqual(way * sum(map(volume_of, (p["triangles"] for p in parts))), volume, 3, name)
            self.assertEqual({p["room"] for p in parts}, {"room_1", "room_2"})
            self.assertEqual({p["label"] for p in parts}, {"ceiling", "floor", "wall", "detail", "column"})

    def test_a_folder_without_model_glb_shows_its_solid(self):
        if not HAS_THREE:
            self.skipTest("three.js is missing: Debian package libjs-three")
        os.remove(self.file("model.glb"))
        parts = parts_of(glb_of(self.page())["solid"])
        self.assertEqual({p["room"] for p in parts}, {"room_1", "room_2"})

    def test_a_large_mesh_is_thinned(self):
        if not HAS_THREE:
            self.skipTest("three.js is missing: Debian package libjs-three")
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
        triangles = sum(len(p["triangles"]) for p in parts_of(glb_of(page)["mesh"]))
        self.assertTrue(5000 < triangles <= 20000, triangles)
        self.assertIn("is thinned for this page", page.words)

    def test_without_three_the_page_says_so_and_has_pictures(self):
        page = self.page("--three", os.path.join(self.root, "nowhere"))
        self.assertIn("three.js was not found", page.words)
        self.assertEqual(len(page.images), 3)
        self.assertEqual(page.scripts, [])

    def test_without_the_scan_the_page_says_so(self):
        page = Page(self.make())
        self.assertIn("The scan was not found", page.words)
        self.assertEqual(len(page.images), 1, "the model")

    def test_parts_that_are_missing_are_left_out(self):
        for name in ("solid.ply", "mesh.ply", "report.json"):
            os.remove(self.file(name))
        page = Page(self.make())
        self.assertEqual(page.faults, [])
        self.assertEqual(dict(zip(page.row("room"), page.row("1")))["area, m²"], "11.75")
        self.assertNotIn("stages", page.ids)

    def test_a_folder_of_others_is_refused(self):
        for folder in (self.root, os.path.join(self.root, "nowhere"), self.scan):
            run = subprocess.run([REPORT, folder], capture_output=True, text=True)
            self.assertEqual(run.returncode, 1)
            self.assertRegex(run.stderr, r"\A[^\n]{20,}\n\Z")
        self.write("report.json", {"format": "another"})
        self.assertEqual(subprocess.run([REPORT, self.model], capture_output=True).returncode, 1)

    def test_is_the_same_every_time(self):
        self.assertEqual(self.make("--scan", self.scan), self.make("--scan", self.scan))


@unittest.skipUnless(chromium.program(), "there is no Chromium")
class ReportInABrowser(ReportCase):
    def setUp(self):
        super().setUp()
        self.make("--scan", self.scan)

    def open(self, width=1000, height=1200, *flags):
        browser = chromium.Browser(width, height, *flags)
        self.addCleanup(browser.close)
        browser.open(self.file("report.html"))
        self.wait(browser)
        self.assertEqual(browser.messages, [], "nothing on the console")
        self.assertTrue(all(r.startswith(("file://", "data:")) for r in browser.requests), browser.requests)
        return browser

    def wait(self, browser):
        """Until the model is read: glTF is read in steps."""
        for _ in range(100):
            if not HAS_THREE or browser.run("!document.getElementById('view-controls').hidden"
                                            " || !document.getElementById('view-problem').hidden"):
                return
            time.sleep(0.1)
        self.fail("the model does not appear")

    def canvas(self, browser):
        """What the model's canvas shows: rows of RGB."""
        url = browser.run("document.querySelector('#view canvas').toDataURL('image/png')")
        return pixels_of(base64.b64decode(url.split(",", 1)[1]))

    def share(self, rows, test):
        pixels = [p for row in rows[::3] for p in row[::3]]
        return sum(map(test, pixels)) / len(pixels)

    def difference(self, a, b):
        """Share of pixels that differ: lines that lie on faces flicker by a few."""
        pairs = [(p, q) for row, other in zip(a, b) for p, q in zip(row, other)]
        return sum(p != q for p, q in pairs) / len(pairs)

    def choose(self, browser, selector, script):
        browser.run(f"(() => {{ const e = document.querySelector('{selector}'); {script}; "
                    "e.dispatchEvent(new Event('input')); e.dispatchEvent(new Event('change')); })()")

    def test_the_model_is_seen_and_opened_and_cut(self):
        if not HAS_THREE:
            self.skipTest("three.js is missing: Debian package libjs-three")
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
        self.assertEqual(browser.messages, [])

    def test_a_drag_turns_the_model(self):
        if not HAS_THREE:
            self.skipTest("three.js is missing: Debian package libjs-three")
        browser = self.open()
        before = self.canvas(browser)
        browser.run("document.getElementById('view').scrollIntoView({block: 'center'})")
        box = browser.run("(() => { const b = document.querySelector('#view canvas').getBoundingClientRect();"
                          "return [b.left + b.width / 2, b.top + b.height / 2]; })()")
        for kind, shift in (("mousePressed", 0), ("mouseMoved", 60), ("mouseMoved", 120), ("mouseReleased", 120)):
            browser.ask("Input.dispatchMouseEvent", type=kind, x=box[0] + shift, y=box[1], button="left", buttons=1,
                        clickCount=1)
        self.assertGreater(self.difference(self.canvas(browser), before), 0.05)

    def test_fits_a_phone(self):
        browser = self.open(390, 844)
        self.assertLessEqual(browser.run("document.documentElement.scrollWidth"), 390)

    def test_fits_a_sheet_of_paper(self):
        browser = self.open(700, 1000)
        browser.ask("Emulation.setEmulatedMedia", media="print")
        widest = browser.run("Math.max(...[...document.querySelectorAll('body *')].filter(e => !e.closest('svg'))"
                             ".map(e => e.getBoundingClientRect().right))")
        self.assertLessEqual(widest, 700)

    def test_without_webgl_a_sentence_stands_there(self):
        if not HAS_THREE:
            self.skipTest("three.js is missing: Debian package libjs-three")
        browser = chromium.Browser(1000, 800, "--disable-3d-apis")
        self.addCleanup(browser.close)
        browser.open(self.file("report.html"))
        self.wait(browser)
        self.assertIn("no WebGL", browser.run("document.getElementById('view-problem').textContent"))
        self.assertTrue(browser.run("document.getElementById('view').hidden"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[3:]])
