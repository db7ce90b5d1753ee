#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""GLB files in the validator of Khronos and in three.js. Skipped where node finds neither (npm install
gltf-validator three; NODE_PATH says where).

    test_glb_in_node.py pcl_floorplan_extrusion
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "ifc"))
from ifc_samples import house, rectangle, room, slab  # noqa: E402

EXTRUSION = sys.argv[1]
NODE = shutil.which("node") or shutil.which("nodejs")
if NODE is None or subprocess.run([NODE, "-e", "require('gltf-validator'); require.resolve('three')"],
                                  capture_output=True).returncode:
    print("skipped: node finds no gltf-validator or no three (npm install, and NODE_PATH)")
    sys.exit(77)


class GlbInNode(unittest.TestCase):
    def opened(self, plan):
        with tempfile.TemporaryDirectory() as folder:
            source, path = os.path.join(folder, "plan.json"), os.path.join(folder, "model.glb")
            with open(source, "w") as file:
                json.dump(plan, file)
            subprocess.run([EXTRUSION, source, path], check=True, capture_output=True)
            result = subprocess.run([NODE, os.path.join(HERE, "glb_in_node.mjs"), path], capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stderr)
            return json.loads(result.stdout)

    def test_without_a_message(self):
        found = self.opened(house())
        self.assertEqual([found["issues"][k] for k in ("numErrors", "numWarnings", "numInfos")], [0, 0, 0], found["issues"])
        self.assertEqual(found["said"], [])
        rooms = {m["name"].split("_")[1] for m in found["meshes"]}
        self.assertEqual(rooms, set("12345"))

    def test_places_are_those_of_the_plan_with_y_up(self):
        plan = {"format": "sedr-floorplan", "version": 1, "unit": "m",
                "rooms": [room(1, rectangle(1, 2, 5, 4), slab(0.5), slab(3))]}
        meshes = self.opened(plan)["meshes"]
        low = [min(m["low"][k] for m in meshes) for k in range(3)]
        high = [max(m["high"][k] for m in meshes) for k in range(3)]
        for found, expected in zip(low + high, [1, 0.5, -4, 5, 3, -2]):
            self.assertAlmostEqual(found, expected, 5)
        self.assertEqual({m["material"] for m in meshes}, {"ceiling", "floor", "wall"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
