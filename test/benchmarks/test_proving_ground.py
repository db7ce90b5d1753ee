#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the proving ground's runs, figures and bars: test_proving_ground.py FOLDER_OF_PROGRAMS"""
import csv
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from buildings import run_tests
from proving import bars

try:
    import numpy as np

    from proving import meshes, plans
except ImportError:
    meshes = None  # numpy, scipy or shapely is missing: only the bars are tested

BIN = sys.argv.pop(1) if len(sys.argv) > 1 else None
SCRIPT = pathlib.Path(__file__).with_name("proving_ground.py")
GOOD = {"with_mesh": True, "noise": 0.001, "rooms_found": 2, "rooms_true": 2, "rooms_matched": 2, "closed_manifold": True,
        "components": 2, "truth_to_mesh_mean": 0.002, "truth_within_1cm": 0.95, "truth_within_5cm": 0.99, "mesh_beyond_5cm": 0.005,
        "solid_components": 2, "solid_closed_manifold": True, "solid_self_intersections": 0, "truth_to_solid_mean": 0.0001,
        "truth_to_solid_max": 0.001, "solid_volume_error": 0.005, "solid_wall_area_error": 0.02, "arcs_true": 0,
        "solid_triangles": 5000, "area_error": 0.01, "rooms_with_other_corners": 0, "points_beyond_5cm": 0.005, "truth_covered": 0.99}
WORSE = {"closed": {"closed_manifold": False}, "components": {"components": 3}, "mean": {"truth_to_mesh_mean": 0.00201},
         "1 cm": {"truth_within_1cm": 0.949}, "5 cm": {"truth_within_5cm": None}, "model > 5 cm": {"mesh_beyond_5cm": 0.0051},
         "details": {"detail_within_5cm": 0.96}, "solid closed": {"solid_components": None}, "solid crossing":
         {"solid_self_intersections": 1}, "solid mean": {"truth_to_solid_mean": 0.00011}, "solid max": {"truth_to_solid_max": 0.0011},
         "solid volume": {"solid_volume_error": 0.0051}, "wall surface": {"solid_wall_area_error": 0.021}, "triangles":
         {"solid_triangles": 5001}, "area": {"area_error": None}, "radius": {"radius_error": 0.011}, "corners":
         {"rooms_with_other_corners": 1}, "rooms": {"rooms_matched": 1}, "failed": {"failure": "no ceiling"}}


def segments(corners):
    return [{"type": "segment", "start": a, "end": b} for a, b in zip(corners, corners[1:] + corners[:1])]


def arc(start, end, centre, ccw=True):
    return {"type": "arc", "start": start, "end": end, "centre": centre, "radius": math.dist(start, centre), "counter_clockwise": ccw}


def room(boundary, **more):
    return {"id": 1, "boundary": boundary, "columns": [], "area": 12.0, "height": 3.0, "volume": 36.0, "perimeter": 14.0, **more}


def compared(found, true):
    row = {}
    ids = plans.compare_rooms({"rooms": found}, {"rooms": [{"id": r["id"], "mesh": None} for r in found]}, {"rooms": true}, row)
    return row, ids


class Bars(unittest.TestCase):
    def test_are_reached_on_their_limits_and_missed_beyond(self):
        self.assertEqual(bars.missed(GOOD), [])
        for bar, figures in WORSE.items():
            self.assertEqual([name for name, _ in bars.missed({**GOOD, **figures})], [bar])
        self.assertEqual({*WORSE, "points > 5 cm", "covered"}, set(bars.NAMES))

    def test_are_missed_by_figures_that_are_no_number(self):
        points = {**GOOD, "with_mesh": False}
        for bar, good, column in (("area", GOOD, "area_error"), ("5 cm", GOOD, "truth_within_5cm"), ("radius", GOOD, "radius_error"),
                                  ("details", GOOD, "detail_within_5cm"), ("covered", points, "truth_covered"),
                                  ("solid max", points, "truth_to_solid_max")):
            self.assertEqual([name for name, _ in bars.missed({**good, column: math.nan})], [bar])

    def test_of_points_apply_without_a_mesh(self):
        points = {**GOOD, "with_mesh": False, "closed_manifold": None}
        self.assertEqual(bars.missed(points), [])
        self.assertEqual(bars.missed({**points, "truth_covered": 0.98}), [("covered", "truth covered 98.00 % < 99 %")])

    def test_of_the_mean_grow_with_the_noise(self):
        for noise, limit in ((0, 0.002), (0.001, 0.002), (0.0105, 0.003), (0.02, 0.004), (0.1, 0.004)):
            self.assertAlmostEqual(bars.mean_limit(noise), limit)


@unittest.skipUnless(meshes, "needs numpy, scipy and shapely")
class Figures(unittest.TestCase):
    def test_of_an_equal_plan_are_without_error(self):
        box = room(segments([[0, 0], [4, 0], [4, 3], [0, 3]]))
        row, ids = compared([box], [box])
        self.assertEqual(ids, [(1, 1)])
        self.assertEqual((row["rooms_matched"], row["area_error"], row["corner_distance_max"]), (1, 0, 0))
        self.assertEqual((row["corners_true"], row["corners_found"], row["rooms_with_other_corners"]), (4, 4, 0))

    def test_of_corners_tell_the_farthest_one(self):
        corners = [[0, 0], [4, 0], [4, 3], [0, 3]]
        for k in range(4):
            moved = [[x + 0.1 * (k == i), y] for i, (x, y) in enumerate(corners)]
            self.assertAlmostEqual(compared([room(segments(moved))], [room(segments(corners))])[0]["corner_distance_max"], 0.1)

    def test_pair_rooms_by_their_overlap_once(self):
        true = [room(segments([[0, 0], [4, 0], [4, 3], [0, 3]]), id=1), room(segments([[4, 0], [5, 0], [5, 3], [4, 3]]), id=2)]
        row, ids = compared([room(segments([[0, 0], [5, 0], [5, 3], [0, 3]]), id=7, area=15.0)], true)
        self.assertEqual(ids, [(7, 1)])
        self.assertEqual((row["rooms_found"], row["rooms_true"], row["rooms_matched"]), (1, 2, 1))
        self.assertAlmostEqual(row["area_error"], 0.25)
        self.assertAlmostEqual(row["corner_distance_max"], 1)

    def test_count_collinear_pieces_of_the_truth_as_one_wall(self):
        true = room(segments([[0, 0], [2, 0], [4, 0], [4, 3], [0, 3]]))
        row, _ = compared([true], [true])
        self.assertEqual((row["corners_true"], row["corners_found"], row["rooms_with_other_corners"]), (4, 5, 1))

    def test_of_an_arc_are_those_of_its_radius(self):
        def half_round(radius):  # a straight wall and two quarters of a circle
            return room([*segments([[-radius, 0], [radius, 0]])[:1], arc([radius, 0], [0, radius], [0, 0]),
                         arc([0, radius], [-radius, 0], [0, 0])])
        row, _ = compared([half_round(2.02)], [half_round(2.0)])
        self.assertEqual((row["corners_true"], row["arcs_true"], row["arcs_found"]), (2, 1, 2))
        self.assertAlmostEqual(row["radius_error"], 0.01)
        straight = room(segments([[-2, 0], [2, 0], [0, 2]]))
        self.assertEqual(compared([straight], [half_round(2.0)])[0]["radius_error"], 1)

    def test_of_clockwise_columns_are_those_of_circles(self):
        column = [arc([1.5, 1], [0.5, 1], [1, 1], False), arc([0.5, 1], [1.5, 1], [1, 1], False)]
        box = room(segments([[0, 0], [4, 0], [4, 3], [0, 3]]), columns=[column])
        row, _ = compared([box], [box])
        self.assertEqual((row["corners_true"], row["arcs_true"], row["radius_error"]), (4, 1, 0))

    def test_samples_lie_evenly_on_the_triangles(self):
        corners = np.array([[[0, 0, 0], [4, 0, 0], [4, 3, 0]], [[0, 0, 0], [4, 3, 0], [0, 3, 0]]], float)
        points = meshes.samples(meshes.Mesh(corners, np.array([2, 2]), np.array([1, 1])))
        self.assertEqual(len(points), 30000)
        self.assertTrue(np.all((points >= 0) & (points <= [4, 3, 0])))
        for low in range(4):  # a metre of four
            self.assertAlmostEqual(np.mean((points[:, 0] >= low) & (points[:, 0] < low + 1)), 0.25, places=2)


@unittest.skipUnless(meshes and BIN, "needs the programs, numpy, scipy and shapely")
class Runs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.csv = pathlib.Path(self.folder.name) / "runs.csv"

    def bench(self, *options):
        command = [sys.executable, SCRIPT, self.csv, "--bin", BIN, "--scenes", "bls_room", "--noise", "0.005", *options]
        return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)

    def rows(self):
        with open(self.csv, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_of_a_scene_have_all_figures_and_are_not_repeated(self):
        table = pathlib.Path(self.folder.name) / "table.md"
        self.assertEqual(self.bench("--seeds", "1", "--rays", "20000").returncode, 0)
        again = self.bench("--seeds", "1,2", "--rays", "20000", "--no-mesh", "--jobs", "2", "--table", table)
        self.assertEqual((again.returncode, again.stdout.count("\n")), (0, 2), again.stderr)
        with_mesh, *points = self.rows()
        self.assertEqual(sorted(row["seed"] for row in points), ["1", "2"])
        self.assertRegex(self.bench("--seeds", "1,2", "--no-mesh").stdout, r"^2 of 2 runs are in .*runs.csv already.*\n$")
        self.assertEqual({row["missed"] for row in self.rows()}, {""})
        empty = {column for column, text in with_mesh.items() if not text}
        self.assertEqual(empty - {"missed", "missed_bars", "failure", "warnings"}, {"radius_error"})  # it has details, but no arc
        self.assertIn("Runs: 2.", table.read_text(encoding="utf-8"))

    def test_that_fail_do_not_stop_the_others(self):
        done = self.bench("--rays", "1", "--seeds", "1,2", "--no-mesh", "--prior", "min_headroom=2")
        self.assertEqual((done.returncode, done.stdout.count("failed: ")), (0, 2), done.stderr)
        self.assertEqual([row["missed_bars"] for row in self.rows()], ["failed", "failed"])

    def test_of_bad_options_are_refused_before_the_work(self):
        scene = pathlib.Path(self.folder.name) / "no_scene.json"
        scene.write_text('{"format": 1}', encoding="utf-8")
        for option, value in (("--scenes", "no_such_scene"), ("--scenes", "gone.json"), ("--scenes", scene), ("--noise", "much"),
                              ("--noise", "2"), ("--seeds", "-1"), ("--rays", "-5"), ("--threads", "999"), ("--jobs", "0"),
                              ("--prior", "nonsense=1"), ("--table", "/no/such/folder/t.md"), ("--bin", "/no/such/folder")):
            done = self.bench(f"{option}={value}")
            self.assertEqual((done.returncode, done.stdout, self.csv.exists()), (1, "", False), done.stderr)
            self.assertRegex(done.stderr, r"^proving_ground.py: [^\n]+\n$")
            self.assertIn(str(value).split("=", maxsplit=1)[0], done.stderr)
        for content in (b"scene,colour\nattic,blue\nhall", b"\xff\n"):
            self.csv.write_bytes(content)
            done = self.bench()
            self.assertEqual((done.returncode, done.stderr.count("\n"), self.csv.read_bytes()), (1, 1, content), done.stderr)

    def test_keep_what_others_made(self):
        kept = pathlib.Path(self.folder.name) / "kept/bls_room_n0.005_s1"
        kept.mkdir(parents=True)
        (kept / "notes.txt").touch()
        done = self.bench("--seeds", "1", "--keep", kept.parent)
        self.assertEqual((done.returncode, done.stderr.count("\n"), (kept / "notes.txt").exists()), (1, 1, True), done.stderr)

    def stand_in(self, code):
        """The programs, with another pcl_sedr, a shell script."""
        folder = pathlib.Path(self.folder.name) / "bin"
        folder.mkdir()
        for program in pathlib.Path(BIN).iterdir():
            (folder / program.name).symlink_to(program.resolve())
        (folder / "pcl_sedr").unlink()
        (folder / "pcl_sedr").write_text("#!/bin/sh\n" + code, encoding="utf-8")
        (folder / "pcl_sedr").chmod(0o755)
        return folder

    def test_of_any_exception_are_rows(self):
        done = self.bench("--bin", self.stand_in("exit 0"), "--rays", "100", "--seeds", "1,2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([row["failure"].split(":")[0] for row in self.rows()], ["FileNotFoundError"] * 2)

    def test_of_a_program_that_crashes_tell_the_signal(self):
        self.bench("--bin", self.stand_in("echo a warning >&2; kill -SEGV $$"), "--rays", "100", "--seeds", "1")
        self.assertEqual(self.rows()[0]["failure"], "pcl_sedr was ended by signal 11 (Segmentation fault)")

    def test_that_are_interrupted_leave_no_row_and_no_program(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number):
                self.setUp()
                mark, kept = (pathlib.Path(self.folder.name) / name for name in ("pid", "kept"))
                bin_folder = self.stand_in(f"echo $$ > {mark}.new; mv {mark}.new {mark}; exec sleep 600")
                command = [sys.executable, SCRIPT, self.csv, "--bin", bin_folder, "--scenes", "bls_room", "--noise", "0.005",
                           "--rays", "100", "--keep", kept]
                with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as bench:
                    while not mark.exists() and bench.poll() is None:
                        time.sleep(0.01)
                    bench.send_signal(number)
                    out, err = bench.communicate()
                self.assertEqual((bench.returncode, out, err.count("\n"), self.rows()), (130, "", 1, []), err)
                self.assertEqual(list(kept.iterdir()), [])
                with self.assertRaises(ProcessLookupError):
                    os.kill(int(mark.read_text(encoding="utf-8")), 0)


if __name__ == "__main__":
    run_tests.main()
