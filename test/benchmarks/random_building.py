#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a random building as a scene for pcl_simulate_indoor_scan: random_building.py SEED OUT.json [--kind KIND]

Same seed and kind, same building. Without a kind the seed chooses one. Needs Python 3.8 and shapely.
"""
import argparse
import json
import pathlib
import sys

from buildings.build import build
from buildings.kinds import KINDS


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seed", type=int)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--kind", choices=sorted(KINDS))
    arguments = parser.parse_args()
    try:
        arguments.output.write_text(json.dumps(build(arguments.seed, arguments.kind)) + "\n", encoding="utf-8")
    except OSError as error:
        sys.exit(f"random_building.py: cannot write {arguments.output}: {error.strerror}")


if __name__ == "__main__":
    main()
