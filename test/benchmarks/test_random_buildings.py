#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the random buildings and of their grades: test_random_buildings.py PATH/pcl_simulate_indoor_scan"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from buildings import geometry as g, run_tests
from buildings.build import build
from buildings.kinds import KINDS

try:
    import numpy as np

    from buildings import grades, instrument
    from proving import pcd
except ImportError:
    grades = None  # numpy, scipy or shapely is missing: what needs no grade is tested

SIMULATOR = sys.argv.pop(1) if len(sys.argv) > 1 else None
SEEDS = (1, 2)


def simulate(scene, folder, rays):
    (folder / "scene.json").write_text(json.dumps(scene), encoding="utf-8")
    command = [SIMULATOR, folder / "scene.json", folder, "--rays", str(rays)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


class Geometry(unittest.TestCase):
    def test_an_l_of_two_rectangles_is_one_outline(self):
        outline = g.union_outline([(0, 0, 4, 2), (0, 2, 2, 5)])
        self.assertEqual(len(outline), 6)
        self.assertAlmostEqual(g.area(outline), 14)

    def test_rectangles_that_touch_in_a_corner_are_none(self):
        self.assertIsNone(g.union_outline([(0, 0, 1, 1), (1, 1, 2, 2)]))

    def test_an_inset_is_half_the_wall_on_every_side(self):
        inner = g.inset(g.union_outline([(0, 0, 4, 2), (0, 2, 2, 5)]), lambda axis, value: 0.2 if axis == 0 else 0.4)
        self.assertAlmostEqual(g.area(inner), 3.8 * 1.6 + 1.8 * 3.0)

    def test_an_inset_has_no_step_that_the_thickness_of_a_wall_evens_out(self):
        stepped = [(0, 0), (2, 0), (2, 0.1), (4, 0.1), (4, 3), (0, 3)]
        inner = g.inset(stepped, lambda axis, value: 0.4 if axis == 1 and value == 0 else 0.2)
        self.assertEqual(sorted(inner), [(0.1, 0.2), (0.1, 2.9), (3.9, 0.2), (3.9, 2.9)])

    def test_walls_hide_what_is_behind_them(self):
        outline = g.union_outline([(0, 0, 4, 2), (0, 2, 2, 5)])
        self.assertTrue(g.sees((1, 1), (1, 4), [outline]))
        self.assertFalse(g.sees((3.5, 1), (1, 4.5), [outline]))


class Buildings(unittest.TestCase):
    def test_are_the_same_for_the_same_seed(self):
        self.assertEqual(json.dumps(build(5)), json.dumps(build(5)))
        self.assertNotEqual(json.dumps(build(5, "flat")), json.dumps(build(6, "flat")))

    def test_have_a_station_in_nearly_every_room(self):
        bare, rooms = [], 0
        for kind in KINDS:
            scene = build(3, kind)
            for room in scene["rooms"]:
                outline = [tuple(p["at"]) if isinstance(p, dict) else tuple(p) for p in room["outline"]]
                rooms += 1
                if not any(g.inside(outline, s[:2]) for s in scene["scanners"][0]["stations"]):
                    bare.append(room["name"])
        self.assertLess(len(bare), 0.15 * rooms)
        self.assertFalse([b for b in bare if b.split()[0] not in ("room", "closet")])

    @unittest.skipUnless(SIMULATOR, "needs the simulator")
    def test_of_every_kind_can_be_simulated(self):
        for kind in sorted(KINDS):
            for seed in SEEDS:
                scene = build(seed, kind)
                with tempfile.TemporaryDirectory() as name:
                    done = simulate(scene, pathlib.Path(name), 50)
                    self.assertEqual(done.returncode, 0, f"{kind} {seed}: {done.stderr}")
                    truth = json.loads((pathlib.Path(name) / "truth.json").read_text(encoding="utf-8"))
                self.assertEqual(len(truth["rooms"]), len(scene["rooms"]))
                self.assertEqual(len(truth["storeys"]), int(scene["summary"].split()[2]))
                stairs = sum(link["kind"] == "stairs" for link in truth["links"])
                self.assertEqual(stairs, len(truth["storeys"]) - 1)


def plan_of(truth):
    """The floor plan that says just what the truth says."""
    def level(z):
        return {"plane": [0.0, 0.0, 1.0, -z]}
    rooms = [{"id": r["id"], "boundary": r["boundary"], "columns": r["columns"], "floor": level(r["floor"]),
              "ceiling": level(r["floor"] + r["height"])} for r in truth["rooms"]]
    return {"rooms": rooms, "storeys": [{} for _ in truth["storeys"]]}


@unittest.skipUnless(SIMULATOR and grades, "needs the simulator, numpy, scipy and shapely")
class Grades(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        done = simulate(build(2, "house"), cls.folder, 60_000)
        assert done.returncode == 0, done.stderr
        cls.truth = json.loads((cls.folder / "truth.json").read_text(encoding="utf-8"))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def grade(self, plan):
        (self.folder / "floorplan.json").write_text(json.dumps(plan), encoding="utf-8")
        return grades.grade(self.folder, self.folder)[0]

    def test_of_the_truth_itself_are_all_right(self):
        figures = self.grade(plan_of(self.truth))
        self.assertEqual(figures["all_right"], 1, figures)
        self.assertEqual(figures["matched_0.9"], figures["rooms"])
        self.assertGreater(figures["rooms"], 4)
        self.assertEqual(figures["floors_off"], 0)

    def test_tell_floors_at_a_wrong_height(self):
        plan = plan_of(self.truth)
        plan["rooms"][0]["floor"]["plane"][3] += 0.3
        self.assertEqual(self.grade(plan)["floors_off"], 1)

    def test_tell_missed_and_extra_rooms_and_storeys(self):
        plan = plan_of(self.truth)
        plan["storeys"].append({})
        lost = max(plan["rooms"], key=lambda r: grades.polygon(r["boundary"]).area)
        moved = json.loads(json.dumps(lost))
        for element in moved["boundary"]:
            for end in ("start", "end"):
                element[end][0] += 500
        plan["rooms"] = [r for r in plan["rooms"] if r is not lost] + [moved]
        figures = self.grade(plan)
        self.assertEqual((figures["all_right"], figures["missed"], figures["extra"]), (0, 1, 1))
        self.assertEqual(figures["storeys_found"], figures["storeys"] + 1)

    def test_tell_rooms_on_the_wrong_storey(self):
        plan = plan_of(self.truth)
        for room in plan["rooms"]:
            for slab in ("floor", "ceiling"):
                room[slab]["plane"][3] -= 50
        figures = self.grade(plan)
        self.assertEqual(figures["matched_0.5"], 0)

    def test_may_count_every_room_though_little_of_it_was_seen(self):
        points = pcd.read(self.folder / "scan.pcd")
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for file, content in (("truth.json", self.truth), ("floorplan.json", plan_of(self.truth))):
                (folder / file).write_text(json.dumps(content), encoding="utf-8")
            pcd.write(folder / "scan.pcd", points[points["label"] != 2])  # no floors
            self.assertEqual(grades.grade(folder, folder)[0]["rooms"], 0)
            figures = grades.grade(folder, folder, every_room=True)[0]
        self.assertEqual((figures["all_right"], figures["rooms"]), (1, len(self.truth["rooms"])))

    def test_without_a_plan_miss_all(self):
        (self.folder / "floorplan.json").unlink(missing_ok=True)
        figures = grades.grade(self.folder, self.folder)[0]
        self.assertEqual(figures["missed"], figures["rooms"])
        self.assertEqual(figures["storeys_found"], 0)


@unittest.skipUnless(grades, "needs numpy, scipy and shapely")
class Measured(unittest.TestCase):
    """A scan line over a floor, 2 m below two stations, with a post at every tenth point."""

    def setUp(self):
        self.points = np.zeros(4000, [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("label", "<u4"), ("room", "<u4")])
        self.points["x"] = np.tile(np.linspace(1, 30, 2000), 2)
        self.points["label"] = 2
        self.points["x"][::10] -= 0.5
        self.points["z"][::10] = 0.5
        self.points["label"][::10] = 3
        self.stations = np.array([[0, 0, 2, 2000], [0, 0, 2, 2000]])
        self.measured = instrument.measure(self.points, self.stations, 1)

    def test_points_are_the_same_for_the_same_seed(self):
        self.assertEqual(self.measured.tobytes(), instrument.measure(self.points, self.stations, 1).tobytes())
        self.assertNotEqual(self.measured.tobytes(), instrument.measure(self.points, self.stations, 2).tobytes())

    def test_points_between_neighbours_at_different_depths_belong_to_nothing(self):
        mixed = self.measured[self.measured["label"] == 0]
        self.assertGreater(len(mixed), 20)
        self.assertTrue(((mixed["z"] > -0.05) & (mixed["z"] < 0.55)).all())

    def test_floors_lose_grazing_returns_only(self):
        limit = 2 * np.tan(instrument.GRAZING)
        is_floor, was_floor = self.measured["label"] == 2, self.points["label"] == 2
        for place, share in ((self.points["x"] < limit - 2, 1.0), (self.points["x"] > limit + 2, 1 - instrument.GRAZING_LOST)):
            low, high = self.points["x"][place & was_floor].min() - 0.3, self.points["x"][place & was_floor].max() + 0.3
            kept = (is_floor & (self.measured["x"] > low) & (self.measured["x"] < high)).sum() / (place & was_floor).sum()
            self.assertAlmostEqual(kept, share, delta=0.05)

    def test_stations_are_apart_by_their_registration(self):
        heights = [self.measured[half][self.measured[half]["label"] == 2]["z"].mean()
                   for half in (slice(0, len(self.measured) // 2), slice(len(self.measured) // 2, None))]
        self.assertGreater(abs(heights[0] - heights[1]), 1e-4)
        self.assertLess(abs(heights[0] - heights[1]), 0.05)


if __name__ == "__main__":
    run_tests.main()
