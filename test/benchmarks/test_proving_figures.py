#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the figures that proving_ground.py measures on files: test_proving_figures.py FOLDER_OF_PROGRAMS"""
import json
import pathlib
import sys
import tempfile
import types
import unittest

from buildings import run_tests

try:
    import numpy as np

    import accuracy_grades
    from proving import figures, meshes
except ImportError:
    figures = None  # numpy, scipy or shapely is missing

BIN = sys.argv.pop(1) if len(sys.argv) > 1 else None
FLOOR, WALL, DETAIL = 2, 3, 4


def plate(x, y, z, label):
    """A level rectangle."""
    a, b, c, d = ([i, j, z] for i, j in ((x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])))
    return [([a, b, c], label), ([a, c, d], label)]


def mesh_of(*parts, room=1):
    triangles = [triangle for part in parts for triangle in part]
    return meshes.Mesh(np.array([corners for corners, _ in triangles], float), np.array([label for _, label in triangles]),
                       np.full(len(triangles), room))


def box(corner, low=(0, 0, 0)):
    """A closed box from `low` to a corner, with ceiling, floor and walls."""
    faces = {1: [(4, 5, 7, 6)], 2: [(0, 2, 3, 1)], 3: [(0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]}
    points = [[(low, corner)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)]
    return mesh_of([([points[i] for i in half], label) for label, quads in faces.items()
                    for a, b, c, d in quads for half in ((a, b, c), (a, c, d))])


@unittest.skipUnless(figures and BIN, "needs the programs, numpy, scipy and shapely")
class Figures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.run_ = types.SimpleNamespace(folder=self.folder, out=self.folder / "out", threads=1,
                                          program=lambda name: pathlib.Path(BIN) / name)
        (self.folder / "out").mkdir()

    def near(self, row, delta, **expected):
        for column, value in expected.items():
            self.assertAlmostEqual(row[column], value, delta=delta, msg=column)

    def of_solid(self, solid, truth):
        meshes.write_mesh(self.folder / "out/solid.ply", solid)
        meshes.write_mesh(self.folder / "truth.ply", truth)
        return figures.of_solid(self.run_, [(1, 1)])

    def test_of_an_equal_solid_are_without_error(self):
        row = self.of_solid(box((4, 3, 2.5)), box((4, 3, 2.5)))
        self.assertEqual([row[f"solid_{name}"] for name in ("components", "closed_manifold", "self_intersections", "triangles")],
                         [1, True, 0, 12])
        self.near(row, 1e-6, truth_to_solid_mean=0, truth_to_solid_max=0, solid_to_truth_mean=0, solid_to_truth_max=0,
                  solid_volume_error=0, solid_wall_area_error=0)

    def test_of_a_solid_show_a_wall_that_is_off_by_a_centimetre(self):
        row = self.of_solid(box((4.01, 3, 2.5)), box((4, 3, 2.5)))
        self.near(row, 1e-6, solid_volume_error=0.01 / 4, solid_wall_area_error=0.05 / 35, truth_to_solid_max=0.01, solid_to_truth_max=0.01)
        # Of 59 m2 of the truth 7.5 m2 are 1 cm away, but nearer at their rim of 11 m; of the solid's also 1 cm of floor, ceiling and sides.
        self.near(row, 1e-5, truth_to_solid_mean=(7.5 * 0.01 - 11 * 0.01 ** 2 / 2) / 59,
                  solid_to_truth_mean=(7.5 * 0.01 + 11 * 0.01 ** 2 / 2) / 59.11)

    def test_of_a_solid_see_single_corners(self):
        cube, pulled = box((1, 1, 1)), box((1, 1, 1))
        pulled.corners[np.all(pulled.corners == 1, axis=2)] = [1.01, 1.01, 1.01]
        self.near(self.of_solid(pulled, cube), 1e-6, solid_to_truth_max=0.01 * 3 ** 0.5)
        self.near(self.of_solid(cube, pulled), 1e-6, truth_to_solid_max=0.01 * 3 ** 0.5)

    def test_of_solids_count_triangles_that_go_through_each_other(self):
        first, second = box((2, 2, 2)), box((3, 3.1, 3.3), (1, 1.1, 1.3))
        both = meshes.Mesh(*(np.concatenate(pair) for pair in zip(*((m.corners, m.labels, m.rooms) for m in (first, second)))))
        row = self.of_solid(both, first)
        self.assertEqual(row["solid_components"], 2)
        self.assertGreater(row["solid_self_intersections"], 0)

    def test_of_no_solid_are_none(self):
        self.assertEqual(figures.of_solid(self.run_, []), {})

    def test_of_a_mesh_are_those_of_its_plates(self):
        # A floor, of which the mesh has one half 3 cm too high, and a detail beside a plate that is right, 6 cm too high.
        right = [plate((1, 2), (0, 4), 0, FLOOR), plate((11, 12), (0, 1), 2, WALL)]
        truth = mesh_of(*right, plate((0, 1), (0, 4), 0, FLOOR), plate((10, 11), (0, 1), 2, DETAIL))
        invented = plate((0, 2), (0, 1), -0.2, FLOOR)
        meshes.write_mesh(self.folder / "truth.ply", truth)
        meshes.write_mesh(self.folder / "out/mesh.ply",
                          mesh_of(*right, plate((0, 1), (0, 4), 0.03, FLOOR), plate((10, 11), (0, 1), 2.06, DETAIL), invented))
        row = figures.of_mesh(self.run_, truth, meshes.samples(truth))
        # Samples beside what is right are nearer to it: the mean of min(d, u) with u from 0 to 1 is d - d^2 / 2.
        self.near(row, 1e-4, truth_to_mesh_mean=(4 * (0.03 - 0.03 ** 2 / 2) + 0.06 - 0.06 ** 2 / 2) / 10,
                  truth_to_mesh_rms=((4 * (0.03 ** 2 - 0.03 ** 3 * 2 / 3) + 0.06 ** 2 - 0.06 ** 3 * 2 / 3) / 10) ** 0.5,
                  mesh_to_truth_mean=(4 * 0.03 + 0.06 + 2 * 0.2) / 12)
        self.near(row, 1e-5, truth_to_mesh_p95=0.06, truth_to_mesh_max=0.06, mesh_to_truth_p95=0.2, mesh_to_truth_max=0.2)
        self.near(row, 2e-3, truth_within_1cm=0.505, truth_within_5cm=0.905, mesh_beyond_5cm=3 / 12)
        # The zone is the detail and 10 cm of the plate beside it.
        self.near(row, 1e-2, detail_within_1cm=(0.01 + 0.1) / 1.1, detail_within_5cm=(0.05 + 0.1) / 1.1)
        self.assertEqual(row["closed"], False)

    def test_of_a_closed_mesh_without_details_tell_so(self):
        truth = box((4, 3, 2.5))
        meshes.write_mesh(self.folder / "truth.ply", truth)
        meshes.write_mesh(self.folder / "out/mesh.ply", truth)
        row = figures.of_mesh(self.run_, truth, meshes.samples(truth))
        self.assertEqual([row[name] for name in ("components", "closed", "closed_manifold")],
                         [1, True, True])
        self.assertNotIn("detail_within_5cm", row)

    def test_of_points_are_those_of_their_heights(self):
        truth = mesh_of(plate((0, 4), (0, 1), 0, FLOOR))
        meshes.write_mesh(self.folder / "truth.ply", truth)
        x, y = np.meshgrid(np.linspace(0, 3, 151), np.linspace(0, 1, 50))
        points = np.stack([x.ravel(), y.ravel(), np.full(x.size, 0.01)], axis=1)
        points[::10, 2] = 0.07
        meshes.write_xyz(self.folder / "out/structure.pcd", points)
        row = figures.of_structure(self.run_, meshes.samples(truth))
        self.near(row, 1e-5, points_to_truth_mean=0.016, points_to_truth_max=0.07, points_beyond_5cm=0.1)
        self.near(row, 2e-3, truth_covered=(3 + (0.08 ** 2 - 0.01 ** 2) ** 0.5) / 4)

    def test_of_labels_are_recall_and_precision(self):
        # How often a point of a true label is nearest to one of a label of the structure; 5 is a column.
        counts = {(1, 1): 3, (1, 2): 1, (2, 2): 5, (3, 3): 2, (5, 3): 1, (3, 1): 2, (0, 3): 1, (4, 4): 2, (4, 0): 1}
        pairs = [pair for pair, count in counts.items() for _ in range(count)]
        for name, which in (("scan.pcd", 0), ("out/structure.pcd", 1)):
            lines = "".join(f"{k} 0 0 {pair[which]}\n" for k, pair in enumerate(pairs))
            (self.folder / name).write_text("VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
                                            f"WIDTH {len(pairs)}\nHEIGHT 1\nPOINTS {len(pairs)}\nDATA ascii\n{lines}", encoding="utf-8")
        self.assertEqual(figures.of_labels(self.run_), {
            "ceiling_recall": 3 / 4, "ceiling_precision": 3 / 5, "floor_recall": 1, "floor_precision": 5 / 6, "wall_recall": 3 / 5,
            "wall_precision": 3 / 4, "detail_recall": 2 / 3, "detail_precision": 1})

    def test_of_accuracy_are_shares_of_errors_within_standard_errors(self):
        meshes.write_mesh(self.folder / "truth.ply", box((4, 3, 2.5)))
        (self.folder / "truth.json").write_text('{"openings": []}', encoding="utf-8")
        # Walls 2, 4, 7 and 60 mm off with standard errors of 3 mm; a floor 1 mm off with one of 0.5 mm; a ceiling that was not measured.
        x0, y0, x1, y1 = -0.007, 0.002, 4.004, 3.06
        corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
        walls = [{"type": "segment", "start": a, "end": b, "accuracy": {"standard_error": 0.003, "deviation_95": 0.01}}
                 for a, b in zip(corners, corners[1:] + corners[:1])]
        room = {"id": 1, "height": 2.5, "boundary": walls, "columns": [], "details": [], "floor_details": [],
                "floor": {"plane": [0, 0, 1, -0.001], "accuracy": {"standard_error": 0.0005, "deviation_95": 0.01}},
                "ceiling": {"plane": [0, 0, 1, -2.5]}}
        (self.folder / "out/floorplan.json").write_text(json.dumps({"rooms": [room], "openings": []}), encoding="utf-8")
        rows = accuracy_grades.errors_of(self.folder, "out/floorplan.json")
        self.assertEqual(sorted(round(1000 * abs(row[1]), 3) for row in rows if not np.isnan(row[1])), [1, 2, 4, 7])
        lines = accuracy_grades.table(rows).splitlines()
        self.assertEqual(lines[2:], ["| walls | 4 | 1 | 4.00 | 3.00 | 33 % | 67 % | 100 % |", "| floors | 1 | 0 | 1.00 | 0.50 | 0 % | 100 % | 100 % |"])


if __name__ == "__main__":
    run_tests.main()
