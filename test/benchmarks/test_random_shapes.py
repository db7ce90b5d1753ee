#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the random shapes: test_random_shapes.py PATH/pcl_simulate_indoor_scan"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from buildings import overhead
from buildings.shaped import PLANS, build

SIMULATOR = sys.argv.pop(1) if len(sys.argv) > 1 else None
SEEDS = (2, 7, 11, 29, 37, 40)  # an L, a slope, round, a cone, two rooms and a step, a roof


class Shapes(unittest.TestCase):
    def test_are_the_same_for_the_same_seed(self):
        self.assertEqual(json.dumps(build(5)), json.dumps(build(5)))
        self.assertNotEqual(json.dumps(build(5)), json.dumps(build(6)))

    def test_are_of_every_kind(self):
        words = {w for seed in range(1, 121) for w in build(seed)["summary"].split()}
        self.assertEqual(words, set(PLANS) | set(overhead.CEILINGS) | {"tilted", "furnished"})

    @unittest.skipUnless(SIMULATOR, "needs the simulator")
    def test_can_be_simulated(self):
        for seed in SEEDS:
            scene = build(seed)
            with tempfile.TemporaryDirectory() as name:
                file = pathlib.Path(name) / "scene.json"
                file.write_text(json.dumps(scene), encoding="utf-8")
                done = subprocess.run([SIMULATOR, file, name, "--rays", "50"], capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, f"{scene['name']}: {done.stderr}")
                truth = json.loads((pathlib.Path(name) / "truth.json").read_text(encoding="utf-8"))
            self.assertEqual(len(truth["rooms"]), len(scene["rooms"]))


if __name__ == "__main__":
    unittest.main()
