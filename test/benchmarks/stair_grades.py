#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares flights of stairs with those of random buildings: stair_grades.py SCENE_DIR=PLAN.json ...

PLAN.json is floorplan.json or the building of pcl_room_segmentation. Of each true flight: steps too many, direction off in
degrees, width, bottom and top off in centimetres; then those invented, and links without a flight.
"""
import json
import sys

import numpy as np

from buildings.grades import flight_errors, found_flights, pair_flights, true_flights


def main(arguments):
    errors, missed, invented, bare = [], 0, 0, 0
    for folder, path in (a.split("=") for a in arguments):
        with open(path, encoding="utf-8") as file:
            plan = json.load(file)
        true, found = true_flights(folder), found_flights(plan)
        pairs = pair_flights(true, found)
        for t, k in zip(true, pairs):
            what = "missed"
            if k is not None:
                errors.append(flight_errors(t, found[k]))
                what = "  ".join(f"{name} {value:+.1f}" for name, value in errors[-1].items())
            print(f"{folder}: {t['steps']} steps to {t['top']:.2f}: {what}")
        missed += pairs.count(None)
        for f in [f for k, f in enumerate(found) if k not in pairs]:
            print(f"{folder}: invented, {f['steps']} steps from {f['bottom']:.2f} to {f['top']:.2f} at {np.mean(f['risers'], axis=(0, 1)).round(2)}")
            invented += 1
        for s in [s for s in plan.get("stairs", []) if not s.get("flights")]:
            print(f"{folder}: a link from {s['bottom']:.2f} to {s['top']:.2f} at {s['at']} without a flight")
            bare += 1
    right = sum(e["steps"] == 0 for e in errors)
    print(f"{len(errors) + missed} flights, {missed} missed, {right} with all steps, {invented} invented, {bare} links without a flight")
    for name in errors[0] if errors else []:
        values = np.abs([e[name] for e in errors])
        print(f"{name}: median {np.median(values):.1f}, mean {values.mean():.1f}, most {values.max():.1f}")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (OSError, ValueError) as error:
        sys.exit(f"stair_grades.py: {error}")
