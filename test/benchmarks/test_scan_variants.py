#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the variants of scans: test_scan_variants.py [FOLDER of pcl_sedr and pcl_simulate_indoor_scan]"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy as np
    from shapely.geometry import box
    import scan_variants
    from buildings import grades
except ImportError as error:
    print(f"skipped: the Python package {error.name} is missing")
    sys.exit(77)

BIN = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else None
SCENE = scan_variants.runs.ROOT / "tools/simulator/scenes/bls_room.json"


def rooms():
    """Two rooms on one floor, 4 m apart."""
    return [grades.Place("a", box(0, 0, 3, 4), 0, 2.5), grades.Place("b", box(7, 0, 10, 4), 0, 2.5)]


def corners(places):
    return np.array([[x, y, z] for p in places for x in p.plan.bounds[::2] for y in p.plan.bounds[1::2] for z in (p.low, p.high)], float)


class Variants(unittest.TestCase):
    def setUp(self):
        self.rng = np.random.default_rng(1)
        self.points = np.repeat(corners(rooms()), 200, axis=0)

    def variant(self, name):
        return scan_variants.VARIANTS[name](self.points, self.rng)

    def test_bring_plans_back_to_where_they_were(self):
        for name in ("turned_27", "turned_45", "mirrored", "moved"):
            variant = self.variant(name)
            self.assertGreater(np.abs(variant.points - self.points).max(), 0.019, name)
            for place in rooms():
                there = box(*place.plan.bounds)
                there = scan_variants.affine_transform(there, [*variant.matrix.ravel(), *variant.shift])
                self.assertLess(variant.back(there).symmetric_difference(place.plan).area, 1e-9, name)

    def test_move_points_as_they_move_plans(self):
        variant = self.variant("turned_27")
        c, s = np.cos(np.radians(27)), np.sin(np.radians(27))
        np.testing.assert_allclose(variant.points[:, 0], c * self.points[:, 0] - s * self.points[:, 1])
        np.testing.assert_allclose(variant.points[:, 2], self.points[:, 2])

    def test_expect_the_rooms_beside_a_cut_and_both_storeys(self):
        half = self.variant("halved")
        self.assertLess(half.points[:, 0].max(), 7)
        self.assertEqual([r.name for r in half.expected(rooms())], ["a"])
        twice = self.variant("doubled")
        self.assertEqual(len(twice.points), 2 * len(self.points))
        self.assertAlmostEqual(twice.points[:, 2].max(), 5 + scan_variants.SLAB)
        self.assertEqual([r.low for r in twice.expected(rooms())], [0, 0, 2.8, 2.8])

    def test_thin_and_add_noise(self):
        self.assertAlmostEqual(len(self.variant("thinned").points) / len(self.points), 1 / 3, delta=0.05)
        self.assertAlmostEqual((self.variant("noisy").points - self.points).std(), 0.01, delta=0.001)

    def test_keep_rooms_that_overlap_on_the_same_storey(self):
        self.assertEqual(scan_variants.kept(rooms(), rooms()), 2)
        self.assertEqual(scan_variants.kept(rooms(), rooms()[1:]), 1)
        self.assertEqual(scan_variants.kept(rooms(), []), 0)
        self.assertEqual(scan_variants.kept([], rooms()), 0)
        raised = [grades.Place(r.name, r.plan, r.low + 2.8, r.high + 2.8) for r in rooms()]
        self.assertEqual(scan_variants.kept(rooms(), raised), 0)
        narrow = [grades.Place("a", box(0, 0, 2, 4), 0, 2.5)]
        self.assertEqual(scan_variants.kept(rooms(), narrow), 0, "two thirds of it")

    @unittest.skipUnless(BIN, "needs the programs")
    def test_of_a_simulated_room_are_the_room(self):
        with tempfile.TemporaryDirectory() as name:
            done = subprocess.run([BIN / "pcl_simulate_indoor_scan", SCENE, name, "--rays", "60000"], capture_output=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            done = subprocess.run([sys.executable, pathlib.Path(__file__).with_name("scan_variants.py"), pathlib.Path(name) / "scan.pcd",
                                   "--bin", BIN, "--variants", "turned_27", "doubled"], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("turned_27: 1 of 1 rooms kept", done.stdout)
            self.assertIn("doubled: 2 of 2 rooms kept", done.stdout)
            lost = subprocess.run([sys.executable, pathlib.Path(__file__).with_name("scan_variants.py"), pathlib.Path(name) / "none.pcd",
                                   "--bin", BIN], capture_output=True, text=True, check=False)
            self.assertEqual(lost.returncode, 1)
            self.assertIn("none.pcd", lost.stderr)


if __name__ == "__main__":
    unittest.main()
