#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints what matters first of the report of a run: rooms.py OUTPUT_DIR"""
import json
import sys

with open(sys.argv[1] + "/report.json") as file:
    report = json.load(file)
for room in report["rooms"]:
    print(f"room {room['id']}: {room['area']:.2f} m2, {room['walls']} walls, "
          f"{100 * room['support']['measured']:.0f} % of them measured")
for doubt in report["doubts"][:10]:
    print(doubt["text"])
