#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What pcl_sedr costs on generated buildings, up to the floor plan, as CSV.

    test/benchmarks/building_costs.py OUT.csv [--millions 10 30 100] [--threads 0] [--runs 1]

Each building is made by pcl_simulate_indoor_scan, read by pcl_sedr --no-mesh and deleted
again: 300 million points take 4.8 GB of the disk. A row has the points, the rooms, the
seconds of the whole program and of each stage, and the most memory in MiB. Rows are
written as they come. The programs are looked for in --bin (build/release/bin).
"""
import argparse
import csv
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--millions", type=float, nargs="+", default=[10, 30, 100],
                        help="points of the buildings, millions")
    parser.add_argument("--scene", default="syn_flat", help="what the buildings repeat")
    parser.add_argument("--rays", type=int, help="rays a scanner position of the scene")
    parser.add_argument("--threads", type=int, default=0, help="0: all processors")
    parser.add_argument("--runs", type=int, default=1, help="runs of each building")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--folder", type=pathlib.Path,
                        help="where the scans go while they are needed")
    return parser.parse_args()


def run(command):
    """Seconds and peak memory (MiB) of a program that must not fail."""
    start = time.monotonic()
    process = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.monotonic() - start
    if status != 0:
        sys.exit(f"{command[0]} failed")
    return seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def write_copies(path, points):
    """Makes a storey of a scan: copies side by side, some `points` in all."""
    scan = path.read_bytes()
    begin = scan.index(b"DATA binary\n") + 12
    row = np.dtype([("xyz", "<f4", 3), ("label", "<u4"), ("room", "<u4")])
    rows = np.frombuffer(scan, row, offset=begin)
    rows = rows[rows["room"] > 0]  # without what is outside
    pitch = np.append(np.ptp(rows["xyz"][:, :2], axis=0) + 0.3, 0)  # 30 cm of wall between
    copies = max(1, round(points / len(rows)))
    in_row = max(1, round((copies * pitch[1] / pitch[0]) ** 0.5))
    header = re.sub(rb"(WIDTH|POINTS) \d+", rb"\1 %d" % (copies * len(rows)), scan[:begin])
    with path.open("wb") as file:
        file.write(header)
        for copy in range(copies):
            moved = rows.copy()
            moved["xyz"] += (pitch * [copy % in_row, copy // in_row, 0]).astype("<f4")
            moved["room"] += copy * rows["room"].max()
            file.write(moved.tobytes())


def main():
    options = arguments()
    columns = None
    with options.out.open("w", newline="") as out, \
            tempfile.TemporaryDirectory(dir=options.folder) as folder:
        folder = pathlib.Path(folder)
        for millions in options.millions:
            make = [options.bin / "pcl_simulate_indoor_scan", options.scene, folder]
            if options.rays:
                make += ["--rays", options.rays]
            run(make)
            write_copies(folder / "scan.pcd", int(millions * 1e6))
            for _ in range(options.runs):
                seconds, processor, memory = run(
                    [options.bin / "pcl_sedr", folder / "scan.pcd", folder / "model",
                     "--no-mesh", "--threads", options.threads])
                report = json.loads((folder / "model/report.json").read_text())
                row = {"points": report["input"]["points"],
                       "bytes": (folder / "scan.pcd").stat().st_size,
                       "rooms": len(report["rooms"]), "seconds": f"{seconds:.3f}",
                       "processor_seconds": f"{processor:.3f}",
                       "peak_mib": f"{memory:.0f}"}
                for stage in report["stages"]:
                    row[stage["stage"]] = f"{stage['seconds']:.3f}"
                    if stage["stage"] == "ParallelVoxelGrid":
                        row["voxels"] = stage["points_out"]
                if columns is None:
                    columns = csv.DictWriter(out, row.keys(), restval="",
                                             extrasaction="ignore")
                    columns.writeheader()
                columns.writerow(row)
                out.flush()
            (folder / "scan.pcd").unlink()


if __name__ == "__main__":
    main()
