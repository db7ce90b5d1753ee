#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Solids and drawings of a plan, written by the tools, read back by others: ezdxf for DXF, librsvg for
SVG, readers of this file for OBJ and PLY. All against numbers known in closed form.

    test_floorplan_outputs.py pcl_floorplan_extrusion pcl_floorplan_drawing
"""

import json
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from collections import Counter, defaultdict

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
from glb import Glb, volume_of
from plan_samples import arc, rectangle, room, segment, slab

try:
    import ezdxf
except ImportError:
    ezdxf = None
needs_ezdxf = unittest.skipUnless(ezdxf, "python3-ezdxf is not installed")

EXTRUSION, DRAWING = sys.argv[1:3]
SVG = "{http://www.w3.org/2000/svg}"
CHORD = 0.00025
HALL_HEIGHT = 3.0
CELL_HEIGHT = 2.5


def sample_plan():
    """A hall 6 m by 4 m with a half circle at its east, a soffit at its west, a round and a square
    column; beside it, 10 cm of wall between, a room with a platform and a niche."""
    hall = room(1, [segment([0, 0], [6, 0]), arc([6, 2], 2, [6, 0], [6, 4]),
                    segment([6, 4], [0, 4]), segment([0, 4], [0, 0])],
                slab(0), slab(HALL_HEIGHT),
                columns=[[arc([3, 2], 0.4, [3.4, 2], [3.4, 2], False)],
                         rectangle(4.5, 1, 5, 1.5, clockwise=True)],
                details=[{"slab": slab(2.6), "boundary": rectangle(0, 0, 1, 4), "holes": []}])
    cell = room(2, rectangle(0, 4.1, 5, 7.1), slab(0), slab(CELL_HEIGHT),
                floor_details=[{"slab": slab(0.3), "boundary": rectangle(3, 4.1, 5, 7.1), "holes": []}],
                niches=[{"bottom": slab(1), "top": slab(2), "boundary": rectangle(1, 7.1, 2, 7.4)}])
    return {"format": "sedr-floorplan", "version": 1, "unit": "m", "rooms": [hall, cell]}


def facets(radius, sweep):
    """Number and summed area, between chords and centre, of an arc's facets."""
    n = math.ceil(sweep / (2 * math.acos(1 - CHORD / radius)))
    return n, n / 2 * radius ** 2 * math.sin(sweep / n)


COLUMN_FACETS, COLUMN_AREA = facets(0.4, 2 * math.pi)
APSE_FACETS, APSE_AREA = facets(2, math.pi)
HALL_AREA = 24 + APSE_AREA - COLUMN_AREA - 0.25
HALL_VOLUME = HALL_AREA * HALL_HEIGHT - 4 * 0.4
CELL_VOLUME = 15 * CELL_HEIGHT - 6 * 0.3 + 0.3
# Areas of elements, square metres.
ELEMENTS = {
    "room_1_floor": HALL_AREA,
    "room_1_ceiling": HALL_AREA - 4,
    "room_1_wall_1": 6 * 3 - 0.4,
    "room_1_wall_2": APSE_FACETS * 4 * math.sin(math.pi / 2 / APSE_FACETS) * 3,
    "room_1_wall_4": 4 * 2.6,
    "room_1_column_1_face_1": COLUMN_FACETS * 0.8 * math.sin(math.pi / COLUMN_FACETS) * 3,
    "room_1_column_2_face_3": 0.5 * 3,
    "room_1_detail_1": 4,
    "room_1_detail_1_edge_2": 4 * 0.4,
    "room_2_floor": 9,
    "room_2_floor_detail_1": 6,
    "room_2_floor_detail_1_edge_4": 3 * 0.3,
    "room_2_wall_3": 5 * 2.5 - 2 * 0.3 - 1,
    "room_2_niche_1_bottom": 0.3,
    "room_2_niche_1_top": 0.3,
    "room_2_niche_1_side_3": 1,
}


def read_obj(path):
    """Vertices; triangles by group; materials by group; the file of materials."""
    vertices, groups, materials, library = [], defaultdict(list), {}, None
    group = None
    with open(path) as file:
        for line in file:
            word, *rest = line.split() or [""]
            if word == "v":
                vertices.append(tuple(map(float, rest)))
            elif word == "g":
                group = rest[0]
            elif word == "usemtl":
                materials[group] = rest[0]
            elif word == "mtllib":
                library = rest[0]
            elif word == "f":
                groups[group].append(tuple(int(i) - 1 for i in rest))
    return vertices, groups, materials, library


def read_ply(path):
    """The same of a binary PLY, groups by the property `element` and the header's comments."""
    with open(path, "rb") as file:
        content = file.read()
    header, body = content.split(b"end_header\n", 1)
    names, counts, element = {}, {}, None
    properties = defaultdict(list)
    for line in header.decode().splitlines():
        words = line.split()
        if words[:2] == ["comment", "element"]:
            names[int(words[2])] = words[3]
        elif words[0] == "element":
            element = words[1]
            counts[element] = int(words[2])
        elif words[0] == "property":
            properties[element].append(words[1:])
    assert [p[-1] for p in properties["vertex"]] == ["x", "y", "z", "red", "green", "blue", "label", "room"]
    number = {"float": "f", "double": "d"}[properties["vertex"][0][0]]
    row = "<3" + number + "3B2I"
    at = struct.calcsize(row) * counts["vertex"]
    rows = list(struct.iter_unpack(row, body[:at]))
    vertices = [r[:3] for r in rows]
    looks = {(r[6], r[3:6]) for r in rows}
    assert len(looks) == len({label for label, _ in looks}), "a colour a label"
    assert {r[7] for r in rows} == {1, 2}
    assert [p[-1] for p in properties["face"]] == ["vertex_indices", "label", "room", "element", "red", "green", "blue"]
    groups, labels = defaultdict(list), {}
    colours = dict(looks)
    for _ in range(counts["face"]):
        size, a, b, c, label, room, e, *colour = struct.unpack_from("<B6i3B", body, at)
        at += struct.calcsize("<B6i3B")
        assert tuple(colour) == colours.setdefault(label, tuple(colour)), "a face has the colour of its label"
        assert size == 3 and names[e].startswith("room_%d_" % room)
        groups[names[e]].append((a, b, c))
        labels[names[e]] = label
    assert at == len(body)
    return vertices, groups, labels


def area_of(polyline):
    """The area within a closed polyline with bulges."""
    vertices = polyline.get_points("xyb")
    area = 0
    for (x, y, bulge), (u, v, _) in zip(vertices, vertices[1:] + vertices[:1]):
        area += (x * v - u * y) / 2
        if bulge:
            angle = 4 * math.atan(bulge)
            radius = math.dist((x, y), (u, v)) / 2 / math.sin(abs(angle) / 2)
            area += math.copysign(radius ** 2 / 2 * (abs(angle) - math.sin(abs(angle))), angle)
    return area


def read_ppm(path):
    """(red, green, blue) of all pixels."""
    with open(path, "rb") as file:
        content = file.read()
    size = re.match(rb"P6\s(\d+)\s(\d+)\s255\s", content)
    return list(struct.iter_unpack("3B", content[size.end():]))


class Outputs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.plan = self.path("plan.json")
        with open(self.plan, "w") as file:
            json.dump(sample_plan(), file)

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_tool(self, *arguments):
        result = subprocess.run(arguments, capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def dxf(self, plan, *options):
        """The drawing of a plan, in which ezdxf finds no fault."""
        with open(self.plan, "w") as file:
            json.dump(plan, file)
        self.run_tool(DRAWING, self.plan, self.path("plan.dxf"), *options)
        drawing = ezdxf.readfile(self.path("plan.dxf"))
        audit = drawing.audit()
        self.assertEqual((audit.errors, audit.fixes), ([], []))
        return drawing

    def expect_solid(self, vertices, groups, digits):
        """Areas, volumes, and that every edge has two triangles, one each way."""
        volume = defaultdict(float)
        edges = Counter()
        for name, triangles in groups.items():
            area = 0
            for t in triangles:
                a, b, c = (np.array(vertices[i]) for i in t)
                normal = np.cross(b - a, c - a)
                area += np.linalg.norm(normal) / 2
                volume[name.split("_")[1]] += a @ normal / 6
                edges.update([(t[0], t[1]), (t[1], t[2]), (t[2], t[0])])
            if name in ELEMENTS:
                self.assertAlmostEqual(area, ELEMENTS[name], digits, name)
        self.assertLessEqual(set(ELEMENTS), set(groups))
        self.assertAlmostEqual(volume["1"], HALL_VOLUME, digits)
        self.assertAlmostEqual(volume["2"], CELL_VOLUME, digits)
        for (a, b), count in edges.items():
            self.assertEqual((count, edges[b, a]), (1, 1))

    def test_obj(self):
        self.run_tool(EXTRUSION, self.plan, self.path("solid.obj"))
        vertices, groups, materials, library = read_obj(self.path("solid.obj"))
        self.expect_solid(vertices, groups, 5)
        self.assertEqual(library, "solid.mtl")
        with open(self.path("solid.obj")) as file:
            self.assertIn("\ng room_2_floor room_2 storey_1\n", file.read())
        with open(self.path("solid.mtl")) as file:
            defined = re.findall(r"^newmtl (\S+)", file.read(), re.M)
        self.assertLessEqual(set(materials.values()), set(defined))
        for name, material in (("room_1_wall_2", "wall"), ("room_1_column_1_face_1", "column"),
                               ("room_1_detail_1", "detail"), ("room_2_floor", "floor"),
                               ("room_2_ceiling", "ceiling"), ("room_2_niche_1_top", "detail")):
            self.assertEqual(materials[name], material)
        for corner in ((0, 0, 0), (6, 4, 3), (1, 4, 2.6), (3, 7.1, 0.3), (2, 7.4, 1)):
            self.assertTrue(any(math.dist(v, corner) < 1e-6 for v in vertices), corner)

    def test_ply(self):
        self.run_tool(EXTRUSION, self.plan, self.path("solid.ply"))
        vertices, groups, labels = read_ply(self.path("solid.ply"))
        self.expect_solid(vertices, groups, 4)
        self.assertEqual(labels["room_1_ceiling"], 1)
        self.assertEqual(labels["room_2_floor"], 2)
        self.assertEqual(labels["room_2_floor_detail_1"], 4)
        self.assertEqual(labels["room_1_wall_2"], 3)
        self.assertEqual(labels["room_1_detail_1_edge_2"], 4)
        self.assertEqual(labels["room_1_column_1_face_1"], 5)

    def test_glb(self):
        self.run_tool(EXTRUSION, self.plan, self.path("solid.glb"))
        with open(self.path("solid.glb"), "rb") as file:
            glb = Glb(file.read())
        self.assertEqual(glb.json["asset"]["version"], "2.0")
        nodes, (storey,) = glb.json["nodes"], glb.json["scenes"][0]["nodes"]
        self.assertEqual([nodes[room]["name"] for room in nodes[storey]["children"]], ["room_1", "room_2"])
        volumes = defaultdict(float)
        for room, name, material, triangles in glb.parts():
            volumes[room] += volume_of(triangles)
            if name.endswith("_ceiling"):
                self.assertEqual(material, "ceiling")
                self.assertEqual(len({p[1] for t in triangles for p in t}), 1, "y is up")
        self.assertAlmostEqual(volumes["room_1"], HALL_VOLUME, 3)
        self.assertAlmostEqual(volumes["room_2"], CELL_VOLUME, 3)

    @needs_ezdxf
    def test_dxf(self):
        drawing = self.dxf(sample_plan())
        self.assertEqual(drawing.dxfversion, "AC1027")
        kinds = Counter((e.dxftype(), e.dxf.layer) for e in drawing.modelspace()
                        if e.dxftype() != "TEXT")
        dimensions = kinds.pop(("DIMENSION", "A-ANNO-DIMS"))
        # Edges of soffit, platform and niche that lie on walls are not drawn twice.
        self.assertEqual(dict(kinds), {("LWPOLYLINE", "A-AREA"): 2, ("LINE", "A-WALL"): 7, ("ARC", "A-WALL"): 1,
                                 ("LINE", "A-WALL-GUES"): 6, ("ARC", "A-WALL-GUES"): 1, ("CIRCLE", "A-COLS"): 1, ("LINE", "A-COLS"): 4, ("LINE", "A-CLNG"): 1,
                                 ("LINE", "A-FLOR-LEVL"): 1, ("LINE", "A-WALL-NICH"): 3, ("LINE", "A-ANNO-SECT"): 8,
                                 ("HATCH", "A-WALL-PATT"): 1})
        for layer in ("A-WALL", "A-WALL-NICH", "A-COLS", "A-DOOR", "A-CLNG", "A-CLNG-RIDG", "A-CLNG-HEAD",
                      "A-CLNG-IDEN", "A-FLOR-LEVL", "A-AREA", "A-AREA-IDEN", "A-ANNO-DIMS", "A-ANNO-TEXT"):
            self.assertIn(layer, drawing.layers)
        self.assertLessEqual({e.dxf.layer for e in drawing.modelspace()}, {x.dxf.name for x in drawing.layers})
        (apse,) = drawing.modelspace().query("ARC[layer=='A-WALL']")
        (behind,) = drawing.modelspace().query("ARC[layer=='A-WALL-GUES']")
        self.assertAlmostEqual(behind.dxf.radius, 2.2, 6, "the wall is assumed 0.2 m thick")
        self.assertEqual((apse.dxf.center.x, apse.dxf.center.y, apse.dxf.radius), (6, 2, 2))
        self.assertEqual((apse.dxf.start_angle, apse.dxf.end_angle), (270, 90))
        (column,) = drawing.modelspace().query("CIRCLE")
        self.assertEqual((column.dxf.center.x, column.dxf.center.y, column.dxf.radius), (3, 2, 0.4))
        self.assertEqual(drawing.header["$INSUNITS"], 6, "metres")
        outlines = sorted(abs(area_of(line)) for line in drawing.modelspace().query("LWPOLYLINE"))
        self.assertAlmostEqual(outlines[0], 15, 6)
        self.assertAlmostEqual(outlines[1], 24 + 2 * math.pi, 6)
        self.assertTrue(all(line.is_closed for line in drawing.modelspace().query("LWPOLYLINE")))
        found = list(drawing.modelspace().query("DIMENSION"))
        self.assertEqual(len(found), dimensions)
        lengths = Counter(round(d.get_measurement(), 6) for d in found)
        walls, overall = Counter([3, 3, 4, 5, 5, 6, 6]), Counter([8, 7.1])
        self.assertEqual((walls + overall) - lengths, Counter())
        self.assertIn(0.1, lengths, "the wall between the rooms")
        for d in found:  # what is shown is what is measured
            (shown,) = drawing.blocks.get(d.dxf.geometry).query("TEXT")
            self.assertEqual(shown.dxf.text, "%.2f" % d.get_measurement())
        # At 1:50 letters of 2.52 mm.
        self.assertEqual({round(t.dxf.height, 4) for t in drawing.modelspace().query("TEXT[layer=='A-AREA-IDEN']")},
                         {0.126})
        ends = Counter()
        for e in drawing.modelspace().query("LINE ARC"):
            if e.dxf.layer != "A-WALL":
                continue
            two = (e.start_point, e.end_point) if e.dxftype() == "ARC" else (e.dxf.start, e.dxf.end)
            ends.update((round(p.x, 5), round(p.y, 5)) for p in two)
        self.assertEqual(set(ends.values()), {2}, "walls are closed loops")
        texts = [e.dxf.text for e in drawing.modelspace().query("TEXT")]
        exact = 24 + 2 * math.pi - math.pi * 0.16 - 0.25
        for text in ("Room 1", "Room 2", "%.2f m²" % exact, "15.00 m²", "h 3.00 m", "R 2.00",
                     "2.60", "▼ +0.30", "Ø 0.80", "0.50 x 0.50"):
            self.assertIn(text, texts)

    @needs_ezdxf
    def test_layout_and_hatches_in_dxf(self):
        """What is hatched is the wall between the rooms; the layout has the title block and the model to scale."""
        plan = sample_plan()
        plan["openings"] = [{"kind": "passage", "rooms": [2, 1], "walls": [{"room": 2, "element": 0}, {"room": 1, "element": 2}],
                             "start": [3, 4.05], "end": [4, 4.05], "bottom": 0, "top": 2, "depth": 0.1, "hinge": "unknown",
                             "state": "unknown"}]
        drawing = self.dxf(plan, "--scale", "50", "--client", "Smith")

        def area(path):
            corners = [v[:2] for v in path.vertices]
            return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1]))) / 2

        hatches = drawing.modelspace().query("HATCH[layer=='A-WALL-PATT']")
        self.assertEqual([len(h.paths) for h in hatches], [1, 1], "parted by the passage")
        self.assertAlmostEqual(sum(area(h.paths[0]) for h in hatches), 4.1 * 0.1, 4, "to the middle of the corner")
        sheet = drawing.layout("Sheet")
        texts = [t.dxf.text for t in sheet.query("TEXT")]
        for text in ("Smith", "1:50 A3", "Floor plan"):
            self.assertIn(text, texts)
        paper, view = sheet.query("VIEWPORT")
        self.assertEqual((paper.dxf.width, paper.dxf.height), (420, 297))
        self.assertAlmostEqual(view.dxf.height / view.dxf.view_height, 20, 6, "millimetres a metre at 1:50")
        self.assertAlmostEqual(view.dxf.view_center_point[0], 4, 0, "the middle of the plan")

    @needs_ezdxf
    def test_openings_in_dxf(self):
        """Walls end at openings, which are blocks with attributes; texts are UTF-8."""
        plan = sample_plan()
        plan["names"] = {"2": "Schlafzimmer ü €"}
        hall = plan["rooms"][0]["id"]
        plan["openings"] = [{"kind": "door", "rooms": [hall, 0], "walls": [{"room": hall, "element": 0}], "start": [2, -0.1],
                             "end": [1, -0.1], "bottom": 0, "top": 2, "depth": 0.2, "hinge": "start", "swing": hall},
                            {"kind": "window", "rooms": [hall, 0], "walls": [{"room": hall, "element": 0}], "start": [5, -0.1],
                             "end": [3.5, -0.1], "bottom": 0.9, "top": 2, "depth": 0.2}]
        for opening in plan["openings"]:
            opening.update({"state": "unknown", "hinge": opening.get("hinge", "unknown")})
        drawing = self.dxf(plan)
        on_wall = sorted((min(e.dxf.start.x, e.dxf.end.x), max(e.dxf.start.x, e.dxf.end.x))
                         for e in drawing.modelspace().query("LINE[layer=='A-WALL']") if e.dxf.start.y == e.dxf.end.y == 0)
        self.assertEqual(on_wall, [(0, 1), (2, 3.5), (5, 6)])
        blocks = {i.dxf.name: i for i in drawing.modelspace().query("INSERT")}
        self.assertEqual({name: {a.dxf.tag: a.dxf.text for a in i.attribs} for name, i in blocks.items()},
                         {"D1": {"NUMBER": "D1", "WIDTH": "1.000", "HEIGHT": "2.000", "SILL": "0.000"},
                          "W1": {"NUMBER": "W1", "WIDTH": "1.500", "HEIGHT": "1.100", "SILL": "0.900"}})
        self.assertFalse(drawing.layers.get("A-AREA").dxf.plot, "outlines of rooms run through openings")
        self.assertEqual((blocks["D1"].dxf.layer, blocks["W1"].dxf.layer), ("A-DOOR", "A-GLAZ"))
        places = [p for e in blocks["W1"].virtual_entities() for p in (e.dxf.start, e.dxf.end)]
        for k, (low, high) in enumerate(((3.5, 5), (-0.2, 0))):
            self.assertAlmostEqual(min(p[k] for p in places), low, 6)
            self.assertAlmostEqual(max(p[k] for p in places), high, 6)
        self.assertEqual(len([e for e in blocks["D1"].virtual_entities() if e.dxftype() == "ARC"]), 1, "its swing")
        self.assertIn("2 Schlafzimmer ü €", [t.dxf.text for t in drawing.modelspace().query("TEXT")])

    @needs_ezdxf
    def test_sections_and_elevations_in_dxf(self):
        """A cut through hall, cell and niche; the walls of the cell, a platform of 0.3 m along 7 m of them."""
        for options, area in ((("--section", "1.5,0,1.5,1"), 4 * HALL_HEIGHT + 3 * CELL_HEIGHT + 0.3 * 1),
                              (("--elevations", "2"), 16 * CELL_HEIGHT - 7 * 0.3)):
            found = sum(area_of(line) for line in self.dxf(sample_plan(), *options).modelspace().query("LWPOLYLINE"))
            self.assertAlmostEqual(found, area, 6, options)

    def test_pdf(self):
        """The page is that of the SVG, with its texts."""
        self.run_tool(DRAWING, self.plan, self.path("plan.svg"))
        self.run_tool(DRAWING, self.plan, self.path("plan.pdf"))
        root = xml.etree.ElementTree.parse(self.path("plan.svg")).getroot()
        if shutil.which("pdfinfo"):
            result = subprocess.run(["pdfinfo", self.path("plan.pdf")], capture_output=True, text=True)
            box = [float(x) / 72 * 25.4 for x in re.search(r"Page size: +(\S+) x (\S+) pts", result.stdout).groups()]
            for found, side in zip(box, ("width", "height")):
                self.assertAlmostEqual(found, float(root.get(side)[:-2]), 1)
        if shutil.which("pdftotext"):
            result = subprocess.run(["pdftotext", self.path("plan.pdf"), "-"], capture_output=True, text=True)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            found = "".join(result.stdout.split())  # pdftotext guesses where blanks are
            for text in root.iter(SVG + "text"):
                self.assertIn("".join(text.text.split()), found)

    def test_svg(self):
        self.run_tool(DRAWING, self.plan, self.path("plan.svg"), "--scale", "50")
        root = xml.etree.ElementTree.parse(self.path("plan.svg")).getroot()
        width = float(root.get("width")[:-2])
        self.assertTrue(root.get("width").endswith("mm"))
        self.assertEqual(root.get("viewBox").split()[2:], [root.get("width")[:-2], root.get("height")[:-2]])
        groups = {g.get("id"): g for g in root.iter(SVG + "g")}
        self.assertTrue({"room_1", "room_2"} <= set(groups))
        texts = {t.text for t in root.iter(SVG + "text")}
        for text in ("Room 1", "Room 2", "15.00 m²", "h 3.00 m", "6.00", "R 2.00", "8.00", "7.10", "1:50 A3",
                     "2.60", "0.50 x 0.50", "\u00d8 0.80", "Floor plan"):
            self.assertIn(text, texts)
        if not shutil.which("rsvg-convert") or not shutil.which("pdftoppm"):
            self.skipTest("librsvg2-bin or poppler-utils is not installed")
        self.run_tool("rsvg-convert", "-f", "pdf", self.path("plan.svg"), "-o", self.path("drawn.pdf"))
        self.run_tool("pdftoppm", "-singlefile", "-scale-to-x", "1800", "-scale-to-y", "-1", self.path("drawn.pdf"), self.path("drawn"))
        pixels = Counter(read_ppm(self.path("drawn.ppm")))
        square = (width / 1800 * 0.05) ** 2  # of a pixel, in square metres of the world

        def area(colour):
            return square * sum(n for pixel, n in pixels.items() if max(abs(p - q) for p, q in zip(pixel, colour)) < 3)

        # Lines and letters cover some of the floors and columns.
        floors = 24 + 2 * math.pi - math.pi * 0.16 - 0.25 + 15 + 0.3
        self.assertLess(area((0xf6, 0xf3, 0xec)), 1.01 * floors)
        self.assertGreater(area((0xf6, 0xf3, 0xec)), 0.94 * floors)
        columns = math.pi * 0.16 + 0.25
        self.assertLess(area((0x7d, 0x7d, 0x7d)), 1.03 * columns)
        self.assertGreater(area((0x7d, 0x7d, 0x7d)), 0.85 * columns)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
